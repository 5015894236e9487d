"""Every format that is read gives the same cloud, so the same bits."""

from __future__ import annotations

import cloud_files
import numpy as np
import pytest
from conftest import QUICK

POINTS = np.random.default_rng(5).uniform(-1, 1, (240, 3)).astype("f4")


@pytest.fixture
def reference(run, tmp_path) -> str:
    cloud_files.write_pcd(tmp_path / "reference.pcd", POINTS)
    return run("reference.pcd", "reference.pcd", *QUICK).stdout


@pytest.mark.parametrize(
    ("extension", "options"),
    [
        (".pcd", {"data": "ascii"}),
        (".pcd", {"data": "binary"}),
        (".pcd", {"data": "binary_compressed"}),
        (".ply", {"data": "ascii"}),
        (".ply", {"data": "binary"}),
        (".ply", {"data": "big"}),
        (".ply", {"data": "ascii", "faces": True}),
        (".ply", {"data": "binary", "faces": True}),
        (".obj", {}),
        (".obj", {"normals": POINTS}),
    ],
)
def test_same_cloud_in_every_format(run, tmp_path, reference, extension, options):
    path = cloud_files.WRITERS[extension](tmp_path / f"cloud{extension}", POINTS, **options)
    done = run(path, path, *QUICK)
    assert done.stdout == reference
    assert f"Loading {path} [done, " in done.stderr
    assert " ms : 240 points]" in done.stderr


@pytest.mark.parametrize("name", ["A.PCD", "a.Pcd", "A.PLY", "a.pLy", "A.OBJ", "a.Obj"])
def test_letter_case_of_the_extension(run, tmp_path, reference, name):
    path = tmp_path / name
    cloud_files.WRITERS[path.suffix.lower()](path, POINTS)
    assert run(path, path, *QUICK).stdout == reference


@pytest.mark.parametrize("extension", [".pcd", ".ply"])
def test_double_coordinates_keep_their_digits(run, tmp_path, pair, extension):
    """A million meters from the origin, float has lost the shape's centimeters."""
    far = np.array([4.5e6, 5.3e6, 1e3])
    write = cloud_files.WRITERS[extension]
    write(tmp_path / f"a{extension}", cloud_files.table(pair.source * 0.01 + far, "f8"))
    write(tmp_path / f"b{extension}", cloud_files.table(pair.target * 0.01 + far, "f8"))
    done = run(f"a{extension}", f"b{extension}", "--threads", "2")
    assert done.returncode == 0, done.stderr
    found = np.array(done.stdout.split(), float).reshape(4, 4)
    moved = (found[:3, :3] @ far + found[:3, 3] - far) / 0.01  # back to the pair's own frame
    found[:3, 3] = moved
    angle, distance = pair.error(found)
    assert angle < 5 and distance < 0.1


@pytest.mark.parametrize("layout", ["z y x", "x rgb y z"])
def test_coordinates_need_not_lie_side_by_side(run, tmp_path, reference, layout):
    rows = np.zeros(len(POINTS), [(name, "f4") for name in layout.split()])
    for name, values in zip("xyz", POINTS.T, strict=True):
        rows[name] = values
    cloud_files.write_pcd(tmp_path / "odd.pcd", rows)
    assert run("odd.pcd", "odd.pcd", *QUICK).stdout == reference


def test_points_without_a_place_are_dropped_and_counted(run, tmp_path, reference):
    holes = np.insert(
        POINTS, [0, 20, 240], [[np.nan, 0, 0], [0, np.inf, 0], [0, 0, -np.inf]], axis=0
    )
    cloud_files.write_pcd(tmp_path / "holes.pcd", holes)
    done = run("holes.pcd", "holes.pcd", *QUICK)
    assert done.stdout == reference
    assert done.stderr.count("240 finite points, 3 dropped") == 2
    cloud_files.write_ply(tmp_path / "text.ply", holes, data="ascii")
    assert run("text.ply", "text.ply", *QUICK).stdout == reference


def test_organised_cloud(run, tmp_path, reference):
    cloud_files.write_pcd(tmp_path / "grid.pcd", POINTS, width=20, height=12)
    assert run("grid.pcd", "grid.pcd", *QUICK).stdout == reference


def test_windows_line_ends(run, tmp_path, reference):
    for extension in (".pcd", ".ply"):
        path = cloud_files.WRITERS[extension](tmp_path / f"crlf{extension}", POINTS, data="ascii")
        path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
        assert run(path, path, *QUICK).stdout == reference


def test_obj_of_windows_with_empty_lines_and_tabs(run, tmp_path, reference):
    path = cloud_files.write_obj(tmp_path / "crlf.obj", POINTS)
    whole = path.read_bytes().replace(b"\nv ", b"\n \t\n\nv\t").replace(b"\n", b"\r\n")
    path.write_bytes(b"\r\n" + whole)
    assert run(path, path, *QUICK).stdout == reference


def write_range_grid(path, points, grid: list[int | None], info: str) -> None:
    """A range scan as the Stanford scanner wrote it: a grid of vertices, some places empty."""
    lines = [
        "ply",
        "format ascii 1.0",
        *info.splitlines(),
        f"element vertex {len(points)}",
        "property float x",
        "property float y",
        "property float z",
        f"element range_grid {len(grid)}",
        "property list uchar int vertex_indices",
        "end_header",
    ]
    lines += [f"{x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += ["0" if place is None else f"1 {place}" for place in grid]
    path.write_text("\n".join(lines) + "\n")


def test_range_grid(run, refused, tmp_path, reference):
    grid = [place for i in range(len(POINTS)) for place in ((i, None) if i % 4 == 0 else (i,))]
    write_range_grid(
        tmp_path / "grid.ply", POINTS, grid, "obj_info num_cols 30\nobj_info num_rows 10"
    )
    done = run("grid.ply", "grid.ply", *QUICK)
    assert done.stdout == reference
    assert "240 finite points, 60 dropped" in done.stderr
    for info in ("", "obj_info num_cols 30\nobj_info num_rows 9"):
        write_range_grid(tmp_path / "odd.ply", POINTS, grid, info)
        assert "'odd.ply': cannot be read" in refused(2, "odd.ply", "odd.ply")
