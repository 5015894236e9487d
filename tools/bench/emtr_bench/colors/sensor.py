"""What a sensor makes of places on painted surfaces: another one for each scan."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .paint import Array, Generator
from .scenes import Scan


@dataclass(frozen=True)
class Sensor:
    """A depth camera or scanner with a camera, of any quality within these bounds."""

    points: int  # of a scan
    noise: float  # along the normal, shares of the extent
    color_noise: float
    gain: Array  # (3,), of red, green and blue
    offset: float
    vignette: float  # how much darker the corners are
    gamma: float  # of the shades, as cameras bend them

    @staticmethod
    def any(rng: Generator, points: int) -> Sensor:
        """Draws one; `points` is about how many a scan has."""
        return Sensor(
            points=int(points * np.exp(rng.uniform(-0.7, 0.7))),
            noise=rng.uniform(0.0003, 0.0015),
            color_noise=rng.uniform(0.01, 0.08),
            gain=rng.uniform(0.45, 1.25) * np.exp(rng.normal(scale=0.08, size=3)),
            offset=rng.uniform(-0.05, 0.08),
            vignette=rng.uniform(0, 0.35),
            gamma=rng.uniform(0.85, 1.2),
        )

    def see(self, points: Array, colors: Array, normals: Array, rng: Generator) -> Scan:
        """Takes places (n, 3) in meters, their colors and unit normals, all in random order."""
        points, colors, normals = self.thinned(points, colors, normals, rng)
        extent = float(np.linalg.norm(np.ptp(points, axis=0)))
        off = rng.normal(scale=self.noise * extent, size=(len(points), 1))
        from_middle = np.linalg.norm(points - points.mean(axis=0), axis=1) / (extent / 2)
        light = 1 - self.vignette * from_middle**2
        shades = np.clip(colors, 0, None) ** self.gamma * light[:, None] * self.gain + self.offset
        shades = shades + rng.normal(scale=self.color_noise, size=colors.shape)
        return Scan(points + off * normals, np.round(255 * shades.clip(0, 1)) / 255)

    def thinned(
        self, points: Array, colors: Array, normals: Array, rng: Generator
    ) -> tuple[Array, Array, Array]:
        """Leaves a share of the points: denser near a place, and with a few holes where somebody
        was in the way."""
        extent = float(np.linalg.norm(np.ptp(points, axis=0)))
        near = points[rng.integers(len(points))]
        distance = np.linalg.norm(points - near, axis=1) / extent
        keep = rng.random(len(points)) < 1 / (1 + 2 * distance**2)
        for _ in range(rng.integers(0, 4)):
            hole = points[rng.integers(len(points))]
            keep &= np.linalg.norm(points - hole, axis=1) > rng.uniform(0.02, 0.07) * extent
        rows = np.flatnonzero(keep)[: self.points]
        return points[rows], colors[rows], normals[rows]
