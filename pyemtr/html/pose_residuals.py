"""How far the shown source points are from the target, under each pose of a result."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..arrays import Floats
from ..distances import residuals
from .point_block import LEVELS, packed


def pose_residuals(
    points: Floats, target: Any, poses: Sequence[Floats], threads: int
) -> list[dict[str, Any]]:
    """Returns for each pose (4, 4) the largest distance, and all of them as shares of it.

    ``points`` is float64 (n, 3). One query for all poses, so the target's kd-tree is built once.
    """
    if not poses or not all(np.isfinite(pose).all() for pose in poses):
        return []
    moved = np.concatenate([_moved(points, pose) for pose in poses])
    distances = residuals(moved, target, threads=threads).reshape(len(poses), len(points))
    return [_entry(row) for row in distances]


def _moved(points: Floats, pose: Floats) -> Floats:
    """The products are summed term by term, so that the command gets the same bits."""
    x, y, z = points.T
    return np.column_stack([row[0] * x + row[1] * y + row[2] * z + row[3] for row in pose[:3]])


def _entry(distances: Floats) -> dict[str, Any]:
    maximum = float(distances.max())
    shares = distances / maximum if maximum > 0 else np.zeros_like(distances)
    steps = np.floor(shares * LEVELS + 0.5).astype(np.uint16)
    return {"maximum": maximum, "values": packed(steps)}
