"""The rays of a camera and of a spinning LiDAR, and what they see of solids."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .solids import Solid, first_ranges

Array = NDArray[np.float64]


def camera(eye: Array, look_at: Array, half_angle: float, columns: int, rows: int) -> Array:
    """Unit rays (rows x columns, 3) of a depth camera, z up; half_angle in degrees, to the side."""
    forward = (look_at - eye) / np.linalg.norm(look_at - eye)
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    down = np.cross(forward, right)
    width = np.tan(np.radians(half_angle))
    x = width * ((2 * np.arange(columns) + 1) / columns - 1)
    y = width * rows / columns * ((2 * np.arange(rows) + 1) / rows - 1)
    rays = forward + x[None, :, None] * right + y[:, None, None] * down
    return np.asarray(rays / np.linalg.norm(rays, axis=2, keepdims=True)).reshape(-1, 3)


def spinning(lowest: float, highest: float, beams: int, steps: int, start: float) -> Array:
    """Unit rays (beams x steps, 3) of a LiDAR with an upright axis; the beams' elevations and the
    azimuth ``start`` of the first ray in degrees."""
    elevation = np.radians(np.linspace(lowest, highest, beams))[:, None]
    azimuth = np.radians(start) + 2 * np.pi * np.arange(steps)[None, :] / steps
    level = np.cos(elevation)
    rays = [level * np.cos(azimuth), level * np.sin(azimuth),
            np.broadcast_to(np.sin(elevation), (beams, steps))]  # fmt: skip
    return np.stack(rays, axis=-1).reshape(-1, 3)


def see(
    solids: Sequence[Solid],
    eye: Array,
    rays: Array,
    noise: float,
    farthest: float,
    rng: np.random.Generator,
) -> Array:
    """The points (N, 3) where the rays meet the solids within the range ``farthest``, with noise
    along the rays (standard deviation)."""
    ranges = first_ranges(solids, eye, rays)
    near = ranges < farthest
    noisy = ranges[near] + rng.normal(0.0, noise, int(near.sum()))
    return np.asarray(eye + noisy[:, None] * rays[near])
