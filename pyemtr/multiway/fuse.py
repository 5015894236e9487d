"""The fused cloud of a model: the average of all scans' points in each voxel."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats
from .colors import Rows
from .surface import voxel_keys

_BLOCK = 500_000  # points that are added at a time


class FusedCloud(NamedTuple):
    """One point for each occupied voxel, in the model's frame and the scans' unit.

    Attributes:
        points: float64 (N, 3).
        normals: float64 (N, 3), of unit length; None unless all scans have normals.
        colors: float64 (N, 3), 0 to 1; None unless all scans have colors.
        counts: int64 (N,), how many points each one is the average of.
    """

    points: Floats
    normals: Floats | None
    colors: Floats | None
    counts: NDArray[np.int64]


def fuse(parts: Iterable[Rows], voxel: float) -> FusedCloud:
    """Returns the average of the points, normals and colors of each voxel.

    The memory that it takes is that of one part and of the voxels, not of all points. Normals are
    averaged with the side of the first one of their voxel.

    Args:
        parts: the scans, moved into one frame.
        voxel: edge of the voxels, above 0.

    Raises ValueError when the voxel is too small for the extent of the points.
    """
    sums = _Sums(voxel)
    for part in parts:
        for begin in range(0, len(part.points), _BLOCK):
            rows = slice(begin, begin + _BLOCK)
            normals = None if part.normals is None else part.normals[rows]
            colors = None if part.colors is None else part.colors[rows]
            sums.add(Rows(part.points[rows], normals, colors))
    return sums.averages()


class _Sums:
    """Sums by voxel: x, y, z, then normals and colors where all parts have them."""

    def __init__(self, voxel: float) -> None:
        self._voxel = voxel
        self._origin: Floats | None = None
        self._has = [True, True]
        self._keys = np.empty(0, dtype=np.int64)
        self._values = np.empty((0, 10))  # points, normals, colors, count

    def add(self, part: Rows) -> None:
        if not len(part.points):
            return
        if self._origin is None:
            self._origin = part.points[0].copy()
        rows = np.zeros((len(part.points), 10))
        rows[:, :3] = part.points - self._origin
        for i, values in enumerate((part.normals, part.colors)):
            self._has[i] &= values is not None
            if values is not None:
                rows[:, 3 + 3 * i : 6 + 3 * i] = np.nan_to_num(values)
        rows[:, 9] = 1
        keys, values = _summed(voxel_keys(part.points, self._voxel, self._origin), rows)
        at = np.searchsorted(self._keys, keys)
        known = at < len(self._keys)
        known[known] = self._keys[at[known]] == keys[known]
        sides = np.einsum("ij,ij->i", self._values[at[known], 3:6], values[known, 3:6]) < 0
        values[np.flatnonzero(known)[sides], 3:6] *= -1
        self._values[at[known]] += values[known]
        merged = np.concatenate([self._keys, keys[~known]])
        order = np.argsort(merged, kind="stable")
        self._keys = merged[order]
        self._values = np.concatenate([self._values, values[~known]])[order]

    def averages(self) -> FusedCloud:
        counts = self._values[:, 9]
        means = self._values[:, :9] / counts[:, None]
        origin = np.zeros(3) if self._origin is None else self._origin
        lengths = np.linalg.norm(means[:, 3:6], axis=1, keepdims=True)
        normals = np.divide(means[:, 3:6], lengths, out=np.zeros_like(means[:, 3:6]),
                            where=lengths > 0)  # fmt: skip
        return FusedCloud(
            means[:, :3] + origin,
            normals if self._has[0] else None,
            means[:, 6:9] if self._has[1] else None,
            counts.astype(np.int64),
        )


def _summed(keys: NDArray[np.int64], rows: Floats) -> tuple[NDArray[np.int64], Floats]:
    """Returns the different keys, sorted, and the sums of their rows, with the normals of a voxel
    on the side of its first one."""
    order = np.argsort(keys, kind="stable")
    keys, rows = keys[order], rows[order]
    begins = np.flatnonzero(np.diff(keys, prepend=keys[0] - 1))
    index = np.cumsum(np.diff(keys, prepend=keys[0]) != 0)
    firsts = rows[begins[index], 3:6]
    rows[np.einsum("ij,ij->i", firsts, rows[:, 3:6]) < 0, 3:6] *= -1
    return keys[begins], np.add.reduceat(rows, begins, axis=0)
