"""The benchmark of colors: its scenes, and pairs of the user's own."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from accuracy_fakes import REPOSITORY
from emtr_bench.colors.arguments import GROUPS, scenes
from emtr_bench.colors.cases import case_of, none_right
from emtr_bench.colors.scenes import Case
from emtr_bench.protocol import apply
from plyfile import PlyData, PlyElement

COMMAND = REPOSITORY / "tools" / "bench" / "colors"
ONE_OF_EACH_FAULT = ("unrelated-can", "constant-parcel", "random-parcel", "painted-parcel")


@pytest.mark.parametrize("scene", [*GROUPS["held-out"], *ONE_OF_EACH_FAULT])
def test_a_scene_is_made_by_its_seed(scene: str) -> None:
    case, again = case_of(scene, 5), case_of(scene, 5)
    np.testing.assert_array_equal(case.source, again.source)
    assert not np.array_equal(case.target[:50], case_of(scene, 6).target[:50])
    for points, colors, intensity in (
        (case.source, case.source_colors, case.source_intensity),
        (case.target, case.target_colors, case.target_intensity),
    ):
        assert 4000 < len(points) < 41000 and np.isfinite(points).all()
        if intensity is not None:
            assert colors is None and intensity.shape == (len(points),) and intensity.min() >= 0
        else:
            assert colors is not None and colors.shape == points.shape
            assert 0 <= colors.min() <= colors.max() <= 1


def test_a_scan_lies_on_the_other_under_the_true_pose() -> None:
    case = case_of("parcel", 3)
    moved = apply(case.truth, case.source)
    np.testing.assert_allclose(np.ptp(moved, axis=0), np.ptp(case.target, axis=0), rtol=0.05)
    assert np.ptp(case.target) > 100  # millimeters


def test_groups_and_names_are_told_apart() -> None:
    assert scenes("held-out") == GROUPS["held-out"] and scenes("wall") == ("wall",)
    assert none_right("hotel") and none_right("unrelated-road") and not none_right("painted-parcel")


def write_pair(folder: Path, case: Case, truth: str, colored: bool = True) -> None:
    folder.mkdir(parents=True)
    for name, points, colors in (
        ("source", case.source, case.source_colors),
        ("target", case.target, case.target_colors),
    ):
        columns = [(axis, "f4") for axis in "xyz"]
        columns += [(one, "u1") for one in ("red", "green", "blue")] if colored else []
        rows = np.empty(len(points), dtype=columns)
        for column, axis in enumerate("xyz"):
            rows[axis] = points[:, column]
        if colored:
            for column, one in enumerate(("red", "green", "blue")):
                rows[one] = np.round(255 * colors[:, column])
        PlyData([PlyElement.describe(rows, "vertex")]).write(str(folder / f"{name}.ply"))
    (folder / "T_gt.txt").write_text(truth)


def run(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, str(COMMAND), "--cases", "1", "--preset", "fast", *words],
        capture_output=True, text=True, timeout=600, check=False,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)},
    )  # fmt: skip


def test_pairs_of_ones_own_are_registered_by_their_colors(tmp_path: Path) -> None:
    case = case_of("wall", 4)
    text = "\n".join(" ".join(map(repr, row)) for row in case.truth.tolist())
    write_pair(tmp_path / "mine" / "poster_wall", case, text)
    write_pair(tmp_path / "mine" / "two_walls", case_of("unrelated", 4), "none")
    done = run("--data", str(tmp_path), "--solvers", "off", "auto")
    assert done.returncode == 0, done.stderr
    rows = [line.split() for line in done.stdout.splitlines()]
    found = {
        tuple(row[:2]): row[2:5] for row in rows if row and row[0] in ("poster_wall", "two_walls")
    }
    assert found["poster_wall", "auto"] == ["1/1", "1", "0"]
    assert found["poster_wall", "off"][1:] == ["0", "0"]
    assert found["two_walls", "auto"] == found["two_walls", "off"] == ["0/1", "0", "0"]


def test_a_pair_without_colors_is_named(tmp_path: Path) -> None:
    write_pair(tmp_path / "bare" / "one", case_of("box", 0), "none", colored=False)
    done = run("--data", str(tmp_path))
    assert done.returncode == 2
    expected = f"colors: {tmp_path / 'bare' / 'one' / 'source.ply'}: has neither colors nor"
    assert done.stderr.startswith(expected)
