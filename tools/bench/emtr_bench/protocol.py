"""The paper's protocol: the aligned source is moved by random transforms of known classes.

Each motion is drawn from a generator of its own, seeded by the pair's name and the motion's
index, so that every preset, machine and number of transforms sees the same motions.
"""

from __future__ import annotations

import math
import zlib
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

#: Small or large rotation x small or large translation, and anywhere. Motion i is of class
#: i mod 5, so that 20 motions hold four of each and the first few are mixed.
CLASSES = ("SRxST", "SRxLT", "LRxST", "LRxLT", "any")

SMALL_ANGLES = np.array([math.pi / 2, math.pi / 4, math.pi / 2])  # alpha, beta, gamma
LARGE_ANGLES = np.array([math.pi, math.pi / 2, math.pi])


@dataclass(frozen=True)
class Motion:
    """A rigid motion M of the aligned source: R rotates it about its centroid, t translates it."""

    index: int
    kind: str  # one of CLASSES
    angles: Array  # alpha, beta, gamma: Z-Y-X Euler angles in radians
    translation: Array  # user's unit
    matrix: Array  # (4, 4), aligned source -> moved source

    @property
    def T_true(self) -> Array:
        """The pose to be found, moved source into target: the inverse of the motion."""
        R, t = self.matrix[:3, :3], self.matrix[:3, 3]
        return _rigid(R.T, -R.T @ t)


def motion(pair: str, index: int, aligned: Array) -> Motion:
    """Motion ``index`` of a pair, for its aligned source (n, 3) in the target's frame."""
    rng = np.random.default_rng([zlib.crc32(pair.encode()), index])
    kind = CLASSES[index % len(CLASSES)]
    diagonal = float(np.linalg.norm(np.ptp(aligned, axis=0)))
    if kind == "any":
        angles = rng.uniform(-LARGE_ANGLES, LARGE_ANGLES)
        translation = rng.uniform(-diagonal, diagonal, 3)
    else:
        rotation, distance = kind.split("x")
        angles = _signed(rng, *_angle_limits(rotation))
        translation = _signed(rng, *_translation_limits(distance, diagonal))
    R = euler_zyx(angles)
    # The rotation is about the centroid, so that the translation says how far the cloud went.
    center = aligned.mean(axis=0)
    return Motion(index, kind, angles, translation, _rigid(R, center + translation - R @ center))


def euler_zyx(angles: Array) -> Array:
    """R = Rz(alpha) Ry(beta) Rx(gamma), about fixed axes, (3, 3)."""
    (ca, cb, cg), (sa, sb, sg) = np.cos(angles), np.sin(angles)
    z = np.array([[ca, -sa, 0.0], [sa, ca, 0.0], [0.0, 0.0, 1.0]])
    y = np.array([[cb, 0.0, sb], [0.0, 1.0, 0.0], [-sb, 0.0, cb]])
    x = np.array([[1.0, 0.0, 0.0], [0.0, cg, -sg], [0.0, sg, cg]])
    return np.asarray(z @ y @ x, dtype=np.float64)


def apply(T: Array, points: Array) -> Array:
    """The points (n, 3) moved by a 4x4 matrix."""
    return np.asarray(points @ T[:3, :3].T + T[:3, 3], dtype=np.float64)


def frame_scale(source: Array, target: Array) -> float:
    """One unit of the normalized frame: the larger of the clouds' radii about their centroids."""
    radii = [np.linalg.norm(c - c.mean(axis=0), axis=1).max() for c in (source, target)]
    return float(max(radii))


def _angle_limits(rotation: str) -> tuple[Array, Array]:
    if rotation == "SR":
        return np.zeros(3), SMALL_ANGLES
    return SMALL_ANGLES, LARGE_ANGLES


def _translation_limits(distance: str, diagonal: float) -> tuple[Array, Array]:
    low, high = (0.0, 0.5) if distance == "ST" else (0.5, 1.0)
    return np.full(3, low * diagonal), np.full(3, high * diagonal)


def _signed(rng: np.random.Generator, low: Array, high: Array) -> Array:
    """Each component's magnitude between its limits, its sign at random."""
    return np.asarray(rng.uniform(low, high) * rng.choice([-1.0, 1.0], size=low.shape))


def _rigid(R: Array, t: Array) -> Array:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = R, t
    return matrix
