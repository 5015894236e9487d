"""Task alpha against the M-estimator sums by brute force, both stages."""

import numpy as np
import oracles
import pytest

import pyemtr


@pytest.fixture(scope="module")
def particles(problem, pair):
    """Anywhere, near the truth, at it, rotated by multiples of 360 degrees, and far outside."""
    rng = np.random.default_rng(3)
    low, high = pyemtr.TaskAlpha(problem).bounds.T
    anywhere = rng.uniform(low, high, (12, 6))
    truth = problem.to_particle(pair.truth)
    near = truth + rng.normal(scale=0.02, size=(6, 6))
    rotated = truth + [2 * np.pi, -4 * np.pi, 2 * np.pi, 0, 0, 0]
    far = [0, 0, 0, 40.0, 0, 0]
    return np.vstack([anywhere, near, truth, rotated, far])


def test_sparse_stage(problem, particles):
    found = problem.evaluate_alpha(particles, "sparse")
    wanted = [
        oracles.alpha_sparse(x, problem.source_sparse, problem.target_sparse, problem.c_sparse)
        for x in particles
    ]
    # Points are float32 near 1: a distance is good to about 1e-6, rho to that times 1.7 / c.
    np.testing.assert_allclose(found, wanted, rtol=0, atol=len(problem.source_sparse) * 2e-5)
    assert min(wanted) < 0.5 * max(wanted)  # the particles tell good from bad


def test_dense_stage(problem, particles):
    found = problem.evaluate_alpha(particles, "dense")
    wanted = [
        oracles.alpha_dense(x, problem.source_dense, problem.target_dense, problem.c_dense)
        for x in particles
    ]
    points = len(problem.source_dense) + len(problem.target_dense)
    np.testing.assert_allclose(found, wanted, rtol=0, atol=points * 2e-5)
    assert min(wanted) < 0.7 * max(wanted)


def test_dense_stage_with_neighbors_in_the_whole_clouds(pair, particles):
    problem = pyemtr.Problem(pair.source, pair.target, dense_reference="whole")
    dense = problem.source_dense, problem.target_dense
    whole = [
        ((cloud - center) / problem.normalization_scale).astype(np.float32)
        for cloud, center in (
            (pair.source, problem.center_source),
            (pair.target, problem.center_target),
        )
    ]
    assert all(len(cloud) > len(few) for cloud, few in zip(whole, dense))
    found = problem.evaluate_alpha(particles, "dense")
    wanted = [oracles.alpha_dense(x, *dense, problem.c_dense, whole) for x in particles]
    np.testing.assert_allclose(found, wanted, rtol=0, atol=sum(map(len, dense)) * 2e-5)
    assert min(wanted) < 0.7 * max(wanted)


def test_nothing_near_costs_one_a_point(problem):
    far = np.array([[0.3, 0.2, 0.1, 40.0, 0, 0]])
    assert problem.evaluate_alpha(far, "sparse") == len(problem.source_sparse)
    assert problem.evaluate_alpha(far) == len(problem.source_dense) + len(problem.target_dense)


@pytest.mark.parametrize("neighbors", [1, 2])
def test_every_neighbor_search_gives_the_same_bits(pair, problem, particles, neighbors):
    other = pyemtr.Problem(pair.source, pair.target, neighbors=neighbors, threads=2)
    for resolution in ("sparse", "dense"):
        assert (
            other.evaluate_alpha(particles, resolution).tobytes()
            == problem.evaluate_alpha(particles, resolution).tobytes()
        )
