"""A synthetic pair of clouds with features, partial overlap and a known transformation."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Pair(NamedTuple):
    source: np.ndarray  # float64 (n, 3)
    target: np.ndarray  # float64 (m, 3)
    truth: np.ndarray  # float64 (4, 4), source into target


def lump(rng: np.random.Generator, count: int) -> np.ndarray:
    """Points on a lumpy, lopsided egg: always the same surface, sampled by `rng`."""
    fixed = np.random.default_rng(7)
    centers = directions(fixed, 60)
    heights = fixed.uniform(0.1, 0.25, 60) * fixed.choice([-1, 1], 60)
    widths = fixed.uniform(0.12, 0.3, 60)
    at = directions(rng, count)
    angle = np.arccos(np.clip(at @ centers.T, -1, 1))
    radius = 1 + (heights * np.exp(-((angle / widths) ** 2))).sum(axis=1)
    return at * radius[:, None] * [1.0, 0.8, 0.65]


def directions(rng: np.random.Generator, count: int) -> np.ndarray:
    vectors = rng.normal(size=(count, 3))
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def random_rotation(rng: np.random.Generator) -> np.ndarray:
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else q[:, ::-1]


def random_transformation(rng: np.random.Generator, reach: float = 2.0) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, :3] = random_rotation(rng)
    matrix[:3, 3] = rng.uniform(-reach, reach, 3)
    return matrix


def apply(matrix: np.ndarray, points: np.ndarray) -> np.ndarray:
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def make_pair(seed: int, count: int = 9000, scale: float = 1.0, offset: float = 0.0) -> Pair:
    """Either scan misses a cap of the egg, at opposite ends; both are sampled anew, with noise.

    `scale` is the unit of both clouds, `offset` moves the target far from the origin.
    """
    rng = np.random.default_rng(seed)
    source, target = lump(rng, count), lump(rng, count)
    source, target = source[source[:, 0] > -0.5], target[target[:, 0] < 0.5]
    source = source + rng.normal(scale=0.002, size=source.shape)
    target = target + rng.normal(scale=0.002, size=target.shape)
    truth = random_transformation(rng)
    target = apply(truth, target) * scale + offset
    truth[:3, 3] = truth[:3, 3] * scale + offset
    return Pair(source * scale, target, truth)


def bits(result) -> bytes:
    """Everything of a pyemtr.Result that the seed decides."""
    poses = [alternative.transformation for alternative in result.alternatives]
    arrays = [
        result.transformation,
        result.information,
        result.hessian_eigenvalues,
        result.hessian_eigenvectors,
        result.history["alpha"],
        result.history["beta"],
        *poses,
    ]
    numbers = [
        result.fitness,
        result.inlier_ratio_source,
        result.inlier_ratio_target,
        result.fitness_gap,
        result.overlap_source,
        result.overlap_target,
        result.leaf_fine,
        result.inlier_rmse,
        result.inlier_rmse_plane,
        result.confidence,
        result.score,
        result.surface_fit,
        result.violation,
        result.score_gap,
        result.seeds,
        result.candidates,
        *[value for alternative in result.alternatives for value in alternative[1:]],
    ]
    return b"".join(array.tobytes() for array in [*arrays, np.array(numbers, dtype=float)])


def rotation_error(a: np.ndarray, b: np.ndarray) -> float:
    """Degrees between the rotations of two transformations; tiny angles keep their digits."""
    gap = np.linalg.norm(a[:3, :3] - b[:3, :3]) / (2 * np.sqrt(2))
    return float(np.degrees(2 * np.arcsin(min(gap, 1.0))))


def centroid_error(a: np.ndarray, b: np.ndarray, points: np.ndarray) -> float:
    """Returns the distance between the centroids that two transformations give."""
    center = points.mean(axis=0, keepdims=True)
    return float(np.linalg.norm(apply(a, center) - apply(b, center)))
