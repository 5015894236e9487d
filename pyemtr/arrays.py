"""What users hand over, as the arrays that the C library reads."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def as_points(cloud: Any, name: str) -> NDArray[Any]:
    """A cloud as float32 or float64 (N, 3), x y z side by side; the caller's memory if it can be.

    Takes arrays of any real dtype, byte order and strides, nested lists, and objects with
    ``.points``. Masked points become NaN, so that they are dropped and counted.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N, 3).
    """
    array = _real_array(_points_of(cloud), name)
    if array.ndim != 2 or array.shape[1] != 3:
        hint = ""
        if array.ndim == 2 and array.shape[0] == 3:
            hint = f"; one point is one row, so transpose it: {name}.T"
        raise ValueError(f"{name}: expected an array of shape (N, 3), got {array.shape}{hint}")
    if array.dtype not in (np.dtype(np.float32), np.dtype(np.float64)):
        array = array.astype(np.float32 if array.dtype == np.float16 else np.float64)
    return _side_by_side(array)


def as_normals(normals: Any, name: str, points: NDArray[Any]) -> NDArray[Any]:
    """Normals of points that :func:`as_points` made: of their type and number, (N, 3).

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N, 3).
    """
    array = _rows(normals, name, points)
    if array.shape[1] != 3:
        raise ValueError(
            f"{name}: expected an array of shape ({len(points)}, 3), got {array.shape}"
        )
    return _side_by_side(array.astype(points.dtype, copy=False))


def as_features(features: Any, name: str, points: NDArray[Any]) -> NDArray[np.float32]:
    """Descriptors of points that :func:`as_points` made: float32 (N, D), D of 1 and more.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N, D); one point is one row.
    """
    array = _rows(features, name, points)
    if array.shape[1] == 0:
        raise ValueError(f"{name}: expected at least one number a point, got {array.shape}")
    with np.errstate(over="ignore"):  # an infinity: the point has none
        return _side_by_side(array.astype(np.float32, copy=False))


def as_correspondences(pairs: Any, name: str = "correspondences") -> NDArray[np.int32]:
    """Pairs of rows as contiguous int32 (K, 2).

    Raises:
        TypeError: not whole numbers.
        ValueError: not (K, 2), none at all, or a number that is no row of any array.
    """
    array = _real_array(pairs, name)
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


def as_particles(particles: Any, genes: int) -> Floats:
    """Particles as contiguous float64 (P, genes).

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: another shape, or a NaN or an infinity.
    """
    return _shaped(particles, "particles", (None, genes))


def as_vector(vector: Any, name: str, length: int) -> Floats:
    """A vector as contiguous float64 (length,); raises as :func:`as_particles`."""
    return _shaped(vector, name, (length,))


def as_bounds(bounds: Any, name: str) -> Floats:
    """A lower and an upper corner as contiguous float64 (2, 3); raises as :func:`as_particles`."""
    return _shaped(bounds, name, (2, 3))


def as_transformation(matrix: Any, name: str) -> Floats:
    """A 4x4 matrix as contiguous float64; raises as :func:`as_particles`."""
    return _shaped(matrix, name, (4, 4))


def _points_of(cloud: Any) -> Any:
    if hasattr(cloud, "points") and not hasattr(cloud, "__array__"):
        return cloud.points
    return cloud


def _rows(values: Any, name: str, points: NDArray[Any]) -> NDArray[Any]:
    """A row a point, of any real type."""
    array = _real_array(values, name)
    if array.ndim != 2 or array.shape[0] != len(points):
        raise ValueError(
            f"{name}: expected one row for each of the {len(points)} points, got an"
            f" array of shape {array.shape}"
        )
    return array


def _side_by_side(array: NDArray[Any]) -> NDArray[Any]:
    """Rows that lie in memory one after another, whatever is between them; a copy if it must be."""
    size = array.itemsize
    if array.strides[1] != size or array.strides[0] < array.shape[1] * size:
        array = np.ascontiguousarray(array)
    return array


def _real_array(values: Any, name: str) -> NDArray[Any]:
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
        return np.where(np.ma.getmaskarray(values), np.nan, array)
    return array


def _shaped(values: Any, name: str, shape: tuple[int | None, ...]) -> Floats:
    array = np.ascontiguousarray(_real_array(values, name), dtype=np.float64)
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
