"""Signed distance to the sample shape, and its normals. Array-wise, numpy only.

The distance is a lower bound in magnitude rather than exact (tapered capsules, smooth joins,
relief), which is what sphere tracing with a slightly shortened step needs.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from . import shape

Array = NDArray[np.floating]


def _segments(polylines: Sequence[Sequence[tuple[float, ...]]]) -> tuple[Array, Array]:
    ends = np.array([(a, b) for line in polylines for a, b in zip(line, line[1:])])
    return ends[:, 0], ends[:, 1]


def _spikes() -> tuple[Array, Array]:
    roots = np.array([root for root, _, _ in shape.SPIKES])
    lengths = np.array([[length] for _, length, _ in shape.SPIKES])
    ways = np.array([way for _, _, way in shape.SPIKES])
    tips = roots + lengths * ways / np.linalg.norm(ways, axis=1, keepdims=True)
    return np.hstack([roots, 0.27 * lengths]), np.hstack([tips, np.full_like(lengths, 0.003)])


def _boulder() -> tuple[Array, Array]:
    """Facets of the rock as unit normals (F, 3) and offsets (F,)."""
    rng = np.random.default_rng(11)
    count = 34
    height = 1 - (2 * np.arange(count) + 1) / count
    azimuth = np.pi * (3 - np.sqrt(5)) * np.arange(count)
    ring = np.sqrt(1 - height**2)
    normals = np.stack([ring * np.cos(azimuth), ring * np.sin(azimuth), height], axis=1)
    normals += rng.normal(0, 0.12, normals.shape)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    # the support function of an ellipsoid, each facet pushed in or out a little
    offsets = np.linalg.norm(normals * [0.39, 0.36, 0.25], axis=1) * rng.uniform(0.86, 1.02, count)
    return normals, offsets + normals @ [0.02, 0.0, 0.04]


def _membrane(corners: Sequence[tuple[float, ...]]) -> tuple[Array, Array, Array]:
    """Center (3,), axes (3, 3) with the normal last, and corners in the plane (C, 2)."""
    points = np.array(corners)
    center = points.mean(axis=0)
    axes = np.linalg.svd(points - center)[2]
    return center, axes, (points - center) @ axes[:2].T


SKIN = _segments(shape.LIMBS)
DETAIL = _segments(shape.DETAILS)
SPIKE = _spikes()
BOULDER = _boulder()
SPREAD = (*_membrane(shape.SPREAD[0]), shape.SPREAD[1])
FOLDED = (*_membrane(shape.FOLDED[0]), shape.FOLDED[1])


def _capsules(points: Array, ends: tuple[Array, Array]) -> Array:
    """Distance of each point to each tapered capsule, (N, K)."""
    a, b = (end.astype(points.dtype) for end in ends)
    along = b[:, :3] - a[:, :3]
    square = np.maximum(np.sum(along**2, axis=1), 1e-12)
    dot = points @ along.T - np.sum(a[:, :3] * along, axis=1)
    share = np.clip(dot / square, 0, 1)
    # |p - a - h (b - a)|^2, expanded so that the heavy part is matrix products
    squared = points @ (-2 * a[:, :3].T) + np.sum(a[:, :3] ** 2, axis=1)
    squared += np.sum(points**2, axis=1)[:, None]
    squared -= share * (2 * dot - share * square)
    share *= b[:, 3] - a[:, 3]
    return np.asarray(np.sqrt(np.maximum(squared, 0)) - (a[:, 3] + share))


def _smooth_minimum(distances: Array, width: float) -> Array:
    least = distances.min(axis=1)
    shares = np.exp((least[:, None] - distances) / width)
    return np.asarray(least - width * np.log(shares.sum(axis=1)))


def _join(first: Array, second: Array, width: float) -> Array:
    blend = np.maximum(width - np.abs(first - second), 0) / width
    return np.asarray(np.minimum(first, second) - 0.25 * width * blend**2)


def _wing(points: Array, wing: tuple[Array, Array, Array, int]) -> Array:
    center, axes, corners = (part.astype(points.dtype) for part in wing[:3])
    local = (points - center) @ axes.T
    plane, height = local[:, :2], local[:, 2]
    veins = 0.0025 * np.sin(45 * plane[:, 0] + 20 * plane[:, 1])
    distance = np.abs(height - 0.4 * np.sum(plane**2, axis=1) + 0.02 + veins) - 0.007
    for i, corner in enumerate(corners):
        edge = corners[(i + 1) % len(corners)] - corner
        length = float(np.hypot(*edge))
        outward = np.array([edge[1], -edge[0]], dtype=edge.dtype) / length
        if outward @ (corner + 0.5 * edge) < 0:
            outward = -outward
        distance = np.maximum(distance, (plane - corner) @ outward)
        if i >= wing[3]:
            sagitta = 0.22 * length
            radius = (length**2 / 4 + sagitta**2) / (2 * sagitta)
            middle = corner + 0.5 * edge + (radius - sagitta) * outward
            distance = np.maximum(distance, radius - np.linalg.norm(plane - middle, axis=1))
    return np.asarray(distance)


def _signed_distance(p: Array) -> Array:
    x, y, z = p.T
    skin = _smooth_minimum(_capsules(p, SKIN), 0.016)
    waves = np.sin(52 * x + 30 * z) * np.sin(52 * y - 34 * z) * np.sin(40 * z + 25 * (x - y))
    belly = np.clip(-8 * (y + 0.02), 0, 1) * np.clip(8 * (0.72 - z), 0, 1)
    skin += 0.006 * (np.abs(waves) - belly * np.abs(np.sin(75 * z + 10 * x)))  # scales, plates
    skin = _join(skin, _capsules(p, SPIKE).min(axis=1), 0.012)
    skin = _join(skin, _capsules(p, DETAIL).min(axis=1), 0.004)
    skin = _join(skin, np.minimum(_wing(p, SPREAD), _wing(p, FOLDED)), 0.01)
    facets, offsets = (part.astype(p.dtype) for part in BOULDER)
    rock = -_smooth_minimum(offsets - p @ facets.T, 0.005)
    rock += 0.008 * np.sin(17 * x + 9 * y + 5 * z) * np.sin(11 * y - 14 * z)
    rock += 0.003 * np.sin(41 * x - 23 * z) * np.sin(37 * y + 29 * z)
    return _join(skin, np.maximum(rock, -z), 0.012)


def signed_distance(points: Array, chunk: int = 2048) -> Array:
    """Signed distance (N,) in mm of points (N, 3) in mm; negative inside.

    Computed in the precision of `points`; float32 is good to about 0.003 mm.
    """
    parts = [
        _signed_distance(points[i : i + chunk] / shape.MILLIMETRES) * shape.MILLIMETRES
        for i in range(0, len(points), chunk)
    ]
    return np.concatenate(parts) if parts else np.empty(0, points.dtype)


def normals(points: Array, step: float = 0.05) -> Array:
    """Unit normals (N, 3) of the surface, outward, by differences over a tetrahedron."""
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], dtype=np.float64)
    slopes = np.stack([signed_distance(points + step * corner) for corner in corners], axis=1)
    gradient = slopes @ corners
    return np.asarray(gradient / np.linalg.norm(gradient, axis=1, keepdims=True))
