"""Algorithm 2 against the same steps by brute force."""

import numpy as np
import oracles
import pytest

import pyemtr


def expected(problem, angles):
    used = problem.settings
    return oracles.complement(
        angles,
        problem.source_sparse,
        problem.target_sparse,
        used["complement_scale_start"],
        used["complement_scale_end"],
        used["complement_iterations"],
    )


def test_near_the_truth_and_anywhere(problem, pair):
    rng = np.random.default_rng(6)
    truth = problem.to_particle(pair.truth)
    rotations = np.vstack(
        [
            truth[:3],
            truth[:3] + rng.normal(scale=0.05, size=(4, 3)),
            rng.uniform(-np.pi, np.pi, (6, 3)),
        ]
    )
    for angles in rotations:
        found = problem.complement(angles)
        # A near tie between two neighbors may fall either way in float32 and moves the mean
        # by a leaf over the number of points.
        np.testing.assert_allclose(found, expected(problem, angles), rtol=0, atol=2e-4)
    # It is a local search from no translation at all: at the true rotation it comes nearer.
    gap = problem.complement(truth[:3]) - truth[3:]
    assert np.linalg.norm(gap) < 0.5 * np.linalg.norm(truth[3:])


@pytest.mark.parametrize("iterations", [1, 2, 7])
def test_other_schedules(pair, iterations):
    other = pyemtr.Problem(
        pair.source,
        pair.target,
        complement_iterations=iterations,
        complement_scale_start=0.4,
        complement_scale_end=0.2,
        threads=2,
    )
    angles = other.to_particle(pair.truth)[:3] + 0.03
    np.testing.assert_allclose(other.complement(angles), expected(other, angles), atol=2e-4)


def test_it_is_counted(problem):
    before = problem.queries
    problem.complement([0.1, 0.2, 0.3])
    steps = problem.settings["complement_iterations"]
    assert problem.queries - before == steps * len(problem.source_sparse)
