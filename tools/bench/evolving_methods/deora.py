"""DEORA: Li, Zhang and Wang, *Evolutionary competitive multitasking optimization*, IEEE TEVC 2022:
differential evolution with online resource allocation.

A generation goes to one task. The first share beta of the budget is dealt out evenly; then a task
is chosen by the rewards that it had, newer ones counting more. Mutants of DE/rand/1 take their
difference from the other task with chance rmp.

The paper's formula for the change of rmp is not public in full. Here rmp is 2 rmp0 times the share
of the crossed trials which survived, over that share and the one of the others together.
"""

from __future__ import annotations

import numpy as np

from .operators import binomial_crossover, halfway_into_bounds, two_others
from .problem import Array, Problem

PER_TASK = 50
FACTOR, CROSSOVER = 0.5, 0.9
BEST_WEIGHT = 0.5  # alpha: of the best's gain in the reward, beside the population's
EVEN_SHARE = 0.2  # beta
FORGETTING = 0.85  # gamma
LEAST_CHANCE = 0.1  # Pmin
MATING = 0.3  # rmp0


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    tasks = len(problem.tasks)
    rows = [rng.random((PER_TASK, problem.dimensions)) for _ in range(tasks)]
    fitness = [problem.evaluate(rows[k], k) for k in range(tasks)]
    mating = np.full(tasks, MATING)
    rewards: list[Array] = []
    while not problem.spent:
        if problem.progress < EVEN_SHARE or not rewards:
            k = int(rng.integers(tasks))
        else:
            k = int(rng.choice(tasks, p=chances(np.array(rewards))))
        trials, crossed = _trials(rows, k, mating[k], rng)
        trial_fitness = problem.evaluate(trials, k)
        before = fitness[k].copy()
        better = trial_fitness < fitness[k]
        rows[k] = np.where(better[:, None], trials, rows[k])
        fitness[k] = np.where(better, trial_fitness, fitness[k])
        reward = np.zeros(tasks)
        reward[k] = BEST_WEIGHT * _gain(before.min(), fitness[k].min()) + (1.0 - BEST_WEIGHT) * (
            float(np.mean([_gain(*pair) for pair in zip(before, fitness[k])]))
        )
        rewards.append(reward)
        mating[k] = _mating(better, crossed, mating[k])


def chances(rewards: Array) -> Array:
    """The chance of each task (K,) by the rewards of all generations (G, K)."""
    tasks = rewards.shape[1]
    weights = FORGETTING ** np.arange(len(rewards) - 1, -1, -1.0)
    mean = weights @ rewards / weights.sum()
    if mean.sum() <= 0.0:
        return np.full(tasks, 1.0 / tasks)
    return LEAST_CHANCE / tasks + (1.0 - LEAST_CHANCE) * mean / mean.sum()


def _trials(
    rows: list[Array], k: int, mating: float, rng: np.random.Generator
) -> tuple[Array, Array]:
    """DE/rand/1/bin of task k, and which trials had another task's difference."""
    x = rows[k]
    first, second = two_others(len(x), rng)
    third = rng.integers(len(x), size=len(x))
    crossed = rng.random(len(x)) < (mating if len(rows) > 1 else 0.0)
    difference = x[second] - x[third]
    if crossed.any():
        other = rows[int(rng.choice([j for j in range(len(rows)) if j != k]))]
        a, b = two_others(len(x), rng)
        difference = np.where(crossed[:, None], other[a] - other[b], difference)
    mutants = x[first] + FACTOR * difference
    return binomial_crossover(x, halfway_into_bounds(mutants, x), CROSSOVER, rng), crossed


def _gain(before: float, after: float) -> float:
    """How much better, as a share."""
    return max(0.0, float(before - after)) / max(abs(float(before)), 1e-12)


def _mating(better: Array, crossed: Array, now: float) -> float:
    if not crossed.any() or crossed.all():
        return now
    with_other, alone = float(better[crossed].mean()), float(better[~crossed].mean())
    if with_other + alone == 0.0:
        return now
    return float(np.clip(2.0 * MATING * with_other / (with_other + alone), 0.05, 1.0))
