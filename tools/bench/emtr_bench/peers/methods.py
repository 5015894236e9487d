"""Which methods there are: a global search with a refinement after it, or emtr alone."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Task:
    """Arguments of a method beside the clouds."""

    voxel: float  # user's unit
    threads: int
    seed: int
    refine_voxel: float | None = None  # None: what the refinement's library does by itself


#: (source (n, 3), target (m, 3), task) -> pose (4, 4), source into target
Search = Callable[[Array, Array, Task], Array]
#: (source, target, pose to start from, task) -> pose
Refine = Callable[[Array, Array, Array, Task], Array]

#: Name: (module of the library, module here, function).
SEARCHES = {
    "open3d-ransac": ("open3d", "open3d_methods", "ransac"),
    "open3d-fgr": ("open3d", "open3d_fgr", "fast_global_registration"),
    "kiss-matcher": ("kiss_matcher", "kiss_matcher_method", "kiss_matcher_search"),
}
REFINEMENTS = {
    "point-to-plane": ("open3d", "open3d_methods", "point_to_plane_icp"),
    "gicp": ("small_gicp", "small_gicp_method", "gicp"),
}
OURS = "emtr-"


@dataclass(frozen=True)
class Method:
    """`search` is a key of SEARCHES, or "" for emtr with the preset in `refinement`'s place."""

    name: str
    search: str
    refinement: str

    @property
    def ours(self) -> bool:
        return not self.search

    @property
    def modules(self) -> tuple[str, ...]:
        """The libraries that it needs."""
        if self.ours:
            return ("pyemtr",)
        return tuple(dict.fromkeys((SEARCHES[self.search][0], REFINEMENTS[self.refinement][0])))

    def missing(self) -> list[str]:
        return [name for name in self.modules if importlib.util.find_spec(name) is None]

    def load(self) -> Search:
        """Imports the libraries; in the process that is to run it, and in no other."""
        if self.ours:
            return _emtr(self.refinement)
        search: Search = _function(*SEARCHES[self.search][1:])
        refine: Refine = _function(*REFINEMENTS[self.refinement][1:])

        def both(source: Array, target: Array, task: Task) -> Array:
            return refine(source, target, search(source, target, task), task)

        return both


def all_methods(presets: list[str]) -> list[Method]:
    """emtr with each preset, then every search with every refinement."""
    methods = [Method(f"{OURS}{preset}", "", preset) for preset in presets]
    for search in SEARCHES:
        methods += [Method(f"{search}+{refine}", search, refine) for refine in REFINEMENTS]
    return methods


def select(methods: list[Method], names: list[str]) -> list[Method]:
    """Those of these names, where the name of a search stands for all its rows and "emtr" for
    every preset; all of them when no name is given. Raises ValueError for a name of none."""
    for name in names:
        if not any(_is_called(method, name) for method in methods):
            known = ", ".join(method.name for method in methods)
            raise ValueError(f"--only {name}: no such method; there are {known}")
    return [m for m in methods if not names or any(_is_called(m, name) for name in names)]


def _is_called(method: Method, name: str) -> bool:
    return name in (method.name, method.search or OURS.rstrip("-"))


def _function(module: str, name: str) -> Callable[..., Array]:
    found: Callable[..., Array] = getattr(importlib.import_module(f"{__package__}.{module}"), name)
    return found


def _emtr(preset: str) -> Search:
    import pyemtr

    def register(source: Array, target: Array, task: Task) -> Array:
        found = pyemtr.register(source, target, preset=preset, seed=task.seed, threads=task.threads)
        return np.asarray(found.transformation)

    return register
