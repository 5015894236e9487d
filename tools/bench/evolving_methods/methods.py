"""Which methods there are, which tasks each drives, and where anybody's own comes in."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .problem import Problem

Optimise = Callable[[Problem, np.random.Generator], None]

ALPHA, BETA, SPARSE = "alpha", "beta", "alpha sparse"
SINGLE, MULTI = "single task", "multi-task"


@dataclass(frozen=True)
class Method:
    """`place` is module:function. `tasks` are in the order of the problem; the first is solved."""

    name: str
    place: str
    kind: str
    tasks: tuple[str, ...]
    in_paper: bool = True
    package: str = ""  # of PyPI, that it needs beside numpy

    @property
    def missing(self) -> bool:
        """The package is not there."""
        return bool(self.package) and importlib.util.find_spec(self.package) is None

    def load(self) -> Optimise:
        """Raises ValueError when there is no such function."""
        module, _, function = self.place.partition(":")
        try:
            found = getattr(importlib.import_module(module), function)
        except (ImportError, AttributeError) as error:
            raise ValueError(f"{self.place}: {error}") from error
        if not callable(found):
            raise ValueError(f"{self.place}: expected a function optimise(problem, rng)")
        optimise: Optimise = found
        return optimise


def _of(
    name: str, file: str, kind: str, *tasks: str, in_paper: bool = True, package: str = ""
) -> Method:
    return Method(name, f"evolving_methods.{file}:optimise", kind, tasks, in_paper, package)


METHODS = (
    _of("PSO", "pso", SINGLE, ALPHA),
    _of("JADE", "jade", SINGLE, ALPHA),
    _of("APSO", "apso", SINGLE, ALPHA),
    _of("MFEA", "mfea", MULTI, ALPHA, BETA),
    _of("MFEA-II", "mfea2", MULTI, ALPHA, BETA),
    _of("MTEA-AD", "mtea_ad", MULTI, ALPHA, BETA),
    _of("EMFPCR", "emfpcr", MULTI, ALPHA, SPARSE),
    _of("DEORA", "deora", MULTI, ALPHA, BETA),
)
CONTROLS = (
    _of("CMA-ES", "cma_es", SINGLE, ALPHA, in_paper=False, package="cma"),
    _of("L-SHADE", "l_shade", SINGLE, ALPHA, in_paper=False),
)


def user_method(text: str) -> Method:
    """A method of the user's own, `module:function`, which gets all three tasks. Raises
    ValueError for another text."""
    module, colon, function = text.partition(":")
    if not module or not colon or not function:
        raise ValueError(f"expected MODULE:FUNCTION, got {text!r}")
    return Method(text, text, MULTI, (ALPHA, BETA, SPARSE), in_paper=False)
