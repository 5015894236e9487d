"""The method's formulas in plain numpy and float64, by brute force.

Written from the definitions only, to judge the library by; nothing here is fast.
"""

from __future__ import annotations

import numpy as np


def rotation(angles: np.ndarray) -> np.ndarray:
    """R = Rz(theta1) Ry(theta2) Rx(theta3), fixed axes."""
    (ca, sa), (cb, sb), (cg, sg) = ((np.cos(a), np.sin(a)) for a in angles)
    rz = np.array([[ca, -sa, 0], [sa, ca, 0], [0, 0, 1]])
    ry = np.array([[cb, 0, sb], [0, 1, 0], [-sb, 0, cb]])
    rx = np.array([[1, 0, 0], [0, cg, -sg], [0, sg, cg]])
    return rz @ ry @ rx


def nearest(queries: np.ndarray, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Distance to and index of the nearest point, for each query."""
    squared = sum(
        (queries[:, None, axis] - points[None, :, axis]) ** 2 for axis in range(points.shape[1])
    )
    index = squared.argmin(axis=1)
    return np.sqrt(squared[np.arange(len(queries)), index]), index


def rho(r: np.ndarray, c: float) -> np.ndarray:
    """Tukey's biweight, normalized: 1 - (1 - (r/c)^2)^3 within c, else 1."""
    return np.where(r <= c, 1 - (1 - np.minimum(r / c, 1) ** 2) ** 3, 1.0)


def alpha_sparse(particle, source_sparse, target_sparse, c) -> float:
    """S stage: sum of rho over the sparse source points."""
    moved = source_sparse.astype(float) @ rotation(particle[:3]).T + particle[3:]
    return float(rho(nearest(moved, target_sparse.astype(float))[0], c).sum())


def alpha_dense(particle, source_dense, target_dense, c, references=None) -> float:
    """D stage: the M-estimator chamfer distance, both directions; the neighbors are points of the
    references, or of the dense clouds."""

    def moved(points):
        return points.astype(float) @ rotation(particle[:3]).T + particle[3:]

    source, target = references or (source_dense, target_dense)
    there = nearest(moved(source_dense), target.astype(float))[0]
    back = nearest(target_dense.astype(float), moved(source))[0]
    return float(rho(there, c).sum() + rho(back, c).sum())


def beta_residuals(angles, tim_source, tim_target) -> np.ndarray:
    """|q_l - R p_l| of each TIM."""
    moved = tim_source.astype(float) @ rotation(angles).T
    return np.linalg.norm(tim_target.astype(float) - moved, axis=1)


def beta(angles, tim_source, tim_target, pruned, threshold, eta) -> float:
    """eta * outliers + sum of the inliers' residuals; each pruned TIM is an outlier."""
    residuals = beta_residuals(angles, tim_source, tim_target)
    inside = residuals < threshold
    return float(eta * (pruned + np.count_nonzero(~inside)) + residuals[inside].sum())


def complement(angles, source, target, start, end, iterations) -> np.ndarray:
    """Algorithm 2, with its scale d annealed geometrically from start to end."""
    rotated = source.astype(float) @ rotation(angles).T
    target = target.astype(float)
    t = np.zeros(3)
    for k in range(iterations):
        d = start * (end / start) ** (k / (iterations - 1)) if iterations > 1 else start
        y = rotated + t
        r, index = nearest(y, target)
        w = np.where(r <= d, (1 - np.minimum(r / d, 1) ** 2) ** 2, 0.0)[:, None]
        if w.sum() > 0:
            t = t + (w * target[index]).sum(0) / w.sum() - (w * y).sum(0) / w.sum()
    return t


def mean_resolution(points: np.ndarray) -> float:
    """Mean distance of a point to its nearest other point."""
    squared = ((points[:, None] - points[None]) ** 2).sum(axis=2)
    np.fill_diagonal(squared, np.inf)
    return float(np.sqrt(squared.min(axis=1)).mean())


def transformation(particle, scale, center_source, center_target) -> np.ndarray:
    """A particle of the normalized frame p' = (p - center) / scale in the user's unit."""
    matrix = np.eye(4)
    matrix[:3, :3] = rotation(particle[:3])
    translation = scale * np.asarray(particle[3:])
    matrix[:3, 3] = center_target + translation - matrix[:3, :3] @ center_source
    return matrix
