"""L-SHADE: Tanabe and Fukunaga, *Improving the search performance of SHADE using linear population
size reduction*, IEEE CEC 2014. A single task; a control that the paper does not have.
"""

from __future__ import annotations

import numpy as np

from .jade import SPREAD, current_to_pbest, draw_factors, lehmer_mean, trimmed
from .problem import Problem

PER_DIMENSION, SMALLEST = 18, 4  # population at first and at last
MEMORY = 6
BEST_SHARE, ARCHIVE_SHARE = 0.11, 2.6


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    n = problem.tasks[0].dimensions
    largest = PER_DIMENSION * n
    x = rng.random((largest, n))
    fitness = problem.evaluate(x)
    archive = np.empty((0, n))
    memory_f, memory_cr, place = np.full(MEMORY, 0.5), np.full(MEMORY, 0.5), 0
    while not problem.spent:
        chosen = rng.integers(MEMORY, size=len(x))
        f = draw_factors(memory_f[chosen], len(x), rng)
        cr = np.clip(rng.normal(memory_cr[chosen], SPREAD), 0.0, 1.0)
        trials = current_to_pbest(x, fitness, archive, f, cr, BEST_SHARE, rng)
        trial_fitness = problem.evaluate(trials)
        better = trial_fitness < fitness
        if better.any():
            gain = fitness[better] - trial_fitness[better]
            weights = gain / gain.sum() if np.isfinite(gain).all() else 1.0
            memory_f[place] = lehmer_mean(f[better], weights)
            if cr[better].max() > 0.0:
                memory_cr[place] = lehmer_mean(cr[better], weights)
            place = (place + 1) % MEMORY
        archive = np.concatenate([archive, x[better]])
        x[better], fitness[better] = trials[better], trial_fitness[better]
        size = round(largest + (SMALLEST - largest) * problem.progress)
        kept = np.argsort(fitness, kind="stable")[: max(SMALLEST, size)]
        x, fitness = x[kept], fitness[kept]
        archive = trimmed(archive, round(ARCHIVE_SHARE * len(x)), rng)
