"""The fused cloud: averages by voxel, part by part."""

from __future__ import annotations

import io

import numpy as np
import pytest

from pyemtr.multiway.colors import Rows, rows_of
from pyemtr.multiway.fuse import fuse
from pyemtr.multiway.output import ply_bytes


def parts(seed: int, count: int = 3) -> list[Rows]:
    rng = np.random.default_rng(seed)
    made = []
    for _ in range(count):
        points = rng.uniform(-1, 1, (400, 3)) + [1e6, 0, 0]
        normals = np.tile([0.0, 0.0, 1.0], (400, 1)) * rng.choice([-1.0, 1.0], (400, 1))
        made.append(Rows(points, normals, rng.random((400, 3))))
    return made


def test_each_voxel_has_the_average_of_its_points() -> None:
    given = parts(1)
    cloud = fuse(given, 0.5)
    points = np.concatenate([part.points for part in given])
    colors = np.concatenate([part.colors for part in given])
    cells = np.floor((points - given[0].points[0]) / 0.5).astype(int)
    wanted = {}
    for cell in {tuple(cell) for cell in cells}:
        inside = (cells == cell).all(axis=1)
        wanted[cell] = points[inside].mean(axis=0), colors[inside].mean(axis=0), inside.sum()
    assert len(cloud.points) == len(wanted) and cloud.counts.sum() == 1200
    for point, color, count in zip(cloud.points, cloud.colors, cloud.counts):
        cell = tuple(np.floor((point - given[0].points[0]) / 0.5).astype(int))
        np.testing.assert_allclose(point, wanted[cell][0], rtol=1e-12)
        np.testing.assert_allclose(color, wanted[cell][1], atol=1e-12)
        assert count == wanted[cell][2]


def test_normals_of_either_side_do_not_cancel() -> None:
    cloud = fuse(parts(2), 0.5)
    np.testing.assert_allclose(np.abs(cloud.normals[:, 2]), 1.0, atol=1e-12)


def test_what_one_scan_lacks_the_cloud_lacks() -> None:
    first, second, _ = parts(3)
    cloud = fuse([first, Rows(second.points, None, second.colors)], 0.5)
    assert cloud.normals is None and cloud.colors is not None


def test_a_voxel_that_is_too_small_is_an_error() -> None:
    with pytest.raises(ValueError, match=r"voxel: 1e-09 is too small"):
        fuse(parts(1), 1e-9)


def test_columns_and_attributes_come_along() -> None:
    table = np.zeros(3, dtype=[(n, "f4") for n in ("x", "y", "z", "nx", "ny", "nz")]
                     + [(n, "u1") for n in ("red", "green", "blue")])  # fmt: skip
    table["x"], table["nz"], table["red"] = [1, np.nan, 3], 1, 255
    points = np.column_stack([table[axis] for axis in "xyz"])
    rows = rows_of(table, points, "cloud")
    assert rows.points[:, 0].tolist() == [1, 3] and rows.normals.tolist() == [[0, 0, 1]] * 2
    assert rows.colors.tolist() == [[1, 0, 0]] * 2

    class Cloud:
        colors = np.full((2, 3), 0.5)
        normals = np.zeros((0, 3))

    rows = rows_of(Cloud(), np.zeros((2, 3)), "cloud")
    assert rows.normals is None and rows.colors.tolist() == [[0.5] * 3] * 2
    with pytest.raises(ValueError, match=r"cloud: colors: expected 4 rows, got 2"):
        rows_of(Cloud(), np.zeros((4, 3)), "cloud")


def test_the_file_reads_back() -> None:
    plyfile = pytest.importorskip("plyfile", reason="plyfile is not installed")
    cloud = fuse(parts(4), 0.5)
    vertex = plyfile.PlyData.read(io.BytesIO(ply_bytes(cloud)))["vertex"].data
    assert np.array_equal(np.column_stack([vertex[axis] for axis in "xyz"]), cloud.points)
    assert np.array_equal(vertex["red"], np.rint(255 * cloud.colors[:, 0]))
    assert np.abs(vertex["nz"]) == pytest.approx(1.0)
