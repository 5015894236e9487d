"""MFEA: Gupta, Ong and Feng, *Multifactorial evolution: toward evolutionary multitasking*, IEEE
TEVC 2016.

One population for all tasks. Each individual has a skill factor, the task that it is best at, and
is evaluated for that one alone. Parents of different skill mate with chance rmp; their children
take the skill of either.
"""

from __future__ import annotations

import numpy as np

from .operators import polynomial_mutation, simulated_binary_crossover
from .problem import Array, Problem

PER_TASK = 50
MATING = 0.3  # rmp


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    x, skill, fitness = first_generation(problem, rng)
    while not problem.spent:
        children, child_skill = offspring(x, skill, MATING, rng)
        x, skill, fitness = next_generation(problem, x, skill, fitness, children, child_skill)


def first_generation(problem: Problem, rng: np.random.Generator) -> tuple[Array, Array, Array]:
    """Random individuals, evaluated for all tasks: (P, n), their skill and their fitness in it."""
    tasks = len(problem.tasks)
    x = rng.random((PER_TASK * tasks, problem.dimensions))
    costs = np.stack([problem.evaluate(x, k) for k in range(tasks)], axis=1)
    skill = skills(costs, rng)
    return x, skill, costs[np.arange(len(x)), skill]


def next_generation(
    problem: Problem, x: Array, skill: Array, fitness: Array, children: Array, child_skill: Array
) -> tuple[Array, Array, Array]:
    """The survivors of parents and children; the children are evaluated for their skill alone."""
    tasks = len(problem.tasks)
    child_fitness = np.full(len(children), np.inf)
    for k in range(tasks):
        mine = child_skill == k
        if mine.any():
            child_fitness[mine] = problem.evaluate(children[mine], k)
    return survivors(
        np.concatenate([x, children]),
        np.concatenate([skill, child_skill]),
        np.concatenate([fitness, child_fitness]),
        len(x), tasks,
    )  # fmt: skip


def ranks(costs: Array) -> Array:
    """The factorial rank of each individual in each task, (P, K), from 0."""
    return np.argsort(np.argsort(costs, axis=0, kind="stable"), axis=0, kind="stable")


def skills(costs: Array, rng: np.random.Generator) -> Array:
    """The task that each individual ranks best in, (P,); a random one of those of equal rank."""
    return np.argmin(ranks(costs) + rng.random(costs.shape), axis=1)


def offspring(
    x: Array, skill: Array, mating: float, rng: np.random.Generator
) -> tuple[Array, Array]:
    """Children (P, n) of random pairs, and their skill: assortative mating."""
    order = rng.permutation(len(x))
    half = len(x) // 2
    a, b = order[:half], order[half : 2 * half]
    cross = (skill[a] == skill[b]) | (rng.random(half) < mating)
    first, second = simulated_binary_crossover(x[a], x[b], rng)
    first = np.where(cross[:, None], first, polynomial_mutation(x[a], rng))
    second = np.where(cross[:, None], second, polynomial_mutation(x[b], rng))
    either = rng.random((2, half)) < 0.5
    first_skill = np.where(cross & either[0], skill[b], skill[a])
    second_skill = np.where(cross & either[1], skill[a], skill[b])
    return np.concatenate([first, second]), np.concatenate([first_skill, second_skill])


def survivors(
    x: Array, skill: Array, fitness: Array, size: int, tasks: int
) -> tuple[Array, Array, Array]:
    """Those of the best rank, each among the individuals of its own skill."""
    rank = np.empty(len(x))
    for k in range(tasks):
        mine = np.flatnonzero(skill == k)
        rank[mine[np.argsort(fitness[mine], kind="stable")]] = np.arange(len(mine))
    chosen = np.argsort(rank, kind="stable")[:size]
    return x[chosen], skill[chosen], fitness[chosen]
