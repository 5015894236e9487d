"""APSO: Zhan, Zhang, Li and Chung, *Adaptive particle swarm optimization*, IEEE TSMC-B 2009.
A single task.

The distances between the particles say in which of four states the swarm is; the inertia weight and
the two pulls follow. In convergence the best particle makes a random jump along one gene.
Where two states are possible, the swarm stays in its own if that is one of them, else the next in
the cycle exploration, exploitation, convergence, jumping-out is taken.
"""

from __future__ import annotations

import numpy as np

from .problem import Array, Problem

POPULATION = 50
VELOCITY_LIMIT = 0.2
PULLS = (1.5, 2.5)  # bounds of c1 and c2, whose sum is at most 4
RATE = (0.05, 0.1)  # of their change
JUMP_START, JUMP_END = 1.0, 0.1  # sigma of the elitist learning
EXPLORATION, EXPLOITATION, CONVERGENCE, JUMPING_OUT = range(4)


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    n = problem.tasks[0].dimensions
    x = rng.random((POPULATION, n))
    v = rng.uniform(-VELOCITY_LIMIT, VELOCITY_LIMIT, x.shape)
    best, best_fitness = x.copy(), problem.evaluate(x)
    c, state = np.array([2.0, 2.0]), EXPLORATION
    while not problem.spent:
        leader = int(np.argmin(best_fitness))
        factor = evolutionary_factor(x, leader)
        state = next_state(factor, state)
        c = adapted(c, state, rng.uniform(*RATE))
        if state == CONVERGENCE:
            _jump(problem, best, best_fitness, leader, rng)
        w = 1.0 / (1.0 + 1.5 * np.exp(-2.6 * factor))
        r1, r2 = rng.random((2, POPULATION, n))
        guide = best[np.argmin(best_fitness)]
        v = np.clip(w * v + c[0] * r1 * (best - x) + c[1] * r2 * (guide - x),
                    -VELOCITY_LIMIT, VELOCITY_LIMIT)  # fmt: skip
        x = np.clip(x + v, 0.0, 1.0)
        fitness = problem.evaluate(x)
        better = fitness < best_fitness
        best[better], best_fitness[better] = x[better], fitness[better]


def evolutionary_factor(x: Array, leader: int) -> float:
    """0 when the best particle is in the middle of the others, 1 when it is far from them."""
    distances = np.linalg.norm(x[:, None] - x[None], axis=2).sum(axis=1) / (len(x) - 1)
    low, high = distances.min(), distances.max()
    return float((distances[leader] - low) / (high - low)) if high > low else 0.0


def memberships(f: float) -> Array:
    """How far each of the four states holds, (4,)."""
    corners = (
        ([0.4, 0.6, 0.7, 0.8], [0.0, 1.0, 1.0, 0.0]),
        ([0.2, 0.3, 0.4, 0.6], [0.0, 1.0, 1.0, 0.0]),
        ([0.1, 0.3], [1.0, 0.0]),
        ([0.7, 0.9], [0.0, 1.0]),
    )
    return np.array([np.interp(f, *corner) for corner in corners])


def next_state(f: float, state: int) -> int:
    degrees = memberships(f)
    for candidate in (state, (state + 1) % 4):
        if degrees[candidate] > 0.0:
            return candidate
    return int(np.argmax(degrees))


def adapted(c: Array, state: int, rate: float) -> Array:
    """c1 and c2 (2,) after one generation in a state."""
    change = {
        EXPLORATION: (rate, -rate),
        EXPLOITATION: (0.5 * rate, -0.5 * rate),
        CONVERGENCE: (0.5 * rate, 0.5 * rate),
        JUMPING_OUT: (-rate, rate),
    }[state]
    moved = np.clip(c + np.array(change), *PULLS)
    return moved * (4.0 / moved.sum()) if moved.sum() > 4.0 else moved


def _jump(
    problem: Problem, best: Array, best_fitness: Array, leader: int, rng: np.random.Generator
) -> None:
    """Elitist learning: one gene of the best jumps; what is better takes its place, what is not
    takes the place of the worst."""
    sigma = JUMP_START - (JUMP_START - JUMP_END) * problem.progress
    jumped = best[leader].copy()
    gene = rng.integers(len(jumped))
    jumped[gene] = np.clip(jumped[gene] + rng.normal(0.0, sigma), 0.0, 1.0)
    fitness = float(problem.evaluate(jumped[None])[0])
    place = leader if fitness < best_fitness[leader] else int(np.argmax(best_fitness))
    if np.isfinite(fitness):
        best[place], best_fitness[place] = jumped, fitness
