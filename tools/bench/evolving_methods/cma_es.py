"""CMA-ES by the package ``cma`` (Hansen), restarted with twice the population when it has converged
(Auger and Hansen 2005). A single task; a control that the paper does not have.
"""

from __future__ import annotations

import numpy as np

from .problem import Problem

SIGMA = 0.3  # of the box


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    try:
        import cma
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(
            "CMA-ES needs the package cma: pip install '.[reproduce]'", name=error.name
        ) from error
    n, size = problem.tasks[0].dimensions, 4 + int(3 * np.log(problem.tasks[0].dimensions))
    while not problem.spent:
        options = {"bounds": [0.0, 1.0], "popsize": size, "verbose": -9,
                   "seed": int(rng.integers(1, 2**31)), "verb_log": 0}  # fmt: skip
        search = cma.CMAEvolutionStrategy(rng.random(n), SIGMA, options)
        while not problem.spent and not search.stop():
            rows = np.array(search.ask())
            fitness = problem.evaluate(rows)
            if not np.isfinite(fitness).all():
                return  # the budget ended within the population
            search.tell(list(rows), fitness.tolist())
        size *= 2
