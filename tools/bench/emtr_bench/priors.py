"""Priors of a run: a guess near the true pose, or the axis of the true rotation."""

from __future__ import annotations

import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

PRIORS = ("guess", "axis")
GUESS_DEGREES, GUESS_RADII = 20.0, 0.3


def prior(
    kind: str, pair: str, index: int, T_true: Array, center: Array, scale: float
) -> dict[str, Any]:
    """Keyword arguments for motion ``index`` of a pair, which the pose T_true (4, 4) satisfies.

    ``center`` (3,) is the moved source's centroid, ``scale`` one radius, in the user's unit.
    "guess": a pose up to 20 degrees and 0.3 radii away from the true one, and that it is no
    further. "axis": the axis of the true rotation, which is the same in both clouds' frames.
    """
    R_true = T_true[:3, :3]
    if kind == "axis":
        return {"axis": np.linalg.svd(R_true - np.eye(3))[2][2]}  # what it leaves as it is
    rng = np.random.default_rng([zlib.crc32(pair.encode()), index, 1])
    off = _rotation(_direction(rng), np.radians(rng.uniform(0, GUESS_DEGREES)))
    translation = scale * rng.uniform(0, GUESS_RADII) * _direction(rng)
    guess = np.eye(4)
    guess[:3, :3] = off @ R_true
    # The centroid ends at its true position plus the translation.
    guess[:3, 3] = R_true @ center + T_true[:3, 3] + translation - guess[:3, :3] @ center
    return {
        "guess": guess,
        "guess_rotation": GUESS_DEGREES,
        "guess_translation": GUESS_RADII * scale,
    }


def _direction(rng: np.random.Generator) -> Array:
    vector = rng.normal(size=3)
    return np.asarray(vector / np.linalg.norm(vector), dtype=np.float64)


def _rotation(axis: Array, angle: float) -> Array:
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    rotation = np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross
    return np.asarray(rotation, dtype=np.float64)
