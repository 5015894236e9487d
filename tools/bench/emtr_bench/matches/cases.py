"""Matches whose pose is known."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LARGEST_SCALE = 5.0


@dataclass(frozen=True)
class Case:
    """The i-th point of the source is matched with the i-th of the target."""

    source: Array
    target: Array
    truth: Array  # rigid, source into target, 4 by 4; the target is `scale` times as large
    right: int  # how many matches are
    scale: float = 1.0


def make_case(
    count: int,
    outliers: float,
    noise: float,
    seed: int,
    cloud: Array | None,
    unknown_scale: bool = False,
) -> Case:
    """Makes a case by the protocol of TEASER++; of no cloud the points are uniform in the cube.
    With an unknown scale, 1 to 5, the noise is that of the larger target."""
    rng = np.random.default_rng([count, round(1000 * outliers), seed])
    source = rng.random((count, 3)) if cloud is None else _sampled(cloud, count, rng)
    truth = np.eye(4)
    truth[:3, :3] = _rotation(rng)
    truth[:3, 3] = _in_ball(rng, 1)[0]
    target = source @ truth[:3, :3].T + truth[:3, 3] + rng.normal(scale=noise, size=source.shape)
    wrong = rng.permutation(count)[: round(outliers * count)]
    center = truth[:3, :3] @ np.full(3, 0.5) + truth[:3, 3]
    target[wrong] = center + np.sqrt(3) / 2 * _in_ball(rng, len(wrong))
    scale = float(np.exp(rng.uniform(0, np.log(LARGEST_SCALE)))) if unknown_scale else 1.0
    return Case(source, scale * target, truth, count - len(wrong), scale)


def unit_cube(points: Array) -> Array:
    """Returns the points scaled into the cube from 0 to 1."""
    low = points.min(axis=0)
    return (points - low) / (points - low).max()


def _sampled(cloud: Array, count: int, rng: np.random.Generator) -> Array:
    return cloud[rng.choice(len(cloud), count, replace=count > len(cloud))]


def _in_ball(rng: np.random.Generator, count: int) -> Array:
    directions = rng.normal(size=(count, 3))
    lengths = np.linalg.norm(directions, axis=1, keepdims=True)
    return directions / lengths * np.cbrt(rng.random((count, 1)))


def _rotation(rng: np.random.Generator) -> Array:
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q
