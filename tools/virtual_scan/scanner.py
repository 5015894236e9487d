"""A range scanner: one ray through each pixel, traced to the first surface it meets."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .distance import normals, signed_distance

Array = NDArray[np.float64]

CENTER = np.array([-8.0, 0.0, 50.0])  # what the scanner looks at, mm
DISTANCE = 260.0  # from there to the sensor, mm
HALF_ANGLE = np.tan(np.radians(15.5))  # of the field of view
SAFE_STEP = 0.8  # share of the distance that a ray may advance: the distance is a bound
GRAZING = 0.12  # least cosine between ray and normal that returns an echo


@dataclass
class Scan:
    """The points that a scanner saw, in the frame of the shape, mm."""

    viewpoint: Array  # (3,)
    surface: Array  # (N, 3) where the rays met the surface
    points: Array  # (N, 3) the same with noise along the rays


def viewpoint(azimuth: float, elevation: float) -> Array:
    """Position (3,) of the sensor; degrees, azimuth 0 in front of the shape."""
    a, e = np.radians([azimuth, elevation])
    return CENTER + DISTANCE * np.array([np.sin(a) * np.cos(e), -np.cos(a) * np.cos(e), np.sin(e)])


def directions(eye: Array, pixels: int) -> Array:
    """Unit rays (pixels, pixels, 3) of a square perspective image, z up."""
    forward = (CENTER - eye) / np.linalg.norm(CENTER - eye)
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    down = np.cross(forward, right)
    grid = HALF_ANGLE * ((2 * np.arange(pixels) + 1) / pixels - 1)
    rays = forward + grid[None, :, None] * right + grid[:, None, None] * down
    return np.asarray(rays / np.linalg.norm(rays, axis=2, keepdims=True))


def trace(eye: Array, rays: Array, start: Array, cone: float, steps: int = 160) -> Array:
    """Ranges (N,) along rays (N, 3) at which the surface comes nearer than `cone` x range.

    Starts at the ranges `start` (N,); infinite where a ray passes the shape.
    """
    ranges = start.copy()
    alive = np.arange(len(rays))
    for _ in range(steps):
        points = eye + ranges[alive, None] * rays[alive]
        gap = signed_distance(points.astype(np.float32))  # half the time, precise enough
        apart = np.abs(gap) > cone * ranges[alive]  # inside after a step too far: goes back
        alive, gap = alive[apart], gap[apart]
        ranges[alive] += SAFE_STEP * gap
        past = ranges[alive] > DISTANCE + 100
        ranges[alive[past]] = np.inf
        alive = alive[~past]
    ranges[alive] = np.inf  # neither met nor passed it: skims along an edge
    return ranges


def image(eye: Array, pixels: int, block: int = 6) -> tuple[Array, Array]:
    """Rays (N, 3) that meet the shape, and their ranges (N,), of a pixels x pixels image.

    Blocks of rays are traced together, as one cone, until the cone touches the shape.
    """
    blocks = -(-pixels // block)
    coarse = directions(eye, blocks).reshape(-1, 3)
    cone = 1.5 * HALF_ANGLE / blocks * np.sqrt(2)
    start = trace(eye, coarse, np.full(len(coarse), DISTANCE - 100), cone)
    fine = directions(eye, blocks * block).reshape(-1, 3)
    start = start.reshape(blocks, blocks).repeat(block, axis=0).repeat(block, axis=1).ravel()
    near = np.isfinite(start)
    rays = fine[near]
    ranges = trace(eye, rays, start[near], 1e-5)
    met = np.isfinite(ranges)
    return rays[met], ranges[met]


def scan(eye: Array, count: int, noise: float, rng: np.random.Generator) -> Scan:
    """Scans about `count` points from `eye` (3,), with `noise` (mm, standard deviation)."""
    rays, _ = image(eye, 96)
    pixels = round(96 * np.sqrt(0.99 * count / len(rays)))
    rays, ranges = image(eye, pixels)
    surface = eye + ranges[:, None] * rays
    facing = -np.einsum("ij,ij->i", normals(surface), rays) > GRAZING
    rays, ranges, surface = rays[facing], ranges[facing], surface[facing]
    noisy = ranges + rng.normal(0.0, noise, len(ranges))
    return Scan(eye, surface, eye + noisy[:, None] * rays)
