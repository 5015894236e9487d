"""Variation operators that several methods share; all over the unified space [0, 1]."""

from __future__ import annotations

import numpy as np

from .problem import Array

#: Simulated binary crossover and polynomial mutation as the MFEA paper sets them.
CROSSOVER_INDEX, MUTATION_INDEX = 2.0, 5.0


def simulated_binary_crossover(
    a: Array, b: Array, rng: np.random.Generator, index: float = CROSSOVER_INDEX
) -> tuple[Array, Array]:
    """Two children (P, n) of parents (P, n): Deb and Agrawal 1995."""
    u = rng.random(a.shape)
    spread = np.where(
        u <= 0.5,
        (2.0 * u) ** (1.0 / (index + 1.0)),
        (0.5 / np.maximum(1.0 - u, 1e-300)) ** (1.0 / (index + 1.0)),
    )
    first = 0.5 * ((1.0 + spread) * a + (1.0 - spread) * b)
    second = 0.5 * ((1.0 - spread) * a + (1.0 + spread) * b)
    return np.clip(first, 0.0, 1.0), np.clip(second, 0.0, 1.0)


def polynomial_mutation(x: Array, rng: np.random.Generator, index: float = MUTATION_INDEX) -> Array:
    """Rows (P, n) of which each gene changes with chance 1 / n."""
    u = rng.random(x.shape)
    power = 1.0 / (index + 1.0)
    down = ((2.0 * u) ** power - 1.0) * x
    up = (1.0 - (2.0 * (1.0 - u)) ** power) * (1.0 - x)
    changed = np.where(u <= 0.5, x + down, x + np.where(u > 0.5, up, 0.0))
    chosen = rng.random(x.shape) < 1.0 / x.shape[1]
    return np.where(chosen, np.clip(changed, 0.0, 1.0), x)


def genetic_offspring(parents: Array, rng: np.random.Generator) -> Array:
    """As many children as parents (P, n): random pairs, crossover, then mutation."""
    order = rng.permutation(len(parents))
    half = (len(parents) + 1) // 2
    mothers, fathers = parents[order[:half]], parents[order[-half:]]
    children = np.concatenate(simulated_binary_crossover(mothers, fathers, rng))
    return polynomial_mutation(children[: len(parents)], rng)


def best_of(
    first: tuple[Array, Array], second: tuple[Array, Array], size: int
) -> tuple[Array, Array]:
    """The `size` best rows of two (rows, fitness), and their fitness, best first."""
    rows = np.concatenate([first[0], second[0]])
    fitness = np.concatenate([first[1], second[1]])
    order = np.argsort(fitness, kind="stable")[:size]
    return rows[order], fitness[order]


def binomial_crossover(
    parents: Array, mutants: Array, rate: Array | float, rng: np.random.Generator
) -> Array:
    """Rows (P, n) with each gene of the mutant by chance `rate`, and one gene at least."""
    from_mutant = rng.random(parents.shape) < np.reshape(rate, (-1, 1))
    sure = rng.integers(parents.shape[1], size=len(parents))
    from_mutant[np.arange(len(parents)), sure] = True
    return np.where(from_mutant, mutants, parents)


def halfway_into_bounds(mutants: Array, parents: Array) -> Array:
    """Genes beyond a bound are put halfway between it and the parent's, as JADE does."""
    repaired = np.where(mutants < 0.0, 0.5 * parents, mutants)
    return np.where(mutants > 1.0, 0.5 * (1.0 + parents), repaired)


def two_others(
    size: int, rng: np.random.Generator, among: int | None = None
) -> tuple[Array, Array]:
    """For each of `size` rows two different rows but itself; the second of the first `among`
    rows of a longer list, when that is given."""
    own = np.arange(size)
    first = (own + rng.integers(1, size, size)) % size
    second = rng.integers(among or size, size=size)
    while (bad := (second == own) | (second == first)).any():
        second[bad] = rng.integers(among or size, size=int(bad.sum()))
    return first, second
