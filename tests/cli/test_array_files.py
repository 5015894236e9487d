"""Files of numpy.save, as clouds."""

from __future__ import annotations

import cloud_files
import numpy as np
import pytest
from conftest import QUICK, surface

POINTS = surface(240, 3).astype("f4")


@pytest.mark.parametrize("dtype", ["<f4", "<f8"])
@pytest.mark.parametrize("version", [(1, 0), (2, 0), (3, 0)])
def test_same_cloud(run, tmp_path, dtype, version):
    cloud_files.write_pcd(tmp_path / "a.pcd", POINTS)
    with (tmp_path / "a.npy").open("wb") as file:
        np.lib.format.write_array(file, POINTS.astype(dtype), version)
    done = run("a.npy", "a.npy", *QUICK)
    assert done.stdout == run("a.pcd", "a.pcd", *QUICK).stdout, done.stderr


EXPECTED = "expected an array (N, 3) of float32 or float64, little-endian and in C order"


@pytest.mark.parametrize(
    ("array", "pattern"),
    [
        (POINTS.T, f"in Fortran's order, {EXPECTED}"),
        (POINTS.T.copy(), f"of shape (3,240), {EXPECTED}"),
        (POINTS.ravel(), f"of shape (720,), {EXPECTED}"),
        (POINTS[None], f"of shape (1,240,3), {EXPECTED}"),
        (POINTS.astype(">f4"), f"of type '>f4', {EXPECTED}"),
        (POINTS.astype("i4"), f"of type '<i4', {EXPECTED}"),
        (POINTS[:0], "holds no points"),
        (cloud_files.table(POINTS), EXPECTED),
    ],
)
def test_other_arrays_are_refused(refused, small, tmp_path, array, pattern):
    np.save(tmp_path / "a.npy", array)
    assert pattern in refused(2, "a.npy", "b.pcd", "-o", "T.txt")


@pytest.mark.parametrize("share", [0.001, 0.01, 0.03, 0.5, 0.999])
def test_truncated(refused, small, tmp_path, share):
    np.save(tmp_path / "a.npy", POINTS)
    whole = (tmp_path / "a.npy").read_bytes()
    (tmp_path / "a.npy").write_bytes(whole[: int(share * len(whole))])
    message = refused(2, "a.npy", "b.pcd", "-o", "T.txt")
    assert "truncated" in message or "not a file of numpy.save" in message


def test_what_numpy_did_not_save(refused, small, tmp_path):
    np.savez(tmp_path / "a", POINTS)
    (tmp_path / "a.npz").rename(tmp_path / "a.npy")
    assert "not a file of numpy.save" in refused(2, "a.npy", "b.pcd", "-o", "T.txt")
