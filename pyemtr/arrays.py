"""Converts user-provided values to the arrays that the C library reads."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def as_normals(normals: Any, name: str, points: NDArray[Any]) -> NDArray[Any]:
    """Returns normals (N, 3) in the dtype of the points, which ``as_points`` made.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N, 3).
    """
    array = _rows(normals, name, points)
    if array.shape[1] != 3:
        raise ValueError(
            f"{name}: expected an array of shape ({len(points)}, 3), got {array.shape}"
        )
    return contiguous_rows(array.astype(points.dtype, copy=False))


def as_features(features: Any, name: str, points: NDArray[Any]) -> NDArray[np.float32]:
    """Returns descriptors float32 (N, D), D >= 1, for points that ``as_points`` made.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N, D); one point is one row.
    """
    array = _rows(features, name, points)
    if array.shape[1] == 0:
        raise ValueError(f"{name}: expected at least one number a point, got {array.shape}")
    with np.errstate(over="ignore"):  # to an infinity: the point then has no descriptor
        return contiguous_rows(array.astype(np.float32, copy=False))


def as_correspondences(pairs: Any, name: str = "correspondences") -> NDArray[np.int32]:
    """Returns pairs of rows as contiguous int32 (K, 2).

    Raises:
        TypeError: not whole numbers.
        ValueError: not (K, 2), none at all, or a number that is no row of any array.
    """
    array = real_array(pairs, name)
    if array.ndim != 2 or array.shape[1] != 2 or array.shape[0] == 0:
        raise ValueError(
            f"{name}: expected an array of shape (K, 2), one pair of rows of source"
            f" and target a row, got {array.shape}"
        )
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected whole numbers, got dtype {array.dtype}")
    outside = ((array < 0) | (array > np.iinfo(np.int32).max)).any(axis=1)
    if outside.any():
        row = int(outside.argmax())
        raise ValueError(f"{name}: row {row}: {array[row].tolist()} are no rows of the clouds")
    return np.ascontiguousarray(array, dtype=np.int32)


def as_particles(particles: Any, genes: int) -> tuple[Floats, tuple[int, ...]]:
    """Returns particles (P, genes), or one (genes,), as contiguous float64 (P, genes), and the
    shape of their fitness: (P,), or () for one.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: another shape, or a NaN or an infinity.
    """
    array = real_array(particles, "particles")
    if array.ndim == 1:
        return _shaped(array, "particles", (genes,)).reshape(1, genes), ()
    rows = _shaped(array, "particles", (None, genes))
    return rows, (len(rows),)


def as_vector(vector: Any, name: str, length: int) -> Floats:
    """Returns a vector as contiguous float64 (length,); raises as :func:`as_particles`."""
    return _shaped(vector, name, (length,))


def as_bounds(bounds: Any, name: str) -> Floats:
    """Returns two opposite corners as contiguous float64 (2, 3); raises as :func:`as_particles`."""
    return _shaped(bounds, name, (2, 3))


def as_transformation(matrix: Any, name: str) -> Floats:
    """Returns a 4x4 matrix, or that of an object with ``.transformation`` (a result), as contiguous
    float64; raises as :func:`as_particles`."""
    return _shaped(getattr(matrix, "transformation", matrix), name, (4, 4))


def as_poses(poses: Any) -> tuple[Floats, tuple[int, ...]]:
    """Returns matrices (P, 4, 4) or one (4, 4), or what has ``.transformation``, one or many, as
    contiguous float64 (P, 16), and the shape of what is known of each: (P,), or () for one.

    Raises as :func:`as_particles`, and ValueError for none.
    """
    if isinstance(poses, (list, tuple)) and not hasattr(poses, "transformation"):
        poses = [getattr(pose, "transformation", pose) for pose in poses]
    array = real_array(getattr(poses, "transformation", poses), "poses")
    if array.shape == (4, 4):
        return _shaped(array, "poses", (4, 4)).reshape(1, 16), ()
    if len(array) == 0:
        raise ValueError("poses: expected at least one, got none")
    rows = _shaped(array, "poses", (None, 4, 4))
    return rows.reshape(-1, 16), (len(rows),)


def _rows(values: Any, name: str, points: NDArray[Any]) -> NDArray[Any]:
    """Returns one row for each point, in any real dtype."""
    array = real_array(values, name)
    if array.ndim != 2 or array.shape[0] != len(points):
        raise ValueError(
            f"{name}: expected one row for each of the {len(points)} points, got an"
            f" array of shape {array.shape}"
        )
    return array


def contiguous_rows(array: NDArray[Any]) -> NDArray[Any]:
    """Returns an array with contiguous rows in ascending order, without a copy if possible."""
    size = array.itemsize
    if array.strides[1] != size or array.strides[0] < array.shape[1] * size:
        array = np.ascontiguousarray(array)
    return array


def real_array(values: Any, name: str) -> NDArray[Any]:
    """Returns values as an array of a real dtype, with NaN where they are masked.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: rows of different lengths.
    """
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name}: expected an array of numbers: {error}") from error
    if array.dtype.kind not in "fiu":
        raise TypeError(
            f"{name}: expected an array of real numbers, got dtype {array.dtype}"
            f" ({type(values).__name__})"
        )
    if isinstance(values, np.ma.MaskedArray):
        return np.where(np.broadcast_to(values.mask, array.shape), np.nan, array)
    return array


def _shaped(values: Any, name: str, shape: tuple[int | None, ...]) -> Floats:
    array = np.ascontiguousarray(real_array(values, name), dtype=np.float64)
    fits = array.ndim == len(shape) and all(
        wanted is None or wanted == got for wanted, got in zip(shape, array.shape)
    )
    if not fits:
        wanted = ", ".join("P" if n is None else str(n) for n in shape)
        comma = "," if len(shape) == 1 else ""
        raise ValueError(f"{name}: expected an array of shape ({wanted}{comma}), got {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: NaN or infinity is not allowed")
    return array
