"""EMTR-SSC itself over the same batched fitness: the paper's Algorithm 1 in Python.

It shows what the engine does in a page of code, and gives what the engine does not report: the best
rotation of task beta. It is also where readings of the paper are tried, for its tasks may have any
fitness. The tasks are alpha on the dense clouds, beta, and alpha on the sparse clouds;
`problem.complement` is Algorithm 2.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from . import pso
from .problem import Array, Problem

DENSE, BETA, SPARSE = range(3)
ANGLES = 3


@dataclass(frozen=True)
class Settings:
    """Those of the paper; the velocity limit is in ranges of a gene."""

    population: int = 50
    iterations: int = 100
    transfer_probability: float = 0.7  # rmp
    switch_fraction: float = 0.6  # delta
    lambda_alpha: tuple[float, float] = (0.1, 0.7)
    lambda_beta: tuple[float, float] = (0.999, 0.199)
    velocity_limit: float = 0.5
    last_velocity_limit: float | None = None  # what it falls to in the dense stage; None: the same
    adaptive: bool = False  # rmp from the success of transfers, delta from stagnation


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    _Evolution(problem, rng, Settings()).run()


def optimise_adaptive(problem: Problem, rng: np.random.Generator) -> None:
    """The same with a success history of rmp, and the switch where the sparse stage stagnates."""
    _Evolution(problem, rng, replace(Settings(), adaptive=True)).run()


def optimise_with(problem: Problem, rng: np.random.Generator, settings: Settings) -> None:
    _Evolution(problem, rng, settings).run()


class _Swarm:
    """Particles in the unified space. Angles are periodic and fly on; translations stop."""

    def __init__(self, size: int, n: int, limit: float, rng: np.random.Generator) -> None:
        self.x = rng.random((size, n))
        self.v = rng.uniform(-limit, limit, self.x.shape)
        self.best, self.best_fitness = self.x.copy(), np.full(size, np.inf)

    @property
    def leader(self) -> int:
        return int(np.argmin(self.best_fitness))

    def update(self, fitness: Array) -> bool:
        """Tells whether the best of all has changed."""
        before = self.best_fitness.min()
        better = fitness < self.best_fitness
        self.best[better], self.best_fitness[better] = self.x[better], fitness[better]
        return bool(self.best_fitness.min() < before)

    def move(self, guide: Array, w: float, limit: float, rng: np.random.Generator) -> None:
        r1, r2 = rng.random((2, *self.x.shape))
        pull = pso.COGNITIVE * r1 * (self.best - self.x) + pso.SOCIAL * r2 * (guide - self.x)
        self.v = np.clip(w * self.v + pull, -limit, limit)
        self.x = self.x + self.v
        walls = self.x[:, ANGLES:]
        self.v[:, ANGLES:][(walls < 0.0) | (walls > 1.0)] = 0.0
        self.x[:, ANGLES:] = np.clip(walls, 0.0, 1.0)


class _Evolution:
    def __init__(self, problem: Problem, rng: np.random.Generator, settings: Settings) -> None:
        self.problem, self.rng, self.settings = problem, rng, settings
        limit = settings.velocity_limit
        self.poses = _Swarm(settings.population, 2 * ANGLES, limit, rng)
        self.rotations = _Swarm(settings.population, ANGLES, limit, rng)
        self.resolution = SPARSE
        self.translation: Array | None = None  # of the knowledge complement
        self.beta_changed = False
        self.rates = np.array([settings.transfer_probability])
        self.last_gain = 0

    def run(self) -> None:
        s = self.settings
        for it in range(s.iterations):
            if self.resolution == SPARSE and self._switch_is_due(it):
                self._switch()
            better = self.poses.update(self.problem.evaluate(self.poses.x, self.resolution))
            self.last_gain = it if better else self.last_gain
            self.beta_changed |= self.rotations.update(
                self.problem.evaluate(self.rotations.x, BETA)
            )
            self._move(it)

    def _switch_is_due(self, it: int) -> bool:
        s = self.settings
        due = it >= int(np.ceil(s.switch_fraction * s.iterations - 1e-9))
        stagnates = s.adaptive and it - self.last_gain > s.iterations // 10
        return due or (stagnates and it > s.iterations // 3)

    def _switch(self) -> None:
        self.resolution = DENSE
        self.poses.best_fitness = self.problem.evaluate(self.poses.best, DENSE)

    def _move(self, it: int) -> None:
        s = self.settings
        done = it / s.iterations
        w = pso.INERTIA_START + (pso.INERTIA_END - pso.INERTIA_START) * done
        guides = self.poses.best[self.poses.leader], self.rotations.best[self.rotations.leader]
        rate = float(np.clip(self.rng.normal(self.rates.mean(), 0.1), 0.05, 1.0))
        rate = rate if s.adaptive else s.transfer_probability
        transferred = self.rng.random() < rate
        if transferred:
            guides = self._transfer(done, *guides)
        limit = s.velocity_limit
        if s.last_velocity_limit is not None and self.resolution == DENSE:
            share = (done - s.switch_fraction) / max(1.0 - s.switch_fraction, 1e-9)
            limit *= (s.last_velocity_limit / limit) ** float(np.clip(share, 0.0, 1.0))
        self.poses.move(guides[0], w, limit, self.rng)
        self.rotations.move(guides[1], w, s.velocity_limit, self.rng)
        if s.adaptive and self.last_gain == it:  # what was drawn in an iteration that gained
            self.rates = np.append(self.rates, rate)[-10:]

    def _transfer(self, done: float, pose: Array, rotation: Array) -> tuple[Array, Array]:
        """The guides: means of both bests, of the aliases of the angles that are nearest."""
        alpha, beta = self.problem.tasks[DENSE], self.problem.tasks[BETA]
        if self.translation is None or self.beta_changed:
            angles = beta.decode(rotation[None])[0]
            t = self.problem.complement(angles)
            self.translation = (t - alpha.lower[ANGLES:]) / (
                alpha.upper[ANGLES:] - alpha.lower[ANGLES:]
            )
            self.beta_changed = False
        la, lb = (
            start + (end - start) * done
            for start, end in (self.settings.lambda_alpha, self.settings.lambda_beta)
        )
        guide = np.concatenate([
            la * pose[:ANGLES] + (1 - la) * _nearest_alias(rotation, pose[:ANGLES]),
            la * pose[ANGLES:] + (1 - la) * self.translation,
        ])  # fmt: skip
        back = lb * rotation + (1 - lb) * _nearest_alias(pose[:ANGLES], rotation)
        return guide, back


def _nearest_alias(unit: Array, to: Array) -> Array:
    """The Euler angles of the same rotation that are nearest to others, all in the unified space,
    where the ranges are 2 pi, pi and 2 pi."""
    ranges = np.array([2.0, 1.0, 2.0]) * np.pi
    lower = -0.5 * ranges
    a, goal = lower + unit * ranges, lower + to * ranges
    aliases = (a, np.array([a[0] + np.pi, np.pi - a[1], a[2] + np.pi]))
    near = [alias + 2.0 * np.pi * np.round((goal - alias) / (2.0 * np.pi)) for alias in aliases]
    chosen = min(near, key=lambda alias: float(np.abs(alias - goal).sum()))
    return (chosen - lower) / ranges
