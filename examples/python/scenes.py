"""Data for the examples: boxes as a sensor sees them, and motions. No part of pyemtr."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def scan(boxes: Array, sensor: Array, directions: Array, noise: float, seed: int) -> Array:
    """Returns where rays first meet a box, in the sensor's own frame (its axes are the world's).

    Args:
        boxes: (B, 2, 3), two opposite corners of each. A sensor within a box sees its inside.
        sensor: (3,), where all rays begin.
        directions: (D, 3), unit vectors.
        noise: standard deviation of the range.
        seed: of the noise.
    """
    nearest = np.full(len(directions), np.inf)
    with np.errstate(divide="ignore", invalid="ignore"):
        for low, high in boxes:
            meetings = np.stack([low - sensor, high - sensor]) / directions[:, None]
            enters = meetings.min(axis=1).max(axis=1)
            leaves = meetings.max(axis=1).min(axis=1)
            meets = np.where(enters > 0, enters, leaves)  # it leaves the box that it begins in
            nearest = np.where((enters <= leaves) & (meets > 0), np.fmin(nearest, meets), nearest)
    seen = np.isfinite(nearest)
    ranges = nearest[seen] + np.random.default_rng(seed).normal(scale=noise, size=seen.sum())
    return np.asarray(ranges[:, None] * directions[seen])


def sphere(count: int) -> Array:
    """Returns unit vectors (count, 3), even over the sphere: a Fibonacci spiral."""
    index = np.arange(count) + 0.5
    z = 1 - 2 * index / count
    angle = np.pi * (3 - np.sqrt(5)) * index
    ring = np.sqrt(1 - z**2)
    return np.column_stack([ring * np.cos(angle), ring * np.sin(angle), z])


def motion(degrees: tuple[float, float, float], translation: tuple[float, float, float]) -> Array:
    """Returns a transformation (4, 4): rotations about x, y and z, then a translation."""
    matrix = np.eye(4)
    for axis, angle in enumerate(np.radians(degrees)):
        i, j = [k for k in range(3) if k != axis]
        rotation = np.eye(4)
        rotation[[i, j], [i, j]] = np.cos(angle)
        rotation[j, i] = np.sin(angle) * (-1 if axis == 1 else 1)
        rotation[i, j] = -rotation[j, i]
        matrix = rotation @ matrix
    matrix[:3, 3] = translation
    return matrix


def moved(matrix: Array, points: Array) -> Array:
    """Returns points (N, 3) moved by a transformation (4, 4)."""
    return points @ matrix[:3, :3].T + matrix[:3, 3]
