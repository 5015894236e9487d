"""--scale: a source of another scale, by real processes."""

from __future__ import annotations

import json

import cloud_files
import numpy as np
import pytest
from cloud_files import read_pcd, table, xyz
from conftest import QUICK, rotation, surface

POINTS = surface(4000, 3)
NORMALS = POINTS / np.linalg.norm(POINTS, axis=1)[:, None]
ROTATION = rotation([1, 2, -1], 2.0)


@pytest.fixture
def pair(tmp_path):
    """A target, and a source in millimeters of it in meters."""
    cloud_files.write_pcd(tmp_path / "target.pcd", surface(4000, 4) @ ROTATION.T + [1, 2, 3])
    cloud_files.write_pcd(tmp_path / "source.pcd", 1000 * POINTS)


def matrix(path):
    return np.loadtxt(path)


@pytest.mark.parametrize("scale", ["free", "units", "0.0005,0.002", "0.001"])
def test_the_matrix_is_a_similarity(run, tmp_path, pair, scale):
    done = run("source.pcd", "target.pcd", *QUICK, "--scale", scale, "-o", "T.txt",
               "--report", "report.json")  # fmt: skip
    assert done.returncode == 0, done.stderr
    T = matrix(tmp_path / "T.txt")
    assert np.cbrt(np.linalg.det(T[:3, :3])) == pytest.approx(1e-3, rel=0.01)
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["scale"] == pytest.approx(1e-3, rel=0.01)
    if scale == "units":
        assert report["scale"] == 1e-3
    assert "q = s R p + t with s = 0.00" in done.stderr


def test_the_moved_cloud_is_scaled_and_its_normals_are_not(run, tmp_path, pair):
    fields = {f"normal_{axis}": NORMALS[:, i].astype("f4") for i, axis in enumerate("xyz")}
    cloud_files.write_pcd(tmp_path / "source.pcd", table(1000 * POINTS, **fields))
    done = run("source.pcd", "target.pcd", *QUICK, "--scale", "units", "-o", "T.txt",
               "--aligned", "moved.pcd")  # fmt: skip
    assert done.returncode == 0, done.stderr
    T = matrix(tmp_path / "T.txt")
    moved, _ = read_pcd(tmp_path / "moved.pcd")
    expected = 1000 * POINTS @ T[:3, :3].T + T[:3, 3]
    np.testing.assert_allclose(xyz(moved), expected, atol=1e-4)
    normals = np.stack([moved[name] for name in fields], axis=1)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)


@pytest.mark.parametrize("scale", ["any", "2,1", "1,2,3", "0", ""])
def test_a_bad_scale_is_refused(run, pair, scale):
    done = run("source.pcd", "target.pcd", "--scale", scale, "-o", "T.txt")
    assert done.returncode == 1
    assert "--scale" in done.stderr


def test_a_suspected_unit_names_the_way_out(run, pair):
    done = run("source.pcd", "target.pcd", *QUICK, "-o", "T.txt")
    assert done.returncode in (2, 3)
    assert "--scale units tries such factors" in done.stderr
