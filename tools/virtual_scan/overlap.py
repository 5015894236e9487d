"""Resolution and overlap of clouds, by brute force on a sample of the points."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def _every(points: Array, count: int) -> Array:
    return points[:: max(1, len(points) // count)]


def _nearest(queries: Array, points: Array, rank: int, chunk: int = 64) -> Array:
    """Distance (N,) of each query to its nearest point, or to the second nearest (rank 1)."""
    squares = np.sum(points**2, axis=1)
    result = []
    for i in range(0, len(queries), chunk):
        part = queries[i : i + chunk]
        squared = squares - 2 * part @ points.T
        least = np.partition(squared, rank, axis=1)[:, rank] if rank else squared.min(axis=1)
        result.append(least + np.sum(part**2, axis=1))
    return np.asarray(np.sqrt(np.maximum(np.concatenate(result), 0)))


def resolution(points: Array, sample: int = 600) -> float:
    """Mean distance of a point (N, 3) to its nearest neighbor, in the points' unit."""
    return float(_nearest(_every(points, sample), points, rank=1).mean())


def overlap(points: Array, others: Array, radius: float, sample: int = 3000) -> float:
    """Share of `points` (N, 3) with one of `others` (M, 3) within `radius`; one frame."""
    return float((_nearest(_every(points, sample), others, rank=0) <= radius).mean())
