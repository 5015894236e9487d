"""The points of a cloud that a page shows: evenly spread, 16 bits a coordinate.

``tools/pcl_emtr/html/point_block.cpp`` does the same in the command, to the same bits.
"""

from __future__ import annotations

import base64
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats

Rows = NDArray[np.int64]
LEVELS = 65535
_LOOKED_AT = 8  # times as many points as are shown are spread in space


@dataclass(frozen=True)
class PointBlock:
    """Chosen points of a cloud.

    Attributes:
        points: float64 (n, 3), in the cloud's frame and unit.
        steps: uint16 (n, 3): the points are near origin + step * steps.
        origin, step: in the cloud's unit.
        total: the number of points of the cloud.
    """

    points: Floats
    steps: NDArray[np.uint16]
    origin: Floats
    step: float
    total: int

    def to_json(self) -> dict[str, Any]:
        return {
            "total": self.total,
            "shown": len(self.points),
            "origin": self.origin.tolist(),
            "step": self.step,
            "points": packed(self.steps),
        }


def point_block(points: Floats, center: Floats, radius: float, max_points: int) -> PointBlock:
    """Chooses at most ``max_points`` points, float64 (N, 3), evenly spread in space.

    Left out are points that are not finite, and strays: those farther than ``radius`` from
    ``center``, both of a result's normalization. Where these are not known, no point is a stray.

    Raises ValueError when no point is left.
    """
    keep = np.isfinite(points).all(axis=1)
    if np.isfinite(center).all() and math.isfinite(radius) and radius > 0:
        away = points - center
        with np.errstate(invalid="ignore", over="ignore"):
            x, y, z = away.T
            keep &= x * x + y * y + z * z <= (radius * (1 + 1e-6)) ** 2
    rows = np.flatnonzero(keep).astype(np.int64)
    if not len(rows):
        raise ValueError("expected a cloud with finite points to show, got none")
    rows = rows[jittered(len(rows), _LOOKED_AT * max_points)]
    chosen = points[rows]
    origin = chosen.min(axis=0)
    step = float((chosen.max(axis=0) - origin).max()) / LEVELS or 1.0
    steps = np.clip(np.floor((chosen - origin) / step + 0.5), 0, LEVELS).astype(np.int64)
    spread = spread_rows(steps, max_points)
    return PointBlock(chosen[spread], steps[spread].astype(np.uint16), origin, step, len(points))


def jittered(count: int, wanted: int) -> Rows:
    """Returns ``wanted`` ascending rows of ``count``, one somewhere in each of as many parts; all
    where there are no more. Equal gaps would show as stripes in scans that are grids."""
    if count <= wanted:
        return np.arange(count, dtype=np.int64)
    part = np.arange(wanted, dtype=np.uint64)
    place = (part << np.uint64(8)) + (_mixed(part.astype(np.uint32)) >> np.uint32(24))
    return ((place * np.uint64(count)) // np.uint64(wanted << 8)).astype(np.int64)


def _mixed(numbers: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """The digits of each number mixed, so that neighbors have nothing in common."""
    for factor in (0x7FEB352D, 0x846CA68B):
        numbers = (numbers ^ (numbers >> np.uint32(16))) * np.uint32(factor)
    return numbers ^ (numbers >> np.uint32(16))


def spread_rows(steps: Rows, wanted: int) -> Rows:
    """Returns ascending rows, at most ``wanted``: the first of each cell of the finest grid, by a
    whole number of steps, that has no more cells than that."""
    low, high = 1, LEVELS + 1
    while low < high:
        middle = (low + high) // 2
        if len(np.unique(_cells(steps, middle))) <= wanted:
            high = middle
        else:
            low = middle + 1
    _, first = np.unique(_cells(steps, low), return_index=True)
    return np.sort(first).astype(np.int64)


def _cells(steps: Rows, size: int) -> Rows:
    x, y, z = (steps // size).T
    return np.asarray((x << 32) | (y << 16) | z)


def packed(values: NDArray[np.uint16]) -> str:
    """Base64 of 16-bit numbers, the low byte first."""
    return base64.b64encode(np.ascontiguousarray(values, dtype="<u2").tobytes()).decode("ascii")
