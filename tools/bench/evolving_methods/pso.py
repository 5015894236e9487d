"""PSO: Kennedy and Eberhart, *Particle swarm optimization*, 1995, with the inertia weight of Shi
and Eberhart 1998 falling from 0.9 to 0.4. A single task.

The velocity limit is half of a gene's range, as that of EMTR-SSC's own swarms here. A particle
stops at the box.
"""

from __future__ import annotations

import numpy as np

from .problem import Problem

POPULATION = 50
INERTIA_START, INERTIA_END = 0.9, 0.4
COGNITIVE = SOCIAL = 1.49445
VELOCITY_LIMIT = 0.5


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    n = problem.tasks[0].dimensions
    x = rng.random((POPULATION, n))
    v = rng.uniform(-VELOCITY_LIMIT, VELOCITY_LIMIT, x.shape)
    best, best_fitness = x.copy(), problem.evaluate(x)
    while not problem.spent:
        w = INERTIA_START + (INERTIA_END - INERTIA_START) * problem.progress
        r1, r2 = rng.random((2, POPULATION, n))
        leader = best[np.argmin(best_fitness)]
        v = w * v + COGNITIVE * r1 * (best - x) + SOCIAL * r2 * (leader - x)
        v = np.clip(v, -VELOCITY_LIMIT, VELOCITY_LIMIT)
        x = x + v
        outside = (x < 0.0) | (x > 1.0)
        x, v = np.clip(x, 0.0, 1.0), np.where(outside, 0.0, v)
        fitness = problem.evaluate(x)
        better = fitness < best_fitness
        best[better], best_fitness[better] = x[better], fitness[better]
