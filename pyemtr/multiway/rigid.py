"""Rigid transformations as 4x4 matrices, and small motions as vectors (w, v)."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats


def inverse(pose: Floats) -> Floats:
    """Returns the inverse of rigid matrices (..., 4, 4)."""
    inverted = np.zeros_like(pose)
    rotation = np.swapaxes(pose[..., :3, :3], -1, -2)
    inverted[..., :3, :3] = rotation
    inverted[..., :3, 3] = -np.einsum("...ij,...j->...i", rotation, pose[..., :3, 3])
    inverted[..., 3, 3] = 1
    return inverted


def moved(pose: Floats, points: Floats) -> Floats:
    """Returns points (N, 3) moved by a pose (4, 4)."""
    return np.asarray(points @ pose[:3, :3].T + pose[:3, 3])


def angle(rotations: Floats) -> Floats:
    """Returns the angles (...) in degrees of rotations (..., 3, 3); exact for small angles too."""
    skew = np.stack(
        [
            rotations[..., 2, 1] - rotations[..., 1, 2],
            rotations[..., 0, 2] - rotations[..., 2, 0],
            rotations[..., 1, 0] - rotations[..., 0, 1],
        ],
        axis=-1,
    )
    cosine = np.trace(rotations, axis1=-2, axis2=-1) - 1
    return np.asarray(np.degrees(np.arctan2(np.linalg.norm(skew, axis=-1), cosine)))


def cross_matrix(vector: Floats) -> Floats:
    """Returns the matrix (3, 3) of the cross product with a vector from the left."""
    x, y, z = vector
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]], dtype=np.float64)


def exponential(motion: Floats) -> Floats:
    """Returns the matrix (4, 4) that rotates by the vector w (radians) and then translates by v,
    of a motion (w, v): float64 (6,)."""
    matrix = np.eye(4)
    size = float(np.linalg.norm(motion[:3]))
    if size > 0:
        k = cross_matrix(motion[:3] / size)
        matrix[:3, :3] += np.sin(size) * k + (1 - np.cos(size)) * k @ k
    matrix[:3, 3] = motion[3:]
    return matrix


def adjoint(pose: Floats) -> Floats:
    """Returns the matrix (6, 6) that carries a small motion (w, v) from the frame in which the pose
    takes points to the one in which it puts them: exp(Ad m) pose = pose exp(m)."""
    made = np.zeros((6, 6))
    made[:3, :3] = made[3:, 3:] = pose[:3, :3]
    made[3:, :3] = cross_matrix(pose[:3, 3]) @ pose[:3, :3]
    return made


def orthonormal(pose: Floats) -> Floats:
    """Returns the pose with its rotation made orthonormal again."""
    u, _, vt = np.linalg.svd(pose[:3, :3])
    tidy = np.eye(4)
    tidy[:3, :3] = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
    tidy[:3, 3] = pose[:3, 3]
    return tidy
