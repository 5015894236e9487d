"""Who solves the cases: emtr, and TEASER++ where it is installed."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import numpy as np

import pyemtr

from .cases import Array, Case

PUBLISHED = """TEASER++ is not installed (module teaserpp_python), so it was not run. What Yang, Shi
and Carlone publish (TEASER: Fast and Certifiable Point Cloud Registration, IEEE T-RO 37, 2021,
abstract): robust to more than 99 % outliers; TEASER++ can run in milliseconds."""


@dataclass(frozen=True)
class Answer:
    pose: Array  # a similarity where the scale was searched
    seconds: float
    registered: bool
    confidence: float


Solver = Callable[[Case], Answer]


def emtr_solver(threads: int, unknown_scale: bool = False) -> Solver:
    def solve(case: Case) -> Answer:
        rows = np.arange(len(case.source))
        begin = perf_counter()
        result = pyemtr.register(
            case.source,
            case.target,
            correspondences=np.column_stack([rows, rows]),
            threads=threads,
            scale="free" if unknown_scale else "fixed",
        )
        seconds = perf_counter() - begin
        return Answer(result.transformation, seconds, result.registered, result.confidence)

    return solve


def teaser_solver(noise: float, unknown_scale: bool = False) -> Solver | None:
    """Returns TEASER++ with the parameters of its own examples, or None when there is none."""
    if importlib.util.find_spec("teaserpp_python") is None:
        return None
    teaser: Any = importlib.import_module("teaserpp_python")

    def solve(case: Case) -> Answer:
        parameters = teaser.RobustRegistrationSolver.Params()
        parameters.cbar2 = 1
        parameters.noise_bound = 5.54 * noise * case.scale
        parameters.estimate_scaling = unknown_scale
        parameters.rotation_gnc_factor = 1.4
        parameters.rotation_max_iterations = 100
        parameters.rotation_cost_threshold = 1e-12
        begin = perf_counter()
        solver = teaser.RobustRegistrationSolver(parameters)
        solver.solve(case.source.T, case.target.T)
        seconds = perf_counter() - begin
        found = solver.getSolution()
        pose = np.eye(4)
        scale = found.scale if unknown_scale else 1.0
        pose[:3, :3], pose[:3, 3] = scale * found.rotation, found.translation
        return Answer(pose, seconds, False, float("nan"))

    return solve
