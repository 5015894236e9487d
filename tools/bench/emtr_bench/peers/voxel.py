"""The voxel size of a pair: the same rule for every library that wants one."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_STEPS = 30  # of the bisection; far below any difference that a library would notice


def voxel_size(source: Array, target: Array, points: int) -> float:
    """The voxel, in the clouds' unit, that leaves `points` in both together, as nearly as may be;
    of clouds that have fewer, one about as fine as their spacing."""
    clouds = (source, target)
    low, high = (share * max(_diagonal(c) for c in clouds) for share in (1e-4, 1.0))
    points = min(points, (len(source) + len(target)) // 2)
    for _ in range(_STEPS):
        middle = math.sqrt(low * high)
        if sum(occupied(cloud, middle) for cloud in clouds) > points:
            low = middle
        else:
            high = middle
    return high


def occupied(points: Array, voxel: float) -> int:
    """Returns the number of voxels with points in them."""
    cells = np.floor((points - points.min(axis=0)) / voxel).astype(np.int64)
    _, rows, columns = cells.max(axis=0) + 1
    return len(np.unique((cells[:, 0] * rows + cells[:, 1]) * columns + cells[:, 2]))


def _diagonal(points: Array) -> float:
    return float(np.linalg.norm(np.ptp(points, axis=0)))
