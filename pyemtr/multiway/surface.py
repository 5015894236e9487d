"""A scan's surface as the graph needs it: evenly thinned points with normals, and colors."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats
from ..neighborhood import spacing, surface_normals

#: Points of a scan that are kept for the pairs to try and for the joint refinement.
SURFACE_POINTS = 8000


@dataclass(frozen=True, eq=False)
class Surface:
    """Thinned points of one scan, in its frame and unit.

    Attributes:
        points, normals: float64 (N, 3); the normals are of unit length and of either sign.
        leaf: edge of the voxels that were averaged.
        spacing: median distance of a point to its nearest neighbor.
    """

    points: Floats
    normals: Floats
    leaf: float
    spacing: float


def make_surface(points: Floats, radius: float) -> Surface:
    """Returns about SURFACE_POINTS averages of finite points (N, 3)."""
    leaf = 0.01 * radius
    thinned = thin(points, leaf)
    while len(thinned) > 1.2 * SURFACE_POINTS:
        leaf *= min(max(np.sqrt(len(thinned) / SURFACE_POINTS), 1.05), 2.0)
        thinned = thin(points, leaf)
    return Surface(thinned, surface_normals(thinned), leaf, spacing(thinned))


def thin(points: Floats, leaf: float) -> Floats:
    """Returns the average of the points (N, 3) of each occupied voxel, sorted by voxel."""
    keys = voxel_keys(points, leaf, points.min(axis=0))
    _, index, counts = np.unique(keys, return_inverse=True, return_counts=True)
    sums = [np.bincount(index, weights=column, minlength=len(counts)) for column in points.T]
    return np.asarray(np.stack(sums, axis=1) / counts[:, None])


_BITS = 21  # of a voxel's index along an axis


def voxel_keys(points: Floats, leaf: float, origin: Floats) -> NDArray[np.int64]:
    """Returns one number (N,) for the voxel of each point.

    Raises ValueError when the points span more than two million voxels along an axis.
    """
    cells = np.floor((points - origin) / leaf)
    half = 2 ** (_BITS - 1)
    if not (np.abs(cells) < half).all():
        raise ValueError(
            f"voxel: {leaf:g} is too small for points that span {np.ptp(points, axis=0).max():g}"
        )
    x, y, z = (cells.astype(np.int64) + half).T
    return np.asarray((x << (2 * _BITS)) | (y << _BITS) | z)
