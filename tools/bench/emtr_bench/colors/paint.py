"""What is painted on the surfaces: colors as functions of the place, for any scan to see."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Generator = np.random.Generator
#: Takes places (n, 2) on a flat surface and gives colors (n, 3), 0 to 1.
Paint = Callable[[Array], Array]


def plain(color: Array) -> Paint:
    """One color everywhere."""
    return lambda places: np.tile(color, (len(places), 1))


def posters(width: float, height: float, count: int, rng: Generator) -> Paint:
    """A light wall with printed sheets, each a few colored patches and lines of text."""
    sheets = [_Sheet(width, height, rng) for _ in range(count)]
    wall = rng.uniform(0.75, 0.9) * np.array([1.0, 0.98, 0.94])

    def paint(places: Array) -> Array:
        out = np.tile(wall, (len(places), 1))
        for sheet in sheets:
            sheet.put(places, out)
        return out

    return paint


def tiles(side: float, extent: float, marks: int, rng: Generator) -> Paint:
    """A floor of square tiles with dark joints and, unless `marks` is 0, stains and scratches."""
    tile, joint = np.array([0.62, 0.58, 0.52]), np.array([0.25, 0.24, 0.23])
    centers = rng.uniform(-extent / 2, extent / 2, (marks, 2))
    sizes = rng.uniform(0.08, 0.3, marks)
    shades = rng.uniform(0.1, 0.9, (marks, 3))

    def paint(places: Array) -> Array:
        out = np.tile(tile, (len(places), 1))
        for center, size, shade in zip(centers, sizes, shades):
            out[np.linalg.norm(places - center, axis=1) < size] = shade
        out[(np.abs(places / side - np.round(places / side)) < 0.05).any(axis=1)] = joint
        return out

    return paint


class _Sheet:
    """A printed sheet, askew by a few degrees."""

    def __init__(self, width: float, height: float, rng: Generator) -> None:
        self.center = rng.uniform([-width / 2, -height / 2], [width / 2, height / 2])
        self.half = rng.uniform(0.15, 0.45, 2)
        angle = rng.normal(scale=0.05)
        self.rotation = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        self.ground = rng.uniform(0, 1, 3)
        self.patches = [
            (rng.uniform(-1, 1, 2), rng.uniform(0.15, 0.6, 2), rng.uniform(0, 1, 3))
            for _ in range(rng.integers(2, 6))
        ]

    def put(self, places: Array, out: Array) -> None:
        local = ((places - self.center) @ self.rotation) / self.half
        inside = (np.abs(local) < 1).all(axis=1)
        out[inside] = self.ground
        for center, half, color in self.patches:
            out[inside & (np.abs(local - center) < half).all(axis=1)] = color
