"""Errors of an estimated transformation against the true one.

Every ``T`` is a 4x4 rigid transformation that maps source into target, q = R p + t, in the
user's unit. The figures are those of the EMTR-SSC paper.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "MAX_ROTATION_ERROR",
    "MAX_TRANSLATION_ERROR",
    "joint_success",
    "rotation_error",
    "translation_error",
]

#: Degrees; the paper calls a registration successful below this rotation error.
MAX_ROTATION_ERROR = 5.0

#: Normalized frame. The rotation alone does not tell a translation along a plane.
MAX_TRANSLATION_ERROR = 0.06

# float32 matrices (PCL's default) are orthonormal to about 1e-6.
_RIGID_TOLERANCE = 1e-4

_Matrix = NDArray[np.float64]


def rotation_error(T_est: ArrayLike, T_true: ArrayLike) -> float:
    """Returns the angle between two rotations, in degrees, 0 to 180.

    Computed as ``2 asin(|R_true - R_est|_F / (2 sqrt 2))``. It equals the paper's arccos of
    the trace, which loses half of its digits near zero: 1e-9 rad and 0 look the same to it.

    Parameters
    ----------
    T_est, T_true : array_like, shape (4, 4)
        Estimated and true transformation, source into target.

    Raises
    ------
    ValueError
        If a matrix is not 4x4, not finite or not rigid (to 1e-4).
    """
    difference = _rigid(T_true, "T_true")[:3, :3] - _rigid(T_est, "T_est")[:3, :3]
    sine = float(np.linalg.norm(difference)) / (2.0 * math.sqrt(2.0))
    return math.degrees(2.0 * math.asin(min(sine, 1.0)))


def translation_error(
    T_est: ArrayLike, T_true: ArrayLike, center: ArrayLike, scale: float
) -> float:
    """Returns the displacement of the source's centroid in the normalized frame, without a unit.

    This is ``|T_est c - T_true c| / scale``, the same as the paper's ``|t_true - t_est|``
    once both clouds are centered and scaled; unlike the raw difference of the translations,
    it does not depend on where the user's origin lies.

    Parameters
    ----------
    T_est, T_true : array_like, shape (4, 4)
        Estimated and true transformation, source into target.
    center : array_like, shape (3,)
        Centroid of the source cloud, in the source's coordinates.
    scale : float
        Length of one unit of the normalized frame, in the user's unit; positive.

    Raises
    ------
    ValueError
        If a matrix is not 4x4, not finite or not rigid (to 1e-4), if ``center`` is not three
        finite numbers, or if ``scale`` is not positive and finite.
    """
    difference = _rigid(T_est, "T_est") - _rigid(T_true, "T_true")
    point = _array(center, "center", (3,))
    if not (math.isfinite(scale) and scale > 0.0):
        raise ValueError(f"scale: expected a positive, finite number, got {scale!r}")
    # Subtracting the matrices before the product keeps digits far from the origin.
    moved = difference[:3, :3] @ point + difference[:3, 3]
    return float(np.linalg.norm(moved)) / scale


def joint_success(
    T_est: ArrayLike,
    T_true: ArrayLike,
    center: ArrayLike,
    scale: float,
    *,
    max_rotation: float = MAX_ROTATION_ERROR,
    max_translation: float = MAX_TRANSLATION_ERROR,
) -> bool:
    """Tells whether rotation and translation are both right.

    True when ``rotation_error < max_rotation`` (degrees) and ``translation_error <
    max_translation`` (normalized frame). Arguments and errors are those of the two functions.
    """
    return (
        rotation_error(T_est, T_true) < max_rotation
        and translation_error(T_est, T_true, center, scale) < max_translation
    )


def _array(value: ArrayLike, name: str, shape: tuple[int, ...]) -> _Matrix:
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name}: expected real numbers of shape {shape}: {error}") from error
    if array.shape != shape:
        raise ValueError(f"{name}: expected shape {shape}, got {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite numbers, got NaN or infinity")
    return array


def _rigid(value: ArrayLike, name: str) -> _Matrix:
    matrix = _array(value, name, (4, 4))
    if not np.allclose(matrix[3], (0.0, 0.0, 0.0, 1.0), rtol=0.0, atol=_RIGID_TOLERANCE):
        raise ValueError(f"{name}: expected the last row 0 0 0 1, got {matrix[3].tolist()}")
    rotation = matrix[:3, :3]
    deviation = float(np.abs(rotation.T @ rotation - np.eye(3)).max())
    if deviation > _RIGID_TOLERANCE:
        raise ValueError(
            f"{name}: expected a rotation in the upper left 3x3, but R^T R differs from the "
            f"identity by {deviation:.3g} (at most {_RIGID_TOLERANCE:g})"
        )
    if float(np.linalg.det(rotation)) < 0.0:
        raise ValueError(f"{name}: expected a rotation, got a reflection (determinant -1)")
    return matrix
