"""The two tasks as functions of particles, for use with another optimizer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .arrays import Floats
from .problem import Problem

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .setting_types import AllSettings

_ANGLES = [(-np.pi, np.pi), (-np.pi / 2, np.pi / 2), (-np.pi, np.pi)]


class TaskAlpha:
    """M-estimator chamfer distance over SE(3), 6 genes (theta1, theta2, theta3, tx, ty, tz).

    Args:
        source_or_problem: a :class:`Problem`, or a source cloud with ``target`` beside it.
        target: the target cloud; None with a Problem.
        resolution: "dense" (both directions) or "sparse" (source to target only).
        **settings: for a new Problem: all arguments of :func:`pyemtr.register` but ``callback``.
    """

    def __init__(
        self,
        source_or_problem: Any,
        target: Any = None,
        resolution: str = "dense",
        **settings: Unpack[AllSettings],
    ) -> None:
        if resolution not in ("sparse", "dense"):
            raise ValueError(f'resolution: expected "sparse" or "dense", got {resolution!r}')
        self.problem: Problem = _problem_of(source_or_problem, target, settings)
        self.resolution: str = resolution

    @property
    def bounds(self) -> Floats:
        """The search box of the swarm: float64 (6, 2), lowest and highest value of each gene.

        The fitness has no such bounds: angles are periodic, translations unlimited.
        """
        reach = float(self.problem.settings["translation_bound"])
        return np.array(_ANGLES + [(-reach, reach)] * 3, dtype=np.float64)

    def evaluate(self, particles: Any) -> Floats:
        """Returns the fitness of particles (P, 6) or (6,): see :meth:`Problem.evaluate_alpha`."""
        return self.problem.evaluate_alpha(particles, self.resolution)


class TaskBeta:
    """Consensus of TIMs over SO(3), 3 genes (theta1, theta2, theta3); arguments as TaskAlpha."""

    def __init__(
        self, source_or_problem: Any, target: Any = None, **settings: Unpack[AllSettings]
    ) -> None:
        self.problem: Problem = _problem_of(source_or_problem, target, settings)

    @property
    def bounds(self) -> Floats:
        """The search box of the swarm: float64 (3, 2)."""
        return np.array(_ANGLES, dtype=np.float64)

    def evaluate(self, particles: Any) -> Floats:
        """Returns the fitness of particles (P, 3) or (3,): see :meth:`Problem.evaluate_beta`."""
        return self.problem.evaluate_beta(particles)


def _problem_of(source_or_problem: Any, target: Any, settings: AllSettings) -> Problem:
    if not isinstance(source_or_problem, Problem):
        if target is None:
            raise TypeError("target: expected a cloud beside the source cloud")
        return Problem(source_or_problem, target, **settings)
    if target is not None or settings:
        raise TypeError("a Problem has its own target and settings; give neither beside it")
    return source_or_problem
