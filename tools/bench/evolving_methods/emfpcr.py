"""EMFPCR: Wu and others, evolutionary multiform optimization for point cloud registration, 2022:
a robust and a precise fitness function over one search space, with a two-stage transfer.

Its code is not public, and neither are all its formulas. What takes their place here: the robust
fitness is task alpha on the sparse clouds, whose M-estimator is the wider one; the precise fitness
is task alpha on the dense clouds. Each has a swarm as PSO's. In the first half of the budget the
best of the robust swarm go over to the precise one, then the best of each go over to the other.
The arrivals take the places of the worst.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from . import pso
from .problem import Array, Problem

PER_TASK = 50
TRAVELERS = 5  # of a swarm at a time
EVERY = 5  # generations between two transfers
PRECISE, ROBUST = 0, 1
ONE_WAY = 0.5  # share of the budget


@dataclass
class _Swarm:
    task: int
    x: Array
    v: Array
    best: Array
    best_fitness: Array

    def move(self, problem: Problem, rng: np.random.Generator) -> None:
        w = pso.INERTIA_START + (pso.INERTIA_END - pso.INERTIA_START) * problem.progress
        r1, r2 = rng.random((2, *self.x.shape))
        leader = self.best[np.argmin(self.best_fitness)]
        pull = pso.COGNITIVE * r1 * (self.best - self.x) + pso.SOCIAL * r2 * (leader - self.x)
        v = np.clip(w * self.v + pull, -pso.VELOCITY_LIMIT, pso.VELOCITY_LIMIT)
        x = self.x + v
        outside = (x < 0.0) | (x > 1.0)
        self.x, self.v = np.clip(x, 0.0, 1.0), np.where(outside, 0.0, v)
        self._keep(self.x, problem.evaluate(self.x, self.task), np.arange(len(x)))

    def receive(self, travelers: Array, problem: Problem) -> None:
        worst = np.argsort(self.best_fitness, kind="stable")[-len(travelers) :]
        self._keep(travelers, problem.evaluate(travelers, self.task), worst)

    def leaders(self) -> Array:
        return self.best[np.argsort(self.best_fitness, kind="stable")[:TRAVELERS]].copy()

    def _keep(self, x: Array, fitness: Array, places: Array) -> None:
        better = fitness < self.best_fitness[places]
        self.best[places[better]] = x[better]
        self.best_fitness[places[better]] = fitness[better]


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    swarms = [_swarm(problem, task, rng) for task in (PRECISE, ROBUST)]
    generation = 0
    while not problem.spent:
        for swarm in swarms:
            swarm.move(problem, rng)
        generation += 1
        if generation % EVERY:
            continue
        robust, precise = swarms[ROBUST].leaders(), swarms[PRECISE].leaders()
        swarms[PRECISE].receive(robust, problem)
        if problem.progress >= ONE_WAY:
            swarms[ROBUST].receive(precise, problem)


def _swarm(problem: Problem, task: int, rng: np.random.Generator) -> _Swarm:
    x = rng.random((PER_TASK, problem.dimensions))
    v = rng.uniform(-pso.VELOCITY_LIMIT, pso.VELOCITY_LIMIT, x.shape)
    return _Swarm(task, x, v, x.copy(), problem.evaluate(x, task))
