"""MTEA-AD: Wang, Liu, Wu and Wu, *Solving multitask optimization problems with adaptive knowledge
transfer via anomaly detection*, IEEE TEVC 2022.

Each task has a population of its own. With chance 0.1 a task learns a normal distribution of its
offspring, and of the other tasks' individuals takes those which are most likely under it. The share
that it takes is that of the last ones which survived; at first it takes all.
"""

from __future__ import annotations

import numpy as np

from .operators import best_of, genetic_offspring
from .problem import Array, Problem

PER_TASK = 50
TRANSFER = 0.1


def optimise(problem: Problem, rng: np.random.Generator) -> None:
    tasks = range(len(problem.tasks))
    rows = [rng.random((PER_TASK, problem.dimensions)) for _ in tasks]
    fitness = [problem.evaluate(rows[k], k) for k in tasks]
    share = [1.0 for _ in tasks]
    while not problem.spent:
        for k in tasks:
            children = genetic_offspring(rows[k], rng)
            taken = np.empty((0, problem.dimensions))
            if rng.random() < TRANSFER:
                others = np.concatenate([rows[j] for j in tasks if j != k] or [taken])
                taken = usual(others, children, share[k], problem.tasks[k].dimensions)
            new = np.concatenate([children, taken])
            new_fitness = problem.evaluate(new, k)
            rows[k], fitness[k] = best_of((rows[k], fitness[k]), (new, new_fitness), PER_TASK)
            if len(taken):
                limit = fitness[k][-1]
                share[k] = float(np.mean(new_fitness[len(children) :] <= limit))


def usual(candidates: Array, known: Array, share: float, dimensions: int) -> Array:
    """The share of the candidates (Q, n) that is most likely under a normal distribution of the
    known rows (P, n); one at least. Only the genes that the task has are judged."""
    if not len(candidates):
        return candidates
    count = max(1, round(share * len(candidates)))
    genes = known[:, :dimensions]
    covariance = np.cov(genes, rowvar=False).reshape(dimensions, dimensions)
    inverse = np.linalg.pinv(covariance + 1e-10 * np.eye(dimensions))
    away = candidates[:, :dimensions] - genes.mean(axis=0)
    distance = np.einsum("ij,jk,ik->i", away, inverse, away)
    return candidates[np.argsort(distance, kind="stable")[:count]]
