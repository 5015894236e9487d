"""Spacing and tangent planes of a point cloud, for drawing it. Needs scipy."""

from __future__ import annotations

from typing import Any

import numpy as np

from .arrays import Floats

_NEIGHBORS = 14  # that fit a point's tangent plane


def neighbor_tree(points: Floats) -> Any:
    """Returns scipy's cKDTree of points (N, 3)."""
    from scipy.spatial import cKDTree

    return cKDTree(points)


def surface_normals(points: Floats) -> Floats:
    """Returns unit normals (N, 3) of the planes through each point's neighbors, of either sign."""
    count = min(_NEIGHBORS, len(points))
    _, neighbors = neighbor_tree(points).query(points, k=[i + 1 for i in range(count)])
    patches = points[neighbors]
    patches = patches - patches.mean(axis=1, keepdims=True)
    covariances = np.einsum("nki,nkj->nij", patches, patches)
    return np.asarray(np.linalg.eigh(covariances)[1][:, :, 0], dtype=np.float64)


def spacing(points: Floats) -> float:
    """Returns the median distance of points (N, 3) to their nearest neighbor; 0 for one point."""
    if len(points) < 2:
        return 0.0
    some = points[:: max(1, len(points) // 20000)]
    return float(np.median(neighbor_tree(points).query(some, k=2)[0][:, 1]))


def subsampled(points: Floats, count: int) -> Floats:
    """Returns at most ``count`` of the points, evenly spaced over their rows."""
    if len(points) <= count:
        return points
    return points[np.linspace(0, len(points) - 1, count).astype(np.int64)]
