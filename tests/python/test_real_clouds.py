"""Clouds of the libraries themselves, where they are installed: test_points.py has their likes."""

from __future__ import annotations

import numpy as np
import pytest

from pyemtr.points import as_points

POINTS = np.random.default_rng(6).normal(size=(60, 3))


def test_open3d() -> None:
    o3d = pytest.importorskip("open3d", reason="Open3D is not installed")
    vectors = o3d.utility.Vector3dVector(POINTS)
    assert np.array_equal(as_points(o3d.geometry.PointCloud(vectors), "source"), POINTS)
    tensor = o3d.core.Tensor(POINTS)
    assert np.array_equal(as_points(tensor, "source"), POINTS)
    assert np.array_equal(as_points(o3d.t.geometry.PointCloud(tensor), "source"), POINTS)
    box = o3d.geometry.TriangleMesh.create_box(1, 2, 3)
    for mesh in (box, o3d.t.geometry.TriangleMesh.from_legacy(box)):
        assert len(as_points(mesh, "source", 500)) == 500
    bare = o3d.geometry.TriangleMesh(vectors, o3d.utility.Vector3iVector())
    for mesh in (bare, o3d.t.geometry.TriangleMesh.from_legacy(bare)):
        np.testing.assert_allclose(as_points(mesh, "source"), POINTS, atol=1e-6)


def test_trimesh() -> None:
    trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed")
    assert np.array_equal(as_points(trimesh.PointCloud(POINTS), "source"), POINTS)
    box = trimesh.creation.box((1, 2, 3))
    points = as_points(box, "source", 500)
    assert len(points) == 500 and np.allclose(abs(points).max(axis=0), [0.5, 1, 1.5], atol=0.1)
    assert np.array_equal(as_points(trimesh.Scene([box]), "source", 500), points)


def test_small_gicp() -> None:
    small_gicp = pytest.importorskip("small_gicp", reason="small_gicp is not installed")
    assert np.array_equal(as_points(small_gicp.PointCloud(POINTS), "source"), POINTS)


def test_pandas() -> None:
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    table = pandas.DataFrame({"label": 7, "Z": POINTS[:, 2], "y": POINTS[:, 1], "X": POINTS[:, 0]})
    assert np.array_equal(as_points(table, "source"), POINTS)
    assert np.array_equal(as_points(pandas.DataFrame(POINTS), "source"), POINTS)
    with pytest.raises(TypeError, match="columns x, y and z"):
        as_points(pandas.DataFrame(np.hstack([POINTS, POINTS])), "source")
