"""Points with the normals and colors that a cloud brings along."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats, real_array

_COLORS = (("red", "green", "blue"), ("r", "g", "b"))
_NORMALS = (("nx", "ny", "nz"), ("normal_x", "normal_y", "normal_z"))


class Rows(NamedTuple):
    """Finite points, float64 (N, 3); normals, float64 (N, 3), and colors from 0 to 1, float64
    (N, 3), or None where the cloud has none."""

    points: Floats
    normals: Floats | None
    colors: Floats | None


def rows_of(cloud: Any, points: NDArray[Any], name: str) -> Rows:
    """Returns the finite points of a cloud, with its columns (nx, ny, nz; red, green, blue) or
    attributes (normals, colors).

    Raises ValueError when it has as many normals or colors as it has no points.
    """
    finite = np.isfinite(points).all(axis=1)
    normals = _columns(cloud, _NORMALS)
    if normals is None:
        normals = _attribute(cloud, "normals", points, name)
    raw = _columns(cloud, _COLORS)
    if raw is None:
        raw = _attribute(cloud, "colors", points, name)
    colors = None if raw is None else _unit(raw)
    return Rows(
        points[finite].astype(np.float64),
        None if normals is None else normals[finite].astype(np.float64),
        None if colors is None else colors[finite],
    )


def _columns(cloud: Any, families: tuple[tuple[str, ...], ...]) -> NDArray[Any] | None:
    if isinstance(cloud, np.ndarray):
        names: Any = cloud.dtype.names or ()
    else:
        names = getattr(cloud, "columns", ())
    for family in families:
        if all(name in names for name in family):
            return np.column_stack([np.asarray(cloud[name]) for name in family])
    return None


def _attribute(cloud: Any, which: str, points: NDArray[Any], name: str) -> NDArray[Any] | None:
    """Returns an attribute as Open3D's and trimesh's clouds have it; None where it is empty."""
    if isinstance(cloud, np.ndarray) or callable(getattr(cloud, which, None)):
        return None
    values = getattr(cloud, which, None)
    if values is None or len(values) == 0:
        return None
    array = real_array(values, f"{name}: {which}")[:, :3]
    if len(array) != len(points):
        raise ValueError(f"{name}: {which}: expected {len(points)} rows, got {len(array)}")
    return array


def _unit(colors: NDArray[Any]) -> Floats:
    """Returns colors from 0 to 1: integers are shares of the largest number of their type."""
    if colors.dtype.kind in "iu":
        return np.asarray(colors / (65535.0 if colors.dtype.itemsize == 2 else 255.0))
    return colors.astype(np.float64)
