"""--residuals: how far each moved source point is from the target, against scipy."""

from __future__ import annotations

import json

import cloud_files
import numpy as np
import pytest
from cloud_files import read_pcd, read_ply, table, xyz


def distances(moved: np.ndarray, target: np.ndarray) -> np.ndarray:
    return pytest.importorskip("scipy.spatial").cKDTree(target).query(moved)[0]


@pytest.fixture
def expected(pair, tmp_path):
    """Measures the residuals of the pose that was written."""

    def call() -> np.ndarray:
        T = np.loadtxt(tmp_path / "T.txt")
        source, target = (read_pcd(tmp_path / name)[0] for name in ("a.pcd", "b.pcd"))
        return distances(xyz(source) @ T[:3, :3].T + T[:3, 3], xyz(target))

    return call


@pytest.mark.parametrize("extension", [".pcd", ".ply"])
def test_are_a_field_of_the_moved_cloud(run, clouds, tmp_path, pair, expected, extension):
    done = run(*clouds, "-o", "T.txt", "--aligned", f"m{extension}", "--residuals")
    assert done.returncode == 0, done.stderr
    rows = (read_pcd if extension == ".pcd" else read_ply)(tmp_path / f"m{extension}")[0]
    assert rows.dtype.names == ("x", "y", "z", "residual") and rows["residual"].dtype == "f4"
    assert len(rows) == len(pair.source)
    np.testing.assert_allclose(rows["residual"], expected(), rtol=0, atol=5e-6)


def test_their_spread_is_in_the_report(run, clouds, tmp_path, expected):
    done = run(*clouds, "-o", "T.txt", "--report", "r.json", "--residuals")
    assert done.returncode == 0, done.stderr
    found, wanted = json.loads((tmp_path / "r.json").read_text())["residuals"], expected()
    assert found["count"] == len(wanted)
    for name, value in [
        ("mean", wanted.mean()),
        ("rms", np.sqrt((wanted**2).mean())),
        ("median", np.quantile(wanted, 0.5, method="lower")),
        ("quantile_90", np.quantile(wanted, 0.9, method="lower")),
        ("quantile_95", np.quantile(wanted, 0.95, method="lower")),
        ("maximum", wanted.max()),
    ]:
        assert found[name] == pytest.approx(value, abs=5e-6), name


def test_other_fields_stay_and_dropped_points_have_none(run, clouds, tmp_path, pair):
    points = pair.source.copy()
    points[7] = np.nan
    label = np.arange(len(points), dtype="u2")
    cloud_files.write_pcd(tmp_path / "a.pcd", table(points, label=label))
    assert run(*clouds, "-o", "T.txt", "--aligned", "m.pcd", "--residuals").returncode == 0
    rows, _ = read_pcd(tmp_path / "m.pcd")
    assert np.flatnonzero(np.isnan(rows["residual"])).tolist() == [7]
    assert np.array_equal(rows["label"], label)


def test_a_field_of_that_name_is_written_over(run, refused, clouds, tmp_path, pair, expected):
    residual = np.full(len(pair.source), 9, dtype="f4")
    cloud_files.write_pcd(tmp_path / "a.pcd", table(pair.source, residual=residual))
    words = (*clouds, "--aligned", "m.pcd", "--residuals")
    assert run(*words, "-o", "T.txt").returncode == 0
    rows, _ = read_pcd(tmp_path / "m.pcd")
    assert rows.dtype.names == ("x", "y", "z", "residual")
    np.testing.assert_allclose(rows["residual"], expected(), rtol=0, atol=5e-6)
    cloud_files.write_pcd(tmp_path / "a.pcd", table(pair.source, residual=residual.astype("f8")))
    (tmp_path / "m.pcd").unlink()
    (tmp_path / "T.txt").unlink()
    assert "field 'residual'" in refused(2, *words)


def test_need_a_file_to_go_to(refused, small):
    assert "--aligned or --report" in refused(1, *small, "--residuals")


def test_are_left_out_unless_asked_for(run, clouds, tmp_path):
    assert run(*clouds, "--aligned", "m.pcd", "--report", "r.json").returncode == 0
    assert read_pcd(tmp_path / "m.pcd")[0].dtype.names == ("x", "y", "z")
    assert json.loads((tmp_path / "r.json").read_text())["residuals"] is None
