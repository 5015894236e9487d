"""Scans of lumpy things from several sides, with known poses."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from shapes import apply, directions, random_transformation


class Scene(NamedTuple):
    clouds: list[np.ndarray]  # float64 (n, 3) each, in a frame of its own
    truth: np.ndarray  # float64 (scans, 4, 4), scan -> thing
    things: list[int]  # which thing each scan shows


def thing(seed: int, rng: np.random.Generator, count: int) -> np.ndarray:
    """Points on a lumpy egg: the same surface for a seed, sampled by `rng`."""
    fixed = np.random.default_rng(seed)
    centers = directions(fixed, 50)
    heights = fixed.uniform(0.1, 0.28, 50) * fixed.choice([-1, 1], 50)
    widths = fixed.uniform(0.14, 0.32, 50)
    at = directions(rng, count)
    angle = np.arccos(np.clip(at @ centers.T, -1, 1))
    radius = 1 + (heights * np.exp(-((angle / widths) ** 2))).sum(axis=1)
    return at * radius[:, None] * [1.0, 0.82, 0.68]


def scene(
    views: dict[int, int], seed: int = 0, count: int = 5000, half_angle: float = 75.0
) -> Scene:
    """Scans of things from views that are evenly spaced around them.

    `views` has the number of scans by the seed of the thing. The scans are shuffled, with noise of
    0.2 % of the radius, and each is in a frame of its own.
    """
    rng = np.random.default_rng(seed)
    made = []
    for name, number in views.items():
        for k in range(number):
            azimuth = 2 * np.pi * k / max(number, 1)
            view = np.array([np.cos(azimuth), np.sin(azimuth), 0.35 * (-1) ** k])
            points = thing(name, rng, 3 * count)
            side = points @ view / np.linalg.norm(points, axis=1) / np.linalg.norm(view)
            seen = points[side > np.cos(np.radians(half_angle))][:count]
            made.append((name, seen + rng.normal(scale=0.002, size=seen.shape)))
    order = rng.permutation(len(made))
    poses = np.array([random_transformation(rng) for _ in made])
    clouds = [apply(np.linalg.inv(pose), made[k][1]) for k, pose in zip(order, poses)]
    return Scene(clouds, poses, [made[k][0] for k in order])


def errors(result, truth: np.ndarray) -> np.ndarray:
    """Degrees and distance of the thing's center (N, 2) of the placed scans against the first scan
    of their model; NaN where left out."""
    found = np.full((len(result.scans), 2), np.nan)
    for members in result.models:
        first = members[0]
        for scan in members:
            wanted = np.linalg.inv(truth[first]) @ truth[scan]
            apart = np.linalg.inv(wanted) @ result.scans[scan].pose
            cosine = (np.trace(apart[:3, :3]) - 1) / 2
            center = np.linalg.inv(truth[scan])[:3, 3]  # the thing's, in the scan's frame
            moved = apart[:3, :3] @ center + apart[:3, 3] - center
            found[scan] = np.degrees(np.arccos(np.clip(cosine, -1, 1))), np.linalg.norm(moved)
    return found
