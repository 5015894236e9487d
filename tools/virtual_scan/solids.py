"""Solids that rays meet: boxes, cylinders and balls. Array-wise, numpy only.

Each has ``ranges(eye, rays)``: for an eye (3,) and unit rays (N, 3) the range (N,) at which a ray
first meets the surface, infinite where it does not. A box that the eye is in is a room: the rays
meet its walls from inside.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Solid(Protocol):
    def ranges(self, eye: Array, rays: Array) -> Array: ...


@dataclass(frozen=True)
class Box:
    """A box that stands on ``base`` (3,), the center of its lower face; rotated about z by
    ``yaw`` degrees."""

    base: tuple[float, float, float]
    size: tuple[float, float, float]
    yaw: float = 0.0

    def ranges(self, eye: Array, rays: Array) -> Array:
        half = 0.5 * np.array(self.size)
        c, s = np.cos(np.radians(self.yaw)), np.sin(np.radians(self.yaw))
        axes = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
        start = axes @ (eye - np.array(self.base)) - [0.0, 0.0, half[2]]
        slopes = rays @ axes.T
        slopes = np.where(np.abs(slopes) < 1e-12, 1e-12, slopes)
        sides = np.stack([(-half - start) / slopes, (half - start) / slopes])
        first, last = sides.min(axis=0).max(axis=1), sides.max(axis=0).min(axis=1)
        met = np.where(first > 0, first, last)
        return np.where((last > 0) & (first <= last), met, np.inf)


@dataclass(frozen=True)
class Cylinder:
    """An upright cylinder on ``base`` (3,), the center of its lower face."""

    base: tuple[float, float, float]
    radius: float
    height: float

    def ranges(self, eye: Array, rays: Array) -> Array:
        start = eye - np.array(self.base)
        a = np.maximum(np.sum(rays[:, :2] ** 2, axis=1), 1e-12)
        b = rays[:, :2] @ start[:2]
        square = b**2 - a * (start[:2] @ start[:2] - self.radius**2)
        side = (-b - np.sqrt(np.maximum(square, 0.0))) / a
        level = start[2] + side * rays[:, 2]
        hit = (square > 0) & (side > 0) & (level >= 0) & (level <= self.height)
        slopes = np.where(np.abs(rays[:, 2]) < 1e-12, 1e-12, rays[:, 2])
        top = (self.height - start[2]) / slopes
        across = start[:2] + top[:, None] * rays[:, :2]
        on_top = (top > 0) & (np.sum(across**2, axis=1) <= self.radius**2)
        return np.minimum(np.where(hit, side, np.inf), np.where(on_top, top, np.inf))


@dataclass(frozen=True)
class Ball:
    center: tuple[float, float, float]
    radius: float

    def ranges(self, eye: Array, rays: Array) -> Array:
        start = eye - np.array(self.center)
        b = rays @ start
        square = b**2 - (start @ start - self.radius**2)
        met = -b - np.sqrt(np.maximum(square, 0.0))
        return np.where((square > 0) & (met > 0), met, np.inf)


def first_ranges(solids: Sequence[Solid], eye: Array, rays: Array) -> Array:
    """The range (N,) at which each ray meets the first of the solids."""
    nearest = np.full(len(rays), np.inf)
    for solid in solids:
        nearest = np.minimum(nearest, solid.ranges(eye, rays))
    return nearest
