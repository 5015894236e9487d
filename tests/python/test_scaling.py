"""The scaling benchmark: what it derives from its figures, and a run for real."""

import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tools" / "bench"))
from emtr_bench import bumpy_ball, scaling, scaling_plot  # noqa: E402

SCRIPT = REPOSITORY / "tools" / "bench" / "scaling"


def row(points, seconds, memory=1.5, registered=True):
    return {
        "points": points,
        "seconds": seconds,
        "seconds_kept": seconds / 2,
        "E_R": 0.5,
        "input_bytes": 24 * points,
        "peak_bytes": memory * 24 * points,
        "bytes_before": 24 * points,
        "registered": registered,
        "dense": 4000,
        "sparse": 600,
        "stages": dict.fromkeys(scaling.STAGES, seconds / 6),
    }


def run(*argv):
    return subprocess.run(
        [sys.executable, str(SCRIPT), *argv], capture_output=True, text=True, check=False
    )


def test_the_slope_is_the_exponent_of_the_large_sizes():
    rows = [row(n, 3e-7 * n**1.25) for n in (10**5, 10**6, 10**7)]
    assert scaling.slope(rows) == pytest.approx(1.25)
    assert scaling.slope([row(1000, 9), *rows]) == pytest.approx(1.25)  # small ones do not count
    assert math.isnan(scaling.slope([row(1000, 1), row(10**6, 2)]))


def test_each_missed_target_is_named():
    good = [row(10**5, 0.2), row(10**7, 3.9, memory=2.9)]
    assert scaling.targets_missed(good, 1.05) == []
    for bad, exponent, text in [
        ([good[0]], 1.0, "not measured"),
        ([row(10**7, 4.1)], 1.0, "4.10 s > 4 s"),
        ([row(10**7, 1, memory=3.0)], 1.0, "memory 3.00"),
        (good, 1.06, "slope 1.06"),
        (good, math.nan, "slope nan"),
        ([row(10**5, 1, registered=False), good[1]], 1.0, "100000 points: not registered"),
    ]:
        missed = scaling.targets_missed(bad, exponent)
        assert len(missed) == 1 and text in missed[0], missed


def test_the_ball_is_one_surface_in_two_frames():
    pair = bumpy_ball.ball_pair(30000, 4)
    assert pair.source.dtype == np.float32 and pair.source.shape == pair.target.shape == (30000, 3)
    assert pair.bytes == 2 * 30000 * 12
    rotation = pair.T_true[:3, :3]
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-6)
    assert np.linalg.det(rotation) > 0
    from scipy.spatial import cKDTree

    moved = pair.source @ rotation.T + pair.T_true[:3, 3]
    gaps = cKDTree(pair.target).query(moved)[0]
    assert 0.6 < np.mean(gaps < 0.03) < 0.95


def test_the_smoke_run_tells_and_writes_all(tmp_path):
    done = run(
        "--smoke",
        "--threads",
        "1",
        "--json",
        str(tmp_path / "s.json"),
        "--plot",
        str(tmp_path / "s.png"),
    )
    assert done.returncode == 0, done.stderr
    value = json.loads((tmp_path / "s.json").read_text(encoding="utf-8"))
    assert [size["points"] for size in value["sizes"]] == list(scaling.SMOKE_SIZES)
    for size in value["sizes"]:
        assert size["registered"] and size["E_R"] < 5
        assert sum(size["stages"][stage] for stage in scaling.STAGES) <= size["seconds"]
        assert size["input_bytes"] < size["bytes_before"] <= size["peak_bytes"]
        assert f"\n{size['points']:>10} " in done.stdout
    assert (tmp_path / "s.png").read_bytes().startswith(b"\x89PNG")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["s.json", "s.png"]


def test_a_picture_that_cannot_be_written_leaves_nothing(tmp_path):
    with pytest.raises(OSError):
        scaling_plot.plot([row(1000, 1), row(10**5, 2)], tmp_path / "nowhere" / "s.png")
    assert list(tmp_path.iterdir()) == []


def test_targets_decide_the_status_when_required():
    done = run("--sizes", "1000", "--repeat", "1", "--require")
    assert done.returncode == 1 and "not measured" in done.stdout
    assert run("--sizes", "0").returncode == 2
