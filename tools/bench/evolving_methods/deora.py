"""DEORA: Li, Zhang and Wang, *Evolutionary competitive multitasking optimization*, IEEE TEVC 2022:
differential evolution with online resource allocation.

A generation goes to one task. The first share beta of the budget is dealt out evenly; then a task
is chosen by the rewards that it had, newer ones counting more. A mutant of DE/rand/1 takes its base
from another task's population with chance rmp, and its difference from its own. A task from which
bases were taken has a reward too. Where it is as large as that of the task itself rmp grows, else
it shrinks.

The method is for tasks whose values can be compared, and measures the gain of the best against the
best of all tasks. The tasks here cannot be compared: each gain is a share of the task's own best.
"""

from __future__ import annotations

import numpy as np

from .operators import binomial_crossover, halfway_into_bounds
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
    mating = np.full((tasks, tasks), MATING / max(1, tasks - 1))
    np.fill_diagonal(mating, 1.0 - MATING if tasks > 1 else 1.0)
    step = 1.0 / generations(problem)
    history: list[Array] = []
    while not problem.spent:
        even = problem.progress < EVEN_SHARE or not history
        k = int(rng.integers(tasks) if even else rng.choice(tasks, p=chances(np.array(history))))
        trials, bases = _trials(rows, k, mating[k], rng)
        trial_fitness = problem.evaluate(trials, k)
        before = fitness[k]
        better = trial_fitness < before
        rows[k] = np.where(better[:, None], trials, rows[k])
        fitness[k] = np.where(better, trial_fitness, before)
        history.append(rewards(before, fitness[k], bases, k, tasks))
        mating[k] = changed(mating[k], history[-1], k, step)


def generations(problem: Problem) -> float:
    """How many the budget allows when all tasks have as many."""
    cost = float(np.mean([task.cost for task in problem.tasks]))
    affordable = problem.limit / cost if cost > 0.0 else problem.most_evaluations
    return max(1.0, min(affordable, problem.most_evaluations) / PER_TASK)


def chances(history: Array) -> Array:
    """The chance of each task (K,) by the rewards of all generations (G, K)."""
    tasks = history.shape[1]
    weights = FORGETTING ** np.arange(len(history) - 1, -1, -1.0)
    mean = weights @ history / weights.sum()
    if mean.sum() <= 0.0:
        return np.full(tasks, 1.0 / tasks)
    return LEAST_CHANCE / tasks + (1.0 - LEAST_CHANCE) * mean / mean.sum()


def rewards(before: Array, after: Array, bases: Array, k: int, tasks: int) -> Array:
    """The reward of each task (tasks,) for a generation of task k, by the fitness before and after
    it (P,) and the task of each trial's base (P,)."""
    gains = (before - after) / np.maximum(np.abs(before), 1e-12)
    leader = int(np.argmin(after))
    best = max(0.0, float(before.min() - after.min())) / max(abs(float(before.min())), 1e-12)
    found = np.zeros(tasks)
    for task in range(tasks):
        own = np.ones(len(bases), dtype=bool) if task == k else bases == task
        if own.any():
            found[task] = BEST_WEIGHT * best * own[leader] + (1.0 - BEST_WEIGHT) * (
                float(gains[own].mean())
            )
    return found


def changed(mating: Array, reward: Array, k: int, step: float) -> Array:
    """The chances of each task to give task k a base, (K,), after a generation of it."""
    made = mating.copy()
    for task in range(len(made)):
        if task != k:
            change = step if reward[task] >= reward[k] else -step
            made[task], made[k] = np.clip([made[task] + change, made[k] - change], 0.0, 1.0)
    return made


def _trials(
    rows: list[Array], k: int, mating: Array, rng: np.random.Generator
) -> tuple[Array, Array]:
    """DE/rand/1/bin of task k, and the task that each base is of."""
    x = rows[k]
    bases = rng.choice(len(rows), size=len(x), p=mating / mating.sum())
    keys = rng.random((len(x), len(x)))
    np.fill_diagonal(keys, 2.0)  # never the row itself
    base, first, second = np.argsort(keys, axis=1)[:, :3].T
    origin = np.stack(rows)[bases, base]
    mutants = origin + FACTOR * (x[first] - x[second])
    return binomial_crossover(x, halfway_into_bounds(mutants, x), CROSSOVER, rng), bases
