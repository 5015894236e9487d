"""Scans in frames of their own."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..pairs import Array
from ..protocol import apply, euler_zyx


@dataclass(frozen=True)
class Scan:
    """What a sensor saw, and where it was, in one frame."""

    points: Array  # (n, 3)
    sensor: Array  # (3,)

    @property
    def extent(self) -> float:
        return float(np.linalg.norm(np.ptp(self.points, axis=0)))

    def moved(self, T: Array) -> Scan:
        return Scan(apply(T, self.points), apply(T, self.sensor[None])[0])


def any_pose(rng: np.random.Generator, extent: float) -> Array:
    """A pose (4, 4) with any rotation, up to half an extent away."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    rotation = q * np.sign(np.diag(r))
    return _rigid(rotation if np.linalg.det(rotation) > 0 else -rotation, extent, rng)


def upright_pose(rng: np.random.Generator, extent: float) -> Array:
    """The same, with z up as before."""
    return _rigid(euler_zyx(np.array([rng.uniform(-np.pi, np.pi), 0.0, 0.0])), extent, rng)


def between(source: Array, target: Array) -> Array:
    """The pose (4, 4) that maps a cloud moved by `source` onto the same moved by `target`."""
    R = target[:3, :3] @ source[:3, :3].T
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, target[:3, 3] - R @ source[:3, 3]
    return T


def _rigid(R: Array, extent: float, rng: np.random.Generator) -> Array:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, rng.uniform(-0.5 * extent, 0.5 * extent, 3)
    return T
