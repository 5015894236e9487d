"""Poses that were found elsewhere are scored, refined and judged by the stages of the method."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapes

import pyemtr


@pytest.fixture(scope="module")
def solved(problem) -> pyemtr.Result:
    return problem.solve()


@pytest.fixture(scope="module")
def alone(pair) -> pyemtr.Problem:
    """A problem in which only the caller's poses are candidates."""
    return pyemtr.Problem(pair.source, pair.target, seeds=0, fallback_search="off", threads=2)


def off(pose: np.ndarray, degrees: float, translation: float = 0.0) -> np.ndarray:
    angle = np.radians(degrees)
    moved = np.eye(4)
    moved[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    moved[0, 3] = translation
    return pose @ moved


def test_scores_fall_with_the_distance_from_the_truth(problem, pair) -> None:
    poses = np.array([off(pair.truth, degrees) for degrees in (0, 1, 3, 30)])
    found = problem.score(poses)
    assert all(isinstance(one, pyemtr.Alternative) for one in found)
    assert [one.score for one in found] == sorted((one.score for one in found), reverse=True)
    for one, pose in zip(found, poses):
        np.testing.assert_allclose(one.transformation, pose, atol=1e-6)
    assert found[0].score > 0.3 > 0.05 > found[3].score
    assert found[0].evidence > found[3].evidence


def test_a_pose_has_the_same_score_alone_and_among_others(problem, pair) -> None:
    poses = [off(pair.truth, degrees) for degrees in (5, 0, 2)]
    together = problem.score(np.array(poses))
    assert [problem.score(pose)[0][1:] for pose in poses] == [one[1:] for one in together]
    assert [one[1:] for one in problem.score(poses)] == [one[1:] for one in together]


def test_rank_has_the_best_first(problem, pair) -> None:
    poses = [off(pair.truth, degrees) for degrees in (5, 0, 2)]
    scored = problem.score(poses)
    assert [one.score for one in problem.rank(poses)] == [scored[i].score for i in (1, 2, 0)]


def test_an_alternative_scores_as_the_result_says(problem, solved) -> None:
    others = solved.alternatives[:3]
    assert others
    for given, found in zip(others, problem.score(others)):
        assert found[1:] == pytest.approx(given[1:], abs=1e-3)


def test_refine_goes_to_the_truth(problem, pair, solved) -> None:
    start = off(pair.truth, 2.0, 0.02)
    refined = problem.refine(start)
    assert refined.shape == (4, 4) and refined.dtype == np.float64
    assert shapes.rotation_error(start, pair.truth) > 1.9
    assert shapes.rotation_error(refined, pair.truth) < 0.2
    many = problem.refine(np.array([start, solved.transformation]))
    assert many.shape == (2, 4, 4) and np.array_equal(many[0], refined)
    assert shapes.rotation_error(problem.refine(solved), pair.truth) < 0.1


def test_a_pose_far_from_everything_stays(problem, pair) -> None:
    far = pair.truth.copy()
    far[:3, 3] += 50.0
    np.testing.assert_allclose(problem.refine(far), far, atol=1e-9)


def test_a_right_pose_is_registered_and_a_wrong_one_is_not(alone, pair) -> None:
    right = alone.solve(poses=off(pair.truth, 2.0))
    assert right.registered and shapes.rotation_error(right.transformation, pair.truth) < 0.1
    assert right.refined and right.iterations == 0 and not right.history["alpha"].size
    wrong = alone.solve(poses=shapes.random_transformation(np.random.default_rng(5)))
    assert shapes.rotation_error(wrong.transformation, pair.truth) > 20
    assert not wrong.registered and wrong.confidence < 0.5


def test_the_best_of_many_wins_whatever_their_order(alone, pair) -> None:
    rng = np.random.default_rng(1)
    poses = [shapes.random_transformation(rng) for _ in range(60)]
    first = alone.solve(poses=[off(pair.truth, 3.0), *poses])
    last = alone.solve(poses=[*poses, off(pair.truth, 3.0)])
    assert first.registered and last.registered
    assert first.transformation.tobytes() == last.transformation.tobytes()


def test_seeds_compete_unless_there_are_none(problem, pair) -> None:
    result = problem.solve(poses=off(pair.truth, 100.0))
    assert result.registered and shapes.rotation_error(result.transformation, pair.truth) < 0.1
    assert result.seeds > 0


def test_any_number_of_threads_gives_the_same_bits(pair) -> None:
    poses = [off(pair.truth, degrees) for degrees in (4, -3, 90)]
    found = set()
    for threads in (1, 3):
        problem = pyemtr.Problem(pair.source, pair.target, threads=threads)
        scores = np.array([one[1:] for one in problem.score(poses)])
        result = problem.solve(poses=poses)
        found.add(scores.tobytes() + problem.refine(poses).tobytes() + shapes.bits(result))
    assert len(found) == 1


def test_without_candidates_the_fitness_decides(paper_problem, pair) -> None:
    poses = [off(pair.truth, 40.0), pair.truth, off(pair.truth, 170.0)]
    result = paper_problem.solve(poses=poses)
    assert shapes.rotation_error(result.transformation, pair.truth) < 1e-3
    assert result.fitness_gap > 0 and result.queries["evaluation"] > 0
    with pytest.raises(ValueError, match="candidates is 0"):
        paper_problem.score(poses)


def test_priors_hold_for_given_poses(pair) -> None:
    problem = pyemtr.Problem(pair.source, pair.target, maximum_rotation=10.0, threads=2)
    for pose in (problem.refine(pair.truth), problem.solve(poses=pair.truth).transformation):
        assert shapes.rotation_error(pose, np.eye(4)) < 10.01


def test_a_callback_is_told_and_stops(alone, pair) -> None:
    seen: list[str] = []
    alone.solve(lambda progress: seen.append(progress.stage), poses=pair.truth)
    assert list(dict.fromkeys(seen)) == ["evolution", "candidates", "refinement", "verdict"]
    stopped = alone.solve(lambda progress: True, poses=pair.truth)
    assert stopped.reason == "interrupted"


REFUSED = [
    (np.eye(3), ValueError, r"\(P, 4, 4\), got \(3, 3\)"),
    (np.zeros((0, 4, 4)), ValueError, "at least one"),
    ([], ValueError, "at least one"),
    (np.zeros((2, 16)), ValueError, r"got \(2, 16\)"),
    (np.full((4, 4), np.nan), ValueError, "NaN"),
    ([np.eye(4), 2 * np.eye(4)], ValueError, "row 1: expected .*rotation"),
    ("poses", TypeError, "str"),
]


@pytest.mark.parametrize("poses, error, text", REFUSED, ids=range(len(REFUSED)))
def test_bad_poses_are_refused(alone, poses: Any, error: type, text: str) -> None:
    for call in (alone.score, alone.rank, alone.refine, lambda p: alone.solve(poses=p)):
        with pytest.raises(error, match=text):
            call(poses)
