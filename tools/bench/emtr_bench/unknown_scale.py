"""Sources of another scale: by what factor they are shrunk, and how well a run finds it."""

from __future__ import annotations

import math
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

#: Bounds of the factors that are drawn.
FREE, BOUNDED = (0.02, 50.0), (0.8, 1.25)
THOUSAND_EACH = 7  # one of so many motions has the factor between millimeters and meters
UNITS = (1.0, 10.0, 12.0, 25.4, 100.0, 304.8, 1000.0)
#: A scale is right within this share of it; and what surfaces without distortion allow.
MAX_SCALE_ERROR, PRECISE_SCALE_ERROR = 0.03, 0.01


def factor(mode: str, pair: str, index: int) -> float:
    """The true scale of motion ``index`` of a pair: the source is divided by it. 1 for ""."""
    rng = np.random.default_rng([zlib.crc32(pair.encode()), index, 77])
    if mode == "units":
        return float(rng.choice([*UNITS, *(1 / unit for unit in UNITS[1:])]))
    if mode == "free" and index % THOUSAND_EACH == THOUSAND_EACH - 1:
        return 1000.0
    low, high = {"free": FREE, "bounded": BOUNDED}.get(mode, (1.0, 1.0))
    return float(math.exp(rng.uniform(math.log(low), math.log(high))))


def settings(mode: str) -> dict[str, Any]:
    """The settings that let a run search such a factor."""
    if mode == "bounded":
        return {"scale": "bounded", "scale_minimum": BOUNDED[0], "scale_maximum": BOUNDED[1]}
    return {"scale": mode} if mode else {}


def split(T: Array) -> tuple[float, Array]:
    """The scale of a similarity (4, 4), and the matrix with its rotation alone."""
    scale = float(np.cbrt(np.linalg.det(T[:3, :3])))
    rigid = np.array(T)
    rigid[:3, :3] /= scale
    return scale, rigid


def is_rigid(T: Array) -> bool:
    """Tells whether the upper 3x3 is a rotation without a scale."""
    return abs(split(T)[0] - 1) < 1e-9


def rigid_at(T: Array, center: Array, factor: float) -> tuple[Array, float]:
    """The rigid motion (4, 4) of the source before it was divided by the factor that turns it and
    moves its centroid as the similarity T does afterwards; and the relative error of T's scale."""
    scale, rigid = split(T)
    end = T[:3, :3] @ (center / factor) + T[:3, 3]
    rigid[:3, 3] = end - rigid[:3, :3] @ center
    return rigid, abs(scale / factor - 1)
