"""Tasks with a budget: what a method may ask for, how often, and what it has seen.

All tasks are searched in one unified space, as evolutionary multitasking does it: a row of genes
in [0, 1], of which a task of d dimensions takes the first d and spreads them over its own box.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: Genes in the task's own box, (P, d), to fitness (P,), lower is better.
Fitness = Callable[[Array], Array]


@dataclass
class Task:
    """One fitness function over a box. `cost` is what one evaluation takes from the budget."""

    name: str
    lower: Array  # (d,)
    upper: Array  # (d,)
    fitness: Fitness
    cost: int = 1
    best_fitness: float = np.inf
    best_genes: Array | None = None  # (d,), in the task's own box
    evaluations: int = 0
    history: list[tuple[int, float]] = field(default_factory=list)  # (spent, best) as it improves

    @property
    def dimensions(self) -> int:
        return len(self.lower)

    def decode(self, unit: Array) -> Array:
        """Rows of the unified space, (P, >= d), as genes of this task, (P, d)."""
        return self.lower + unit[:, : self.dimensions] * (self.upper - self.lower)

    def encode(self, genes: Array) -> Array:
        """The inverse of `decode`, (P, d)."""
        return (genes - self.lower) / (self.upper - self.lower)


class Problem:
    """The tasks of one run, the first of which is the one that is to be solved.

    The budget is `limit` units of cost. Tasks without a cost are held to `most_evaluations` of all
    tasks together, so that every run ends.
    """

    def __init__(
        self,
        tasks: Sequence[Task],
        limit: int,
        most_evaluations: int,
        complement: Callable[[Array], Array] | None = None,
    ) -> None:
        if not tasks or limit <= 0 or most_evaluations <= 0:
            raise ValueError("expected a task, and a budget above 0")
        self.tasks = list(tasks)
        self.limit = limit
        self.most_evaluations = most_evaluations
        self._complement = complement
        self.used = 0
        self.evaluations = 0

    @property
    def dimensions(self) -> int:
        """Genes of the unified space: as many as the largest task has."""
        return max(task.dimensions for task in self.tasks)

    @property
    def progress(self) -> float:
        """The share of the budget that is used, from 0 to 1."""
        return min(1.0, max(self.used / self.limit, self.evaluations / self.most_evaluations))

    @property
    def spent(self) -> bool:
        """The task that is to be solved cannot be evaluated once more."""
        return self._affordable(self.tasks[0]) == 0

    def complement(self, angles: Array) -> Array:
        """The translation (3,) that completes a rotation of task beta (3,): Algorithm 2 of the
        paper. Raises ValueError for a problem that is no registration."""
        if self._complement is None:
            raise ValueError("this problem has no knowledge complement")
        return self._complement(angles)

    def evaluate(self, unit: Array, task: int = 0) -> Array:
        """The fitness of rows (P, n) of the unified space for one task, (P,). Rows beyond the
        budget are not evaluated and have the fitness infinity."""
        chosen = self.tasks[task]
        count = min(len(unit), self._affordable(chosen))
        fitness = np.full(len(unit), np.inf)
        if count == 0:
            return fitness
        genes = chosen.decode(np.asarray(unit[:count], dtype=np.float64))
        fitness[:count] = chosen.fitness(genes)
        self.used += count * chosen.cost
        self.evaluations += count
        chosen.evaluations += count
        best = int(np.argmin(fitness[:count]))
        if fitness[best] < chosen.best_fitness:
            chosen.best_fitness, chosen.best_genes = float(fitness[best]), genes[best].copy()
            chosen.history.append((self.used, chosen.best_fitness))
        return fitness

    def _affordable(self, task: Task) -> int:
        """How many more evaluations of a task the budget allows."""
        left = self.most_evaluations - self.evaluations
        return left if task.cost == 0 else min(left, (self.limit - self.used) // task.cost)
