"""Real scans, from where the data are."""

from __future__ import annotations

import numpy as np
import pytest


@pytest.mark.parametrize("name", ["fgr/bunny_n0_24", "fgr/angel_n0_18"])
def test_real_pair(run, data_dir, tmp_path, name):
    folder = data_dir / "pairs" / name
    if not folder.is_dir():
        pytest.skip(f"no pair {name} in {data_dir}")
    done = run(folder / "source.ply", folder / "target.ply", "--threads", "2", "-o", "T.txt")
    assert done.returncode == 0, done.stderr
    found = np.loadtxt(tmp_path / "T.txt")
    truth = np.loadtxt(folder / "T_gt.txt")
    chord = np.linalg.norm(found[:3, :3] - truth[:3, :3]) / (2 * np.sqrt(2))
    assert np.degrees(2 * np.arcsin(min(1, chord))) < 5
