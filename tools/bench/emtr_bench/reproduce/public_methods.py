"""The same methods by mealpy, a public library: what ours are put beside on known functions."""

from __future__ import annotations

import importlib.util
from typing import Any

from evolving_methods.problem import Problem

PACKAGE = "mealpy"
#: Name here: module and class of mealpy.
CLASSES = {
    "PSO by mealpy": ("swarm_based.PSO", "OriginalPSO"),
    "JADE by mealpy": ("evolutionary_based.DE", "JADE"),
    "L-SHADE by mealpy": ("evolutionary_based.SHADE", "L_SHADE"),
}
#: What they run on: they have a single task, and one pair of tasks is like another to them.
FUNCTIONS = ("sphere", "rastrigin", "same place")
POPULATION = 50


def there() -> bool:
    return importlib.util.find_spec(PACKAGE) is not None


def run(method: str, problem: Problem, seed: int) -> None:
    """Spends the problem's budget on its first task."""
    from mealpy import FloatVar

    module, name = CLASSES[method]
    made: Any = getattr(importlib.import_module(f"{PACKAGE}.{module}"), name)
    search = made(epoch=max(1, problem.limit // POPULATION - 1), pop_size=POPULATION)
    n = problem.tasks[0].dimensions
    search.solve(
        {
            "obj_func": lambda row: float(problem.evaluate(row[None])[0]),
            "bounds": FloatVar(lb=[0.0] * n, ub=[1.0] * n),
            "minmax": "min",
            "log_to": None,
        },
        seed=seed,
    )
