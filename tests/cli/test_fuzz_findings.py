"""Files that tools/fuzz came upon: PCL's readers abort on them, or read what is not there."""

from __future__ import annotations

import re
import struct

import cloud_files
import numpy as np
import pytest

POINTS = np.random.default_rng(8).uniform(-1, 1, (40, 3)).astype("f4")
ROWS = cloud_files.table(POINTS)


@pytest.fixture
def bad(refused, tmp_path):
    """The file of this content is refused as source, in words that have the pattern."""
    cloud_files.write_pcd(tmp_path / "good.pcd", POINTS)

    def call(name: str, content: bytes, pattern: str) -> None:
        (tmp_path / name).write_bytes(content)
        message = refused(2, name, "good.pcd", "-o", "T.txt")
        assert f"'{name}': " in message
        assert re.search(pattern, message), message

    return call


def ply(tmp_path, data: str) -> tuple[bytes, bytes]:
    """Header without its last line, and body."""
    whole = cloud_files.write_ply(tmp_path / "whole.ply", ROWS, data).read_bytes()
    header, body = whole.split(b"end_header\n", 1)
    return header, body


@pytest.mark.parametrize("second", ["WIDTH 40", "FIELDS x y z", "COLUMNS x y z", "SIZE 8 8 8"])
def test_second_line_of_a_pcd_header(bad, second):
    header = cloud_files.pcd_header(ROWS, "binary").replace("DATA", second + "\nDATA")
    keyword = second.split()[0]
    bad("twice.pcd", header.encode() + ROWS.tobytes(), f"a second line '{keyword}'")


@pytest.mark.parametrize("blanks", ["\r", " ", "\t "])
@pytest.mark.parametrize("before", ["VERSION", "WIDTH", "DATA"])
@pytest.mark.parametrize("data", ["ascii", "binary"])
def test_line_of_blanks_in_a_pcd_header(bad, blanks, before, data):
    header = cloud_files.pcd_header(ROWS, data).replace(before, f"{blanks}\n{before}")
    body = ROWS.tobytes() if data == "binary" else b"0 0 0\n" * len(POINTS)
    bad("blank.pcd", header.encode() + body, "a line of blanks, at which PCL would end it")


@pytest.mark.parametrize("begin", ["", "\n", "# a comment\n", " #\n\n\t"])
@pytest.mark.parametrize("line", ["WIDTH 4000000", "FIELDS a b c", "DATA ascii"])
def test_header_lines_where_a_binary_pcd_has_its_points(bad, begin, line):
    body = bytearray(ROWS.tobytes())
    text = f"{begin}{line}\n".encode()
    body[: len(text)] = text
    header = cloud_files.pcd_header(ROWS, "binary").encode()
    bad("body.pcd", header + bytes(body), f"begin with a line '{line.split()[0]}'")


def test_binary_pcd_may_begin_with_the_byte_of_a_comment(run, tmp_path):
    body = bytearray(ROWS.tobytes())
    body[:4] = b"#\x00\x80\x3f"  # a float a little above 1
    (tmp_path / "a.pcd").write_bytes(cloud_files.pcd_header(ROWS, "binary").encode() + bytes(body))
    done = run("a.pcd", "a.pcd", "-o", "T.txt", "--iterations", "1", "--population", "2")
    assert done.returncode in (0, 3), done.stderr


def test_a_field_named_like_a_line_of_the_header_is_written_whole(run, tmp_path):
    header = cloud_files.pcd_header(ROWS, "ascii").splitlines()
    for row, more in (("FIELDS", " aVIEWPOINTb"), ("SIZE", " 4"), ("TYPE", " F"), ("COUNT", " 1")):
        header = [line + more if line.startswith(row) else line for line in header]
    body = [" ".join(str(v) for v in (*row, 7)) for row in POINTS.tolist()]
    (tmp_path / "a.pcd").write_text("\n".join([*header, *body, ""]))
    few = ("--iterations", "1", "--population", "2")
    done = run("a.pcd", "a.pcd", "-o", "T.txt", "--aligned", "b.pcd", *few)
    assert done.returncode in (0, 3), done.stderr
    assert b"FIELDS x y z aVIEWPOINTb\n" in (tmp_path / "b.pcd").read_bytes()
    done = run("b.pcd", "a.pcd", "-o", "T.txt", *few)
    assert done.returncode in (0, 3), done.stderr


@pytest.mark.parametrize("lines", [
    "obj_info num_cols 3\nobj_info num_rows 3\n", "obj_info num_cols 41\nobj_info num_rows 1\n",
    "obj_info num_cols 10\n"])  # fmt: skip
@pytest.mark.parametrize("data", ["ascii", "binary"])
def test_ply_that_lays_out_other_points_than_it_has(bad, tmp_path, lines, data):
    header, body = ply(tmp_path, data)
    header = header.replace(b"element", lines.encode() + b"element", 1)
    bad("layout.ply", header + b"end_header\n" + body, "obj_info lays out .* but it has 40")


@pytest.mark.parametrize("value", ["0", "-4", "many", "1e3", str(2**40)])
def test_ply_layout_that_is_no_count(bad, tmp_path, value):
    header, body = ply(tmp_path, "ascii")
    header = header.replace(b"element", f"obj_info num_cols {value}\nelement".encode(), 1)
    bad("layout.ply", header + b"end_header\n" + body, "num_cols without a count")


def test_ply_obj_info_behind_a_blank(bad, tmp_path):
    header, body = ply(tmp_path, "ascii")
    header = header.replace(b"comment", b" obj_info", 1)
    bad("blank.ply", header + b"end_header\n" + body, "'obj_info' that begins with a blank")


def with_grid(tmp_path, data: str, indices: list[list[int]]) -> bytes:
    """A cloud laid out over a grid, each place with the number of its vertex or empty."""
    header, body = ply(tmp_path, data)
    header = header.replace(
        b"element", f"obj_info num_cols {len(indices)}\nobj_info num_rows 1\nelement".encode(), 1
    )
    grid = f"element range_grid {len(indices)}\nproperty list uchar int vertex_indices\n"
    if data == "ascii":
        rows = "".join(" ".join(map(str, [len(row), *row])) + "\n" for row in indices).encode()
    else:
        order = ">" if data == "big" else "<"
        rows = b"".join(struct.pack(f"{order}B{len(row)}i", len(row), *row) for row in indices)
    return cloud_files.with_element(header + b"end_header\n" + body, grid, rows)


@pytest.mark.parametrize("data", ["ascii", "binary", "big"])
def test_ply_grid_with_fewer_places_than_vertices(bad, tmp_path, data):
    places = [[i] for i in range(39)]
    bad("grid.ply", with_grid(tmp_path, data, places), "lays out .* = 39 points, but it has 40")


@pytest.mark.parametrize("data", ["ascii", "binary", "big"])
@pytest.mark.parametrize("index", [-1, 40, 2**31 - 1])
def test_ply_grid_of_vertices_that_are_not_there(bad, tmp_path, data, index):
    places = [[i] for i in range(40)] + [[], [index]]
    bad("grid.ply", with_grid(tmp_path, data, places), "range_grid 42 names vertex")


@pytest.mark.parametrize("data", ["ascii", "binary", "big"])
def test_ply_grid_with_empty_places_is_read(run, tmp_path, data):
    places: list[list[int]] = [[i] if i % 2 else [] for i in range(40)] + [[0], [2]]
    (tmp_path / "grid.ply").write_bytes(with_grid(tmp_path, data, places))
    done = run("grid.ply", "grid.ply", "-o", "T.txt", "--iterations", "1", "--population", "2")
    assert done.returncode in (0, 3), done.stderr
    assert "42 points" in done.stderr


def test_ply_element_without_properties(bad, tmp_path):
    header, body = ply(tmp_path, "ascii")
    header += b"element nothing 4000000000\n"
    bad("nothing.ply", header + b"end_header\n" + body, "element 'nothing' no properties")
