"""Cases by the name of their scene, those whose colors are wrong on purpose too."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from .held_out import HELD_OUT
from .paint import Array, Generator
from .prints import mosaic
from .scenes import SCENES, Case, floor, wall

#: Scenes in which no pose is right.
NONE_RIGHT = ("unrelated", "unmarked", "hotel")
OTHER = 1000  # between the seeds of two scenes that do not belong together


def case_of(scene: str, seed: int) -> Case:
    """Makes the case of this seed."""
    if scene == "unmarked":
        return floor(seed, marks=0)
    if scene == "unrelated":
        return _mismatched(wall(seed), wall(seed + OTHER))
    if scene in SCENES:
        return SCENES[scene](seed)
    if scene in HELD_OUT:
        return HELD_OUT[scene](_generator(scene, seed))
    fault, kind = scene.split("-")
    case = case_of(kind, seed)
    if fault == "unrelated":
        return _mismatched(case, case_of(kind, seed + OTHER))
    rng = _generator(scene, seed)
    return replace(case, source_colors=FAULTS[fault](case.source, rng),
                   target_colors=FAULTS[fault](case.target, rng))  # fmt: skip


def none_right(scene: str) -> bool:
    """Tells whether the two scans do not belong together, or nothing tells how."""
    return scene in NONE_RIGHT or scene.startswith("unrelated-")


def _generator(scene: str, seed: int) -> Generator:
    return np.random.default_rng([*scene.encode(), seed])


def _mismatched(one: Case, other: Case) -> Case:
    return replace(one, target=other.target, target_colors=other.target_colors,
                   target_intensity=other.target_intensity)  # fmt: skip


def _constant(points: Array, rng: Generator) -> Array:
    return np.tile(rng.uniform(0, 1, 3), (len(points), 1))


def _random(points: Array, rng: Generator) -> Array:
    return rng.uniform(0, 1, points.shape)


def _painted(points: Array, rng: Generator) -> Array:
    """A mosaic over the two longest axes of the cloud."""
    center = points.mean(axis=0)
    axes = np.linalg.svd(points - center, full_matrices=False)[2][:2]
    places = (points - center) @ axes.T
    extent = float(np.ptp(places, axis=0).max())
    return mosaic(extent * rng.uniform(0.04, 0.1), 1.5 * extent, rng)(places)


FAULTS: dict[str, Callable[[Array, Generator], Array]] = {
    "constant": _constant, "random": _random, "painted": _painted,
}  # fmt: skip
