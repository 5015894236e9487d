"""The confidence of a result, its score and its alternatives."""

import json

import numpy as np
import pytest
import shapes

import pyemtr

HALF_ROTATION = np.diag([-1.0, -1.0, 1.0, 1.0])


@pytest.fixture(scope="module")
def solved(pair):
    return pyemtr.register(pair.source, pair.target, threads=2)


@pytest.fixture(scope="module")
def twofold():
    """A shape that looks the same after a rotation by 180 degrees about z, sampled twice."""
    rng = np.random.default_rng(0)
    halves = [shapes.lump(rng, 5000) for _ in range(2)]
    source, target = (np.vstack([half, shapes.apply(HALF_ROTATION, half)]) for half in halves)
    truth = shapes.random_transformation(rng)
    return shapes.Pair(source, shapes.apply(truth, target), truth)


def test_the_figures_belong_together(solved):
    assert solved.registered and 0.9 < solved.confidence <= 1
    missed = solved.surface_near - solved.surface_fit
    assert solved.score == pytest.approx(solved.surface_fit - 0.1 * missed - solved.violation)
    assert 0 < solved.surface_fit <= 1 and 0 <= solved.violation <= 1
    assert 0 < solved.score_gap <= solved.score
    assert solved.seeds > 0 and 1 + len(solved.alternatives) <= solved.candidates
    assert solved.refined is True and solved.used_fallback_search is False


def test_the_paper_preset_has_none(pair):
    found = pyemtr.register(pair.source, pair.target, preset="paper", threads=2)
    for name in ("confidence", "score", "surface_fit", "surface_near", "violation", "score_gap"):
        assert np.isnan(getattr(found, name)), name
    assert (found.seeds, found.candidates, found.alternatives) == (0, 0, [])
    assert found.refined is False and found.unconstrained_directions is None
    assert found.registered and "confidence" not in repr(found)


def test_both_poses_of_a_symmetric_shape_are_told(twofold):
    # However sure the library holds itself to be, it is asked to be surer.
    found = pyemtr.register(twofold.source, twofold.target, threads=2, minimum_confidence=1)
    assert found.reason == "ambiguous" and not found.registered
    other, score, *_ = found.alternatives[0]
    right = [twofold.truth, twofold.truth @ HALF_ROTATION]
    for pose in (found.transformation, other):
        assert min(shapes.rotation_error(pose, wanted) for wanted in right) < 1
        assert shapes.centroid_error(pose, twofold.truth, twofold.source) < 0.02
    assert shapes.rotation_error(found.transformation, other) > 178
    assert score == pytest.approx(found.score, rel=0.02) and found.score_gap < 0.02


def test_a_lattice_fits_in_many_ways():
    steps = np.arange(9.0)
    lattice = np.stack(np.meshgrid(steps, steps, steps), -1).reshape(-1, 3)
    # In the same order each point would be matched with itself, which is an answer of its own.
    shuffled = np.random.default_rng(0).permutation(lattice)
    found = pyemtr.register(shuffled, lattice, threads=2)
    assert found.reason == "ambiguous" and not found.registered and found.score_gap < 0.02
    for pose in (found.transformation, *[other.transformation for other in found.alternatives[:3]]):
        assert (
            np.abs(np.rint(shapes.apply(pose, lattice)) - shapes.apply(pose, lattice)).max() < 0.1
        )


def test_alternatives_are_other_poses_best_first(twofold):
    found = pyemtr.register(twofold.source, twofold.target, threads=2, fallback_search="always")
    assert found.used_fallback_search is True
    scores = [alternative.score for alternative in found.alternatives]
    assert scores == sorted(scores, reverse=True) and scores[0] <= found.score
    assert 1 <= len(scores) <= 10
    poses = [found.transformation, *[other.transformation for other in found.alternatives]]
    for pose in poses:
        assert pose.dtype == np.float64 and pose.shape == (4, 4) and pose.flags.writeable
        np.testing.assert_allclose(pose[:3, :3] @ pose[:3, :3].T, np.eye(3), atol=1e-12)
    for i, pose in enumerate(poses[1:], start=1):
        for other in poses[1:i]:
            assert (
                shapes.rotation_error(pose, other) > 9.99
                or shapes.centroid_error(pose, other, twofold.source)
                > 0.149 * found.normalization_scale
            )


def test_a_lower_bar_lets_more_be_called_registered(pair):
    rng = np.random.default_rng(0)
    noise = rng.uniform(size=(5000, 3))
    bars = [
        pyemtr.register(noise, pair.target, minimum_confidence=bar, iterations=6, threads=2)
        for bar in (0.0, 0.5)
    ]
    assert bars[0].confidence == bars[1].confidence < 0.5
    assert bars[0].registered and not bars[1].registered
    assert bars[1].reason in ("low_overlap", "ambiguous", "few_matches")


def test_alternatives_can_be_written_down(twofold):
    found = pyemtr.register(twofold.source, twofold.target, threads=2)
    written = json.loads(json.dumps(found.to_dict(), allow_nan=False))["alternatives"]
    expected = [
        {**other._asdict(), "transformation": other.transformation.tolist()}
        for other in found.alternatives
    ]
    assert written == expected != []
