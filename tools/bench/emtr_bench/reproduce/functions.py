"""The evolving methods on functions whose optimum is known: each can be seen to be right."""

from __future__ import annotations

from typing import Any

import numpy as np
from evolving_methods import test_functions
from evolving_methods.methods import Method
from evolving_methods.problem import Problem

from . import public_methods

DIMENSIONS, EVALUATIONS = 10, 10000
SEEDS = 5
REACH = {"sphere": 100.0, "rastrigin": 5.0}
#: Two functions alone, then the pairs of tasks that the multi-task methods are for.
NAMES = (*REACH, *test_functions.PAIRS)


def run(method: Method | str, name: str, seed: int) -> dict[str, Any]:
    """The best value that a method, or one of public_methods, finds of the first task with
    EVALUATIONS for each task; every optimum is 0."""
    if isinstance(method, str):
        problem = problem_of(name, 1)
        public_methods.run(method, problem, seed)
    else:
        problem = problem_of(name, len(method.tasks))
        method.load()(problem, np.random.default_rng(seed))
    return {"value": problem.tasks[0].best_fitness, "E_R": None}


def problem_of(name: str, tasks: int) -> Problem:
    """A single task, or the pair; of a function alone the multi-task methods get two, the second
    with rotated axes."""
    if name in test_functions.PAIRS:
        both = test_functions.pair(name, EVALUATIONS)
        if tasks > 1:
            return both
        return Problem(both.tasks[:1], EVALUATIONS, EVALUATIONS)
    function = getattr(test_functions, name)
    made = [
        test_functions.task(f"{name} {i}", function, DIMENSIONS, REACH[name], 0.2, i or None)
        for i in range(min(2, tasks))
    ]
    return Problem(made, len(made) * EVALUATIONS, len(made) * EVALUATIONS)
