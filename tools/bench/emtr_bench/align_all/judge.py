"""How many scans of a scene are placed right."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pyemtr.metrics import rotation_error

from ..pairs import Array
from .scenes import Scene

PRECISE = 1.0, 0.01  # degrees, and radii of the scan's centroid
RIGHT = 5.0, 0.06


@dataclass(frozen=True)
class Judged:
    """Counts of scans that can be judged: those whose chain has another one.

    Attributes:
        scans: how many there are.
        precise, right: how many are placed so.
        wrong: how many are placed and are not right against the others of their chain.
        degrees, radii: the median errors of those that are right; NaN where none is.
    """

    scans: int
    precise: int
    right: int
    wrong: int
    degrees: float
    radii: float


def judge(scene: Scene, poses: list[Array | None], models: list[int | None]) -> Judged:
    """Judges poses, scan -> model, and which model each scan is in; None where it is left out."""
    scans = precise = right = wrong = 0
    errors: list[tuple[float, float]] = []
    for chain in sorted(set(scene.chain)):
        members = [i for i, one in enumerate(scene.chain) if one == chain]
        if len(members) < 2:
            continue
        scans += len(members)
        found = [_against(scene, poses, models, members, first) for first in members]
        best = max(found, key=lambda one: _count(one, PRECISE) + 1e-3 * _count(one, RIGHT))
        precise += _count(best, PRECISE)
        good = _count(best, RIGHT)
        right += good
        # One of a chain is always where it is; nothing tells that it is wrong.
        placed = sum(models[i] is not None for i in members)
        wrong += max(placed - max(good, 1), 0)
        errors += [e for e in best if within_limits(e, RIGHT) and e != (0.0, 0.0)]
    medians = np.median(np.array(errors), axis=0) if errors else np.full(2, np.nan)
    return Judged(scans, precise, right, wrong, float(medians[0]), float(medians[1]))


def _against(
    scene: Scene,
    poses: list[Array | None],
    models: list[int | None],
    members: list[int],
    first: int,
) -> list[tuple[float, float]]:
    """The errors of the members of a chain against one of them."""
    found = []
    for scan in members:
        pose, reference = poses[scan], poses[first]
        if pose is None or reference is None or models[scan] != models[first]:
            found.append((np.inf, np.inf))
            continue
        if scan == first:
            found.append((0.0, 0.0))
            continue
        wanted = np.linalg.inv(scene.truth[first]) @ scene.truth[scan]
        apart = np.linalg.inv(wanted) @ np.linalg.inv(reference) @ pose
        center = scene.clouds[scan].mean(axis=0)
        radius = np.linalg.norm(scene.clouds[scan] - center, axis=1).max()
        moved = apart[:3, :3] @ center + apart[:3, 3] - center
        found.append((rotation_error(apart, np.eye(4)), float(np.linalg.norm(moved) / radius)))
    return found


def within_limits(error: tuple[float, float], limits: tuple[float, float]) -> bool:
    """Tells whether an error, degrees and radii, is below the limits."""
    return error[0] < limits[0] and error[1] < limits[1]


def _count(errors: list[tuple[float, float]], limits: tuple[float, float]) -> int:
    """Counts those within the limits; one scan alone is in no place."""
    count = sum(within_limits(error, limits) for error in errors)
    return count if count > 1 else 0
