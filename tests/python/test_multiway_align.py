"""align_all() on generated scans whose poses are known."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from children import environment
from many_scans import errors, scene
from shapes import apply

import pyemtr

pytest.importorskip("gtsam", reason="gtsam is not installed")

#: Two things, and a scan of a third one.
VIEWS = {1: 3, 2: 3, 3: 1}
GOOD = np.random.default_rng(0).random((99, 3))


@pytest.fixture(scope="module")
def made():
    return scene(VIEWS, seed=1, count=2500, half_angle=85.0)


@pytest.fixture(scope="module")
def two(made):
    """The three scans of the second thing, and which of all they are."""
    picked = [i for i, thing in enumerate(made.things) if thing == 2]
    return [made.clouds[i] for i in picked], picked


@pytest.fixture(scope="module")
def result(made):
    return pyemtr.align_all(made.clouds, threads=2)


def test_each_thing_becomes_a_model_and_an_outsider_is_left_out(made, result) -> None:
    things = [{made.things[scan] for scan in members} for members in result.models]
    assert [len(one) for one in result.models] == [3, 3] and all(len(one) == 1 for one in things)
    outsider = made.things.index(3)
    assert result.left_out == [outsider]
    assert result.scans[outsider].verdict in ("apart", "doubtful")
    assert np.isnan(result.poses[outsider]).all() and result.scans[outsider].model is None


def test_the_poses_are_right(made, result) -> None:
    degrees, distance = errors(result, made.truth)[result.placed].T
    assert degrees.max() < 0.3 and distance.max() < 0.005


def test_a_model_has_the_frame_of_its_first_scan(result) -> None:
    for members in result.models:
        np.testing.assert_allclose(result.poses[members[0]], np.eye(4), atol=1e-9)
        assert not result.scans[members[0]].covariance.any()
        for scan in members[1:]:
            assert np.linalg.eigvalsh(result.scans[scan].covariance).min() > 0


def test_each_pair_has_an_edge_and_a_reason(made, result) -> None:
    assert [(e.source, e.target) for e in result.edges] == sorted(
        (j, i) for j in range(7) for i in range(j)
    )
    for edge in result.edges:
        same = made.things[edge.source] == made.things[edge.target]
        assert edge.why and (same or not edge.taken)
        if edge.taken:
            assert edge.degrees < 5 and edge.probability > 0.5
    assert sum(edge.loops > 0 for edge in result.edges) >= 3


def test_threads_do_not_change_a_bit(made) -> None:
    few = made.clouds[:4]
    one, other = (pyemtr.align_all(few, preset="fast", threads=threads) for threads in (1, 3))
    assert np.array_equal(one.poses, other.poses, equal_nan=True)
    for first, second in zip(one.scans, other.scans):
        assert np.array_equal(first.covariance, second.covariance, equal_nan=True)


def test_unit_order_and_place_do_not_matter(made) -> None:
    """In millimeters, far from the origin, and from the last to the first."""
    picked = [i for i, thing in enumerate(made.things) if thing == 2][::-1]
    far = [1000 * made.clouds[i] + [4e6, -5e5, 100.0] for i in picked]
    found = pyemtr.align_all(far, names=["c", "b", "a"], preset="fast")
    assert found.models == [[0, 1, 2]] and [scan.name for scan in found.scans] == ["c", "b", "a"]
    for k, i in enumerate(picked):
        wanted = np.linalg.inv(made.truth[picked[0]]) @ made.truth[i]
        points = made.clouds[i][:50]
        there = (
            apply(found.poses[k], 1000 * points + [4e6, -5e5, 100.0]) - [4e6, -5e5, 100]
        ) / 1000
        assert np.abs(there - apply(wanted, points)).max() < 0.01


def test_files_give_the_same_poses(made, tmp_path: Path) -> None:
    picked = [i for i, thing in enumerate(made.things) if thing == 2]
    for i in picked:
        np.save(tmp_path / f"view_{i}.npy", made.clouds[i])
    (tmp_path / "notes.md").write_text("not a scan", encoding="utf-8")
    found = pyemtr.align_all(tmp_path, preset="fast", joint_refinement=False)
    clouds = [made.clouds[i] for i in picked]
    arrays = pyemtr.align_all(clouds, preset="fast", joint_refinement=False)
    assert [scan.name for scan in found.scans] == [f"view_{i}.npy" for i in picked]
    assert np.array_equal(found.poses, arrays.poses)
    fused = found.fuse(voxel=0.05)
    assert fused.counts.sum() == sum(len(made.clouds[i]) for i in picked)


def test_pairs_can_be_chosen(made) -> None:
    picked = [i for i, thing in enumerate(made.things) if thing == 2]
    clouds = [made.clouds[i] for i in picked]
    found = pyemtr.align_all(
        clouds, pairs=[(0, 1), (1, 0), (2, 1)], preset="fast", joint_refinement=False
    )
    assert [(e.source, e.target) for e in found.edges] == [(1, 0), (2, 1)]
    for wrong, message in (
        ([(0, 3)], "from 0 to 2"),
        ([(1, 1)], "two different"),
        ([], "at least"),
    ):
        with pytest.raises(ValueError, match=f"pairs: .*{message}"):
            pyemtr.align_all(clouds, pairs=wrong)


def test_the_callback_hears_of_the_stages_and_can_stop(made) -> None:
    heard = []

    def callback(stage: str, done: int, count: int) -> bool:
        heard.append((stage, done, count))
        return done == 2

    with pytest.raises(RuntimeError, match="stopped by the callback"):
        pyemtr.align_all(made.clouds[:4], callback=callback, threads=1, preset="fast")
    assert heard == [("reading", 0, 4), ("pairs", 1, 6), ("pairs", 2, 6)]


@pytest.mark.parametrize(
    ("clouds", "error", "message"),
    [
        ([np.zeros((20, 3))], ValueError, "expected two or more, got 1"),
        (np.zeros((20, 3)), TypeError, "expected a list of clouds or a folder"),
        ("no/such/folder", NotADirectoryError, "no/such/folder: expected a folder"),
        (["a.npy", "b.npy"], FileNotFoundError, "a.npy"),
        ([np.zeros((20, 2))] * 2, ValueError, r"clouds\[0\]: expected an array of shape"),
        ([GOOD, np.zeros((20, 3))], ValueError, r"clouds\[1\] \(scan_1\): "),
    ],
)
def test_bad_clouds_are_named(clouds, error, message) -> None:
    with pytest.raises(error, match=message):
        pyemtr.align_all(clouds)


def test_bad_arguments_are_named(made) -> None:
    few = made.clouds[:2]
    with pytest.raises(ValueError, match="names: expected 2 different names"):
        pyemtr.align_all(few, names=["x", "x"])
    with pytest.raises(ValueError, match='preset: "paper" has no confidence'):
        pyemtr.align_all(few, preset="paper")
    with pytest.raises(TypeError, match="seeeds"):
        pyemtr.align_all(few, seeeds=3)
    with pytest.raises(ValueError, match="voxel: expected a length above 0"):
        pyemtr.align_all(few, joint_refinement=False).fuse(voxel=0)


@pytest.mark.parametrize("missing", ["gtsam", "scipy"])
def test_a_missing_package_is_named_with_its_pip_line(missing: str, tmp_path: Path) -> None:
    code = (
        f"import sys; sys.modules[{missing!r}] = None\n"
        "import numpy as np, pyemtr\n"
        "try: pyemtr.align_all([np.random.rand(99, 3)] * 2)\n"
        "except ImportError as error: print(error)"
    )
    out = subprocess.run(
        [sys.executable, "-c", code],
        check=True,
        text=True,
        stdout=subprocess.PIPE,
        cwd=tmp_path,
        env=environment(),
    ).stdout
    assert missing in out.lower() and "pip install 'pyemtr[align]'" in out


def test_the_result_tells_of_itself(result) -> None:
    text = repr(result)
    assert "6 of 7 scans placed in 2 models" in text and "scan_0" in text
    value = result.to_dict()
    assert value["models"] == result.models and len(value["edges"]) == 21
    assert all(scan["pose"][0][0] is None for scan in value["scans"] if not scan["placed"])


def test_clouds_of_different_units_are_refused():
    clouds = [np.zeros((20, 3))] * 3
    with pytest.raises(ValueError, match="scale: expected clouds of one unit"):
        pyemtr.align_all(clouds, scale="free")
