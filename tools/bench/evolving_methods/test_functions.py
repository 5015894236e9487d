"""Functions with known optima, to see that a method is what its paper says.

The pairs are made like those of the CEC 2017 competition on evolutionary multitasking: two
functions whose optima are in the same place, in nearly the same, or apart, with rotated axes.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .problem import Array, Problem, Task


def sphere(x: Array) -> Array:
    return np.asarray((x**2).sum(axis=1))


def rastrigin(x: Array) -> Array:
    return np.asarray((x**2 - 10.0 * np.cos(2.0 * np.pi * x) + 10.0).sum(axis=1))


def ackley(x: Array) -> Array:
    root = np.sqrt((x**2).mean(axis=1))
    waves = np.cos(2.0 * np.pi * x).mean(axis=1)
    return np.asarray(20.0 - 20.0 * np.exp(-0.2 * root) + np.e - np.exp(waves))


def griewank(x: Array) -> Array:
    index = np.sqrt(np.arange(1, x.shape[1] + 1))
    return np.asarray((x**2).sum(axis=1) / 4000.0 - np.cos(x / index).prod(axis=1) + 1.0)


def task(
    name: str, function: Callable[[Array], Array], n: int, reach: float,
    optimum: float = 0.0, rotated: int | None = None,
) -> Task:  # fmt: skip
    """A function in the box [-reach, reach]^n with its optimum at `optimum` times the reach."""
    axes = np.eye(n)
    if rotated is not None:
        axes = np.linalg.qr(np.random.default_rng(rotated).normal(size=(n, n)))[0]
    middle = np.full(n, optimum * reach)
    return Task(
        name, np.full(n, -reach), np.full(n, reach), lambda x: function((x - middle) @ axes.T)
    )


def single(function: Callable[[Array], Array], n: int, evaluations: int) -> Problem:
    reach = {"sphere": 100.0, "rastrigin": 5.0, "ackley": 50.0, "griewank": 100.0}
    name = function.__name__
    return Problem([task(name, function, n, reach[name], 0.2)], evaluations, evaluations)


#: name: (dimensions of each task, optimum of each, rotation of each)
PAIRS = {
    "same place": ((10, 10), (0.4, 0.4), (1, 1)),
    "nearly the same place": ((10, 10), (0.4, 0.38), (1, 2)),
    "apart": ((10, 10), (0.4, -0.4), (1, 2)),
    "of other size": ((10, 5), (0.4, 0.4), (1, None)),
}


def pair(name: str, evaluations: int) -> Problem:
    """Ackley, which is to be solved, and Griewank beside it, with a budget for each."""
    sizes, optima, rotations = PAIRS[name]
    tasks = [task("ackley", ackley, sizes[0], 50.0, optima[0], rotations[0]),
             task("griewank", griewank, sizes[1], 100.0, optima[1], rotations[1])]  # fmt: skip
    return Problem(tasks, 2 * evaluations, 2 * evaluations)
