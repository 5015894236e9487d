"""Given matches decide where the clouds are no surface; tools/bench/matches."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
import shapes
from emtr_bench.matches.arguments import parser
from emtr_bench.matches.cases import Case, make_case
from emtr_bench.matches.program import matches as benchmark
from shapes import bits

import pyemtr
from pyemtr.metrics import rotation_error


def register(case: Case, **settings: object) -> pyemtr.Result:
    rows = np.arange(len(case.source))
    pairs = np.column_stack([rows, rows])
    return pyemtr.register(case.source, case.target, correspondences=pairs, **settings)


@pytest.mark.parametrize(
    ("count", "outliers"), [(50, 0.0), (50, 0.5), (10, 0.1), (100, 0.9), (400, 0.95), (3, 0.0)]
)
def test_exact_matches_give_the_pose_to_rounding(count: int, outliers: float) -> None:
    for seed in range(3):
        case = make_case(count, outliers, 0.0, seed, None)
        result = register(case)
        assert result.registered and result.reason == "registered"
        assert result.confidence > 0.99
        assert rotation_error(result.transformation, case.truth) < 1e-4
        np.testing.assert_allclose(result.transformation, case.truth, atol=1e-5)
        assert result.score == pytest.approx(case.right / count)


@pytest.mark.parametrize(("count", "outliers", "least"), [(1000, 0.95, 4), (1000, 0.99, 3)])
def test_most_matches_may_be_wrong(count: int, outliers: float, least: int) -> None:
    right = 0
    for seed in range(4):
        case = make_case(count, outliers, 0.01, seed, None)
        result = register(case)
        is_right = rotation_error(result.transformation, case.truth) < 10
        assert is_right or not result.registered
        right += is_right and result.registered
    assert right >= least


@pytest.mark.parametrize("count", [3, 5, 10, 60, 400])
def test_matches_that_are_all_wrong_are_not_registered(count: int) -> None:
    for seed in range(4):
        result = register(make_case(count, 1.0, 0.0, seed, None))
        assert not result.registered and result.reason == "few_matches"
        assert result.confidence < 0.5
        assert np.isfinite(result.transformation).all()


def test_two_poses_of_as_many_matches_are_ambiguous() -> None:
    case, other = (make_case(60, 0.0, 0.0, seed, None) for seed in (1, 2))
    moved = shapes.apply(other.truth, case.source)
    target = np.where(np.arange(60)[:, None] < 30, case.target, moved)
    result = register(Case(case.source, target, case.truth, 30))
    assert not result.registered and result.reason == "ambiguous"
    found = [result.transformation, result.alternatives[0].transformation]
    for truth in (case.truth, other.truth):
        assert min(rotation_error(pose, truth) for pose in found) < 1e-3


def test_matches_on_a_line_leave_a_direction_open() -> None:
    case = make_case(60, 0.4, 0.0, 3, None)
    source = case.source.copy()
    right = np.abs(shapes.apply(case.truth, source) - case.target).max(axis=1) < 1e-6
    source[right] = np.outer(np.linspace(0, 1, right.sum()), [0.5, 0.7, 0.2])
    target = case.target.copy()
    target[right] = shapes.apply(case.truth, source[right])
    result = register(Case(source, target, case.truth, int(right.sum())))
    assert not result.registered and result.reason == "degenerate"
    assert result.unconstrained_directions == 1


def test_the_same_bits_for_any_number_of_threads_and_from_a_problem() -> None:
    case = make_case(400, 0.9, 0.01, 5, None)
    rows = np.arange(400)
    pairs = np.column_stack([rows, rows])
    one = register(case, threads=1)
    assert bits(register(case, threads=3)) == bits(one)
    problem = pyemtr.Problem(case.source, case.target, correspondences=pairs, threads=1)
    assert bits(problem.solve()) == bits(one)


def test_far_outliers_do_not_hide_a_small_object() -> None:
    """As in an example of TEASER++: groups of points that moved together, far away."""
    rng = np.random.default_rng(3)
    source = shapes.lump(rng, 900) * 0.08
    truth = shapes.random_transformation(rng)
    target = shapes.apply(truth, source) + rng.uniform(-0.001, 0.001, (900, 3))
    for row in rng.integers(0, 900, 800):
        target[row] += rng.integers(5, 11)
    result = register(Case(source, target, truth, 0))
    assert result.registered
    assert rotation_error(result.transformation, truth) < 1


def test_the_case_of_the_shared_data() -> None:
    folder = Path(os.environ.get("EMTR_DATA", "nowhere")) / "cases" / "fifty_matches"
    if not folder.exists():
        pytest.skip("EMTR_DATA has no cases/fifty_matches")
    from plyfile import PlyData

    clouds = [
        np.column_stack([PlyData.read(str(folder / name))["vertex"][axis] for axis in "xyz"])
        for name in ("source.ply", "target.ply")
    ]
    truth = np.loadtxt(folder / "T_gt.txt")
    result = register(Case(clouds[0], clouds[1], truth, 25))
    assert result.registered and rotation_error(result.transformation, truth) < 1e-3


def test_the_benchmark_counts_what_is_right(capsys: pytest.CaptureFixture[str]) -> None:
    assert benchmark(parser().parse_args(["--smoke"])) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines() if "emtr " in line]
    assert [(line[1], line[2], line[3]) for line in lines] == [
        ("50", "0.0", "2/2"), ("50", "90.0", lines[1][3]), ("50", "100.0", "0/2"),
        ("300", "0.0", "2/2"), ("300", "90.0", "2/2"), ("300", "100.0", "0/2"),
    ]  # fmt: skip


def test_matches_tell_an_unknown_scale():
    case = make_case(300, 0.8, 0.01, 4, None, unknown_scale=True)
    assert 1 < case.scale < 5
    same = make_case(300, 0.8, 0.01, 4, None)
    np.testing.assert_allclose(case.target, case.scale * same.target)
    rows = np.stack([np.arange(300)] * 2, axis=1)
    result = pyemtr.register(
        case.source, case.target, correspondences=rows, scale="free", threads=1
    )
    assert result.registered
    assert result.scale == pytest.approx(case.scale, rel=0.02)
