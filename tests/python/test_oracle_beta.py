"""Task beta against its sum over all TIMs."""

import numpy as np
import oracles
import pytest

import pyemtr


@pytest.fixture(scope="module")
def angles(problem, pair):
    rng = np.random.default_rng(4)
    low, high = pyemtr.TaskBeta(problem).bounds.T
    truth = problem.to_particle(pair.truth)[:3]
    near = truth + rng.normal(scale=0.03, size=(5, 3))
    return np.vstack([rng.uniform(low, high, (10, 3)), near, truth, truth + 2 * np.pi])


def check(problem, angles):
    found = pyemtr.TaskBeta(problem).evaluate(angles)
    threshold = problem.settings["inlier_threshold"] * problem.tau
    eta = problem.settings["outlier_penalty"] * problem.tau
    for value, rotation in zip(found, angles):
        residuals = oracles.beta_residuals(rotation, problem.tim_source, problem.tim_target)
        wanted = oracles.beta(
            rotation, problem.tim_source, problem.tim_target, problem.tims_pruned, threshold, eta
        )
        # float32 may take a TIM on the very edge for the other kind; each costs eta at most.
        on_edge = np.count_nonzero(np.abs(residuals - threshold) < 2e-6)
        assert value == pytest.approx(wanted, rel=1e-6, abs=1e-5 + on_edge * eta)
    return found


def test_sum_over_all_tims(problem, angles):
    found = check(problem, angles)
    assert found.min() < 0.99 * found.max()


def test_the_truth_is_best(problem, pair):
    truth = problem.to_particle(pair.truth)[:3]
    others = np.random.default_rng(5).uniform(-np.pi, np.pi, (500, 3))
    found = pyemtr.TaskBeta(problem).evaluate(np.vstack([truth, others]))
    assert found.argmin() == 0


def test_with_another_threshold_and_penalty(pair, angles):
    other = pyemtr.Problem(
        pair.source,
        pair.target,
        inlier_threshold=2.0,
        outlier_penalty=7.0,
        tau_factor=0.8,
        max_tims=3000,
        threads=2,
    )
    check(other, angles)
