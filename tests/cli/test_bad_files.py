"""Whatever is wrong with a file is told in one line that names it; PCL's silence is not ours."""

from __future__ import annotations

import os
import re

import cloud_files
import numpy as np
import pytest

POINTS = np.random.default_rng(6).uniform(-1, 1, (40, 3)).astype("f4")
ROWS = cloud_files.table(POINTS)


@pytest.fixture
def bad(refused, tmp_path):
    """Both as source and as target the file is refused, and the message has the pattern."""
    cloud_files.write_pcd(tmp_path / "good.pcd", POINTS)

    def call(name: str, pattern: str, content: bytes | None = None) -> None:
        if content is not None:
            (tmp_path / name).write_bytes(content)
        for clouds in ([name, "good.pcd"], ["good.pcd", name]):
            message = refused(2, *clouds, "-o", "T.txt", "--report", "r.json")
            assert f"'{name}': " in message
            assert re.search(pattern, message), message

    return call


def content(tmp_path, extension: str, **options) -> bytes:
    return cloud_files.WRITERS[extension](
        tmp_path / f"whole{extension}", POINTS, **options
    ).read_bytes()


def test_missing_empty_directory_extension(bad, tmp_path):
    bad("none.pcd", "no such file")
    bad("empty.pcd", "is empty", b"")
    bad("empty.ply", "is empty", b"")
    (tmp_path / "folder.pcd").mkdir()
    bad("folder.pcd", "is a directory")
    every = r"expected .pcd, .ply, .obj, .npy, .*.csv or .pts, or --input-format"
    bad("cloud.dwg", "unknown extension '.dwg', " + every, b"0 0 0\n")
    bad("cloud", "has no extension, " + every, b"0 0 0\n")


@pytest.mark.skipif(os.geteuid() == 0, reason="root reads every file")
def test_unreadable(bad, tmp_path):
    cloud_files.write_pcd(tmp_path / "locked.pcd", POINTS).chmod(0)
    bad("locked.pcd", "Permission denied")


@pytest.mark.parametrize(
    ("name", "source"),
    [
        ("ply.pcd", ".ply"),
        ("obj.pcd", ".obj"),
        ("pcd.ply", ".pcd"),
        ("obj.ply", ".obj"),
        ("pcd.obj", ".pcd"),
        ("ply.obj", ".ply"),
    ],
)
def test_extension_that_lies(bad, tmp_path, name, source):
    bad(name, "not a PCD file|not a PLY file|holds no points", content(tmp_path, source))


def test_bytes_without_meaning(bad):
    for name in ("noise.pcd", "noise.ply", "noise.obj"):
        bad(name, "not a|holds no points|unknown line", bytes(range(256)) * 20)


@pytest.mark.parametrize(
    ("extension", "data"),
    [
        (".pcd", "ascii"),
        (".pcd", "binary"),
        (".pcd", "binary_compressed"),
        (".ply", "ascii"),
        (".ply", "binary"),
        (".ply", "big"),
    ],
)
@pytest.mark.parametrize("share", [0.05, 0.5, 0.8, 0.99])
def test_truncated(bad, tmp_path, extension, data, share):
    whole = content(tmp_path, extension, data=data)
    bad(f"cut{extension}", "truncated|has no|not a", whole[: int(share * len(whole))])


@pytest.mark.parametrize("data", ["ascii", "binary"])
def test_truncated_behind_the_vertices(bad, tmp_path, data):
    whole = content(tmp_path, ".ply", data=data, faces=True)
    bad("cut.ply", "truncated", whole[:-8])


@pytest.mark.parametrize("count", [10**9, 4 * 10**9, 10**30])
@pytest.mark.parametrize("data", ["ascii", "binary", "binary_compressed"])
def test_huge_count_is_refused_before_memory_is_asked_for(bad, tmp_path, count, data):
    whole = content(tmp_path, ".pcd", data=data).replace(b" 40\n", f" {count}\n".encode())
    bad("huge.pcd", "truncated|WIDTH|damaged|more than", whole)
    if data != "binary_compressed":
        whole = content(tmp_path, ".ply", data=data).replace(b" 40\n", f" {count}\n".encode())
        bad("huge.ply", "truncated|count from", whole)


def test_compressed_part_that_does_not_fit_its_header(bad, tmp_path):
    whole = content(tmp_path, ".pcd", data="binary_compressed")
    at = whole.index(b"DATA binary_compressed\n") + 23
    bad(
        "size.pcd",
        "unpacks to 479 bytes, its header declares 480",
        whole[: at + 4] + (479).to_bytes(4, "little") + whole[at + 8 :],
    )
    bad("noise.pcd", "cannot be read", whole[: at + 8] + b"\xff" * (len(whole) - at - 8))


@pytest.mark.parametrize("extension", [".pcd", ".ply"])
def test_text_that_is_no_number(bad, tmp_path, extension):
    whole = content(tmp_path, extension, data="ascii").decode()
    word = whole.split()[-1]
    bad(f"word{extension}", "40 of 40: 'abc' is not a number", whole.replace(word, "abc").encode())
    bad(f"comma{extension}", "is not a number", whole.replace("0.", "0,").encode())
    bad(
        f"short{extension}",
        "40 of 40 has 2 values, expected 3",
        whole.replace(" " + word, "").encode(),
    )
    bad(f"more{extension}", "holds more than the 40", (whole + "1 2 3\n").encode())


def test_obj_that_is_none(bad, tmp_path):
    whole = content(tmp_path, ".obj").decode()
    bad(
        "word.obj",
        "line 3: 'abc' is not a number",
        whole.replace(whole.splitlines()[2], "v 1 abc 2").encode(),
    )
    bad(
        "short.obj",
        "line 3 has 2 coordinates",
        whole.replace(whole.splitlines()[2], "v 1 2").encode(),
    )
    bad("faces.obj", "holds no points", b"f 1 2 3\n")


def test_no_points(bad):
    bad("none.pcd", "holds no points", cloud_files.pcd_header(ROWS[:0], "ascii").encode())
    bad(
        "none.ply",
        "holds no points",
        b"ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n",
    )
    bad(
        "faces.ply",
        "holds no points",
        b"ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
        b"end_header\n3 0 1 2\n",
    )


@pytest.mark.parametrize(
    ("old", "new", "pattern"),
    [
        ("FIELDS x", "FIELDS a", "has no field 'x', only a, y, z"),
        ("FIELDS x y z", "FIELDS x y", "2 FIELDS, but 3 SIZE"),
        ("TYPE F F F", "TYPE U F F", "x, y and z to be all float or all double"),
        ("TYPE F", "TYPE Q", "field 'x' type Q of size 4"),
        ("SIZE 4", "SIZE 3", "field 'x' type F of size 3"),
        ("SIZE 4 4 4\n", "", "no SIZE"),
        ("COUNT 1", "COUNT 0", "field 'x' COUNT 0"),
        ("WIDTH 40", "WIDTH -40", "WIDTH '-40'"),
        ("POINTS 40", "POINTS 41", "POINTS 41, but WIDTH x HEIGHT is 40"),
        ("0 0 0 1 0 0 0", "0 0 0 1", "VIEWPOINT"),
        (
            "DATA binary",
            "DATA zipped",
            "DATA 'zipped', expected ascii, binary or binary_compressed",
        ),
        ("WIDTH", "BREADTH", "unknown line 'BREADTH'"),
    ],
)
def test_pcd_headers(bad, old, new, pattern):
    header = cloud_files.pcd_header(ROWS, "binary")
    assert old in header
    bad("header.pcd", pattern, header.replace(old, new).encode() + ROWS.tobytes())


@pytest.mark.parametrize(
    ("old", "new", "pattern"),
    [
        ("property float x", "property float a", "has no field 'x', only a, y, z"),
        ("property float x", "property int x", "x, y and z to be all float or all double"),
        ("property float x", "property real x", "unknown type 'real'"),
        ("property float z", "property list uchar float z", "list 'z', expected single values"),
        ("binary_little_endian 1.0", "binary 1.0", "unknown format"),
        ("vertex 40", "vertex forty", "element without a name and a count"),
        ("comment", "remark", "unknown line 'remark'"),
        ("end_header", "", "no line 'end_header'|unknown line"),
    ],
)
def test_ply_headers(bad, tmp_path, old, new, pattern):
    whole = content(tmp_path, ".ply")
    assert old.encode() in whole
    bad("header.ply", pattern, whole.replace(old.encode(), new.encode(), 1))


@pytest.mark.parametrize("order", ["blue green red", "red green", "red ring green blue", "alpha"])
def test_ply_colors_that_pcl_takes_for_others(bad, tmp_path, order):
    fields = {name: np.arange(40, dtype="u1") for name in order.split()}
    cloud_files.write_ply(tmp_path / "c.ply", cloud_files.table(POINTS, **fields))
    bad("c.ply", "expected uchar red, green, blue and perhaps alpha")


def test_clouds_that_cannot_be_registered(bad, tmp_path):
    line = np.linspace(0, 1, 40)[:, None] * [[1.0, 2.0, 3.0]]
    gaps = np.full((40, 3), np.nan)
    gaps[:9] = POINTS[:9]
    for name, points, pattern in [
        ("few.pcd", POINTS[:9], "9 finite points of 9, expected"),
        ("gaps.pcd", gaps, "9 finite points of 40"),
        ("equal.pcd", np.full((40, 3), 2.5), "all points are equal"),
        ("line.pcd", line, "on one line"),
    ]:
        cloud_files.write_pcd(tmp_path / name, points)
        bad(name, pattern)
