"""MFEA-II: Bali, Ong, Gupta and Tan, *Multifactorial evolutionary algorithm with online transfer
parameter estimation*, IEEE TEVC 2020.

MFEA whose rmp is learned in each generation: of each task's population a product of normal
distributions is made, and rmp is the weight at which the mixtures of both explain both populations
best. Parents of different skill that do not mate across tasks mate within their own.
"""

from __future__ import annotations

import numpy as np

from .mfea import first_generation, next_generation
from .operators import polynomial_mutation, simulated_binary_crossover
from .problem import Array, Problem

RANDOM_SHARE = 0.1  # of random samples, which keep the model from being too narrow
NOISE = 0.01  # of the learned rmp
GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    tasks = len(problem.tasks)
    x, skill, fitness = first_generation(problem, rng)
    while not problem.spent:
        mating = np.zeros((tasks, tasks))
        for k in range(tasks):
            for j in range(k + 1, tasks):
                shared = min(problem.tasks[k].dimensions, problem.tasks[j].dimensions)
                rmp = learned_mating(x[skill == k, :shared], x[skill == j, :shared], tasks, rng)
                mating[k, j] = mating[j, k] = rmp
        children, child_skill = _offspring(x, skill, mating, rng)
        x, skill, fitness = next_generation(problem, x, skill, fitness, children, child_skill)


def learned_mating(a: Array, b: Array, tasks: int, rng: np.random.Generator) -> float:
    """rmp of two tasks from their populations (P, d) and (Q, d): maximum likelihood of the
    mixtures, found by golden-section search in [0, 1], with a little noise."""
    if min(len(a), len(b)) < 2:
        return 0.0
    models = [_model(population, rng) for population in (a, b)]
    likelihoods = [[_likelihood(p, model) for model in models] for p in (a, b)]

    def cost(rmp: float) -> float:
        own, other = 1.0 - 0.5 * (tasks - 1) * rmp / tasks, 0.5 * (tasks - 1) * rmp / tasks
        mixtures = (
            own * likelihoods[0][0] + other * likelihoods[0][1],
            own * likelihoods[1][1] + other * likelihoods[1][0],
        )
        return float(-sum(np.log(np.maximum(m, 1e-300)).sum() for m in mixtures))

    low, high = 0.0, 1.0
    while high - low > 1e-3:
        inner, outer = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        low, high = (low, outer) if cost(inner) < cost(outer) else (inner, high)
    return float(np.clip(0.5 * (low + high) + rng.normal(0.0, NOISE), 0.0, 1.0))


def _model(population: Array, rng: np.random.Generator) -> tuple[Array, Array]:
    """Mean and standard deviation of each gene, random samples among them."""
    extra = rng.random((int(RANDOM_SHARE * len(population)), population.shape[1]))
    both = np.concatenate([population, extra])
    return both.mean(axis=0), np.maximum(both.std(axis=0), 1e-8)


def _likelihood(population: Array, model: tuple[Array, Array]) -> Array:
    mean, deviation = model
    z = (population - mean) / deviation
    exponent = -0.5 * (z**2).sum(axis=1) - np.log(deviation * np.sqrt(2.0 * np.pi)).sum()
    return np.exp(np.minimum(exponent, 700.0))


def _offspring(
    x: Array, skill: Array, mating: Array, rng: np.random.Generator
) -> tuple[Array, Array]:
    order = rng.permutation(len(x))
    half = len(x) // 2
    a, b = order[:half], order[half : 2 * half]
    same = skill[a] == skill[b]
    across = ~same & (rng.random(half) < mating[skill[a], skill[b]])
    mates = [np.where(same | across, other, _mates(own, skill, rng))
             for own, other in ((a, b), (b, a))]  # fmt: skip
    first, second = simulated_binary_crossover(x[a], x[b], rng)
    alone = [simulated_binary_crossover(x[own], x[mate], rng)[0]
             for own, mate in ((a, mates[0]), (b, mates[1]))]  # fmt: skip
    crossed = (same | across)[:, None]
    children = np.concatenate(
        [np.where(crossed, first, alone[0]), np.where(crossed, second, alone[1])]
    )
    either = rng.random((2, half)) < 0.5
    skills = [np.where(across & either[0], skill[b], skill[a]),
              np.where(across & either[1], skill[a], skill[b])]  # fmt: skip
    return polynomial_mutation(children, rng), np.concatenate(skills)


def _mates(own: Array, skill: Array, rng: np.random.Generator) -> Array:
    """For each row a random row of the same skill."""
    mates = np.empty(len(own), dtype=np.int64)
    for k in np.unique(skill[own]):
        mine = skill[own] == k
        mates[mine] = rng.choice(np.flatnonzero(skill == k), int(mine.sum()))
    return mates
