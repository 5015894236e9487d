"""Clouds in another library's unit, and its answer back in ours.

Some libraries' defaults are lengths, made for metres and LiDAR scans. They get the clouds in
the unit that they were made for, each about its own centroid so that float32 keeps its digits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Unit:
    source_center: Array  # (3,)
    target_center: Array
    scale: float  # their lengths a length of ours

    @classmethod
    def of(cls, source: Array, target: Array, scale: float) -> Unit:
        return cls(source.mean(axis=0), target.mean(axis=0), scale)

    def source(self, points: Array) -> Array:
        return np.asarray((points - self.source_center) * self.scale)

    def target(self, points: Array) -> Array:
        return np.asarray((points - self.target_center) * self.scale)

    def pose_to(self, T: Array) -> Array:
        """A pose (4, 4) between the user's clouds, as one between theirs."""
        moved = T[:3, :3] @ self.source_center + T[:3, 3]
        return _pose(T[:3, :3], (moved - self.target_center) * self.scale)

    def pose_from(self, T: Array) -> Array:
        R = T[:3, :3]
        return _pose(R, T[:3, 3] / self.scale + self.target_center - R @ self.source_center)


def _pose(R: Array, t: Array) -> Array:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, t
    return T
