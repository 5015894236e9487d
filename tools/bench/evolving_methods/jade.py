"""JADE: Zhang and Sanderson, *JADE: adaptive differential evolution with optional external
archive*, IEEE TEVC 2009. A single task.

current-to-pbest/1 with the archive; F and CR are drawn for each individual around means that follow
those which succeeded.
"""

from __future__ import annotations

import numpy as np

from .operators import binomial_crossover, halfway_into_bounds, two_others
from .problem import Array, Problem

POPULATION = 50
BEST_SHARE = 0.05  # p
LEARNING_RATE = 0.1  # c
SPREAD = 0.1


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    x = rng.random((POPULATION, problem.tasks[0].dimensions))
    fitness = problem.evaluate(x)
    archive = np.empty((0, x.shape[1]))
    mean_f = mean_cr = 0.5
    while not problem.spent:
        f = draw_factors(mean_f, POPULATION, rng)
        cr = np.clip(rng.normal(mean_cr, SPREAD, POPULATION), 0.0, 1.0)
        trials = current_to_pbest(x, fitness, archive, f, cr, BEST_SHARE, rng)
        trial_fitness = problem.evaluate(trials)
        better = trial_fitness < fitness
        archive = trimmed(np.concatenate([archive, x[better]]), POPULATION, rng)
        x[better], fitness[better] = trials[better], trial_fitness[better]
        if better.any():
            mean_cr += LEARNING_RATE * (float(cr[better].mean()) - mean_cr)
            mean_f += LEARNING_RATE * (lehmer_mean(f[better]) - mean_f)


def draw_factors(mean: Array | float, size: int, rng: np.random.Generator) -> Array:
    """Cauchy(mean, 0.1), cut at 1 and drawn again at 0 or below, (size,)."""
    means = np.broadcast_to(np.asarray(mean, dtype=np.float64), (size,))
    f = means + SPREAD * rng.standard_cauchy(size)
    while (bad := f <= 0.0).any():
        f[bad] = means[bad] + SPREAD * rng.standard_cauchy(int(bad.sum()))
    return np.minimum(f, 1.0)


def current_to_pbest(
    x: Array, fitness: Array, archive: Array, f: Array, cr: Array, share: float,
    rng: np.random.Generator,
) -> Array:  # fmt: skip
    """A trial for each row: x + F (pbest - x) + F (r1 - r2), where r2 may be of the archive."""
    size = len(x)
    leaders = np.argsort(fitness, kind="stable")[: max(2, round(share * size))]
    pbest = x[rng.choice(leaders, size)]
    everyone = np.concatenate([x, archive])
    first, second = two_others(size, rng, len(everyone))
    factor = f[:, None]
    mutants = x + factor * (pbest - x) + factor * (x[first] - everyone[second])
    return binomial_crossover(x, halfway_into_bounds(mutants, x), cr, rng)


def trimmed(archive: Array, size: int, rng: np.random.Generator) -> Array:
    """At most `size` rows of the archive, chosen at random."""
    if len(archive) <= size:
        return archive
    return archive[rng.choice(len(archive), size, replace=False)]


def lehmer_mean(values: Array, weights: Array | float = 1.0) -> float:
    return float(np.sum(weights * values**2) / np.sum(weights * values))
