"""Trajectory files of the Redwood format: ``i j n``, then a 4x4 matrix that maps j into i."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..pairs import Array, DataError, nearest_rigid


@dataclass(frozen=True)
class Entry:
    """A pose (4, 4) that maps the points of fragment `source` into those of `target`."""

    source: int
    target: int
    pose: Array


def read_log(path: Path) -> list[Entry]:
    """The entries in the file's order. Raises DataError, which names the file."""
    lines = [line.split() for line in path.read_text(errors="replace").splitlines() if line.split()]
    entries = []
    try:
        if not lines or len(lines) % 5:
            raise ValueError(f"got {len(lines)} lines")
        for head in range(0, len(lines), 5):
            first, second = (int(word) for word in lines[head][:2])
            matrix = np.array([[float(word) for word in row] for row in lines[head + 1 : head + 5]])
            if matrix.shape != (4, 4):
                raise ValueError(f"got a matrix of shape {matrix.shape}")
            entries.append(Entry(second, first, matrix))
    except ValueError as error:
        raise DataError(
            f"{path}: expected blocks of a line i j n and four lines of a matrix: {error}"
        ) from error
    return [Entry(e.source, e.target, published(e.pose, path)) for e in entries]


def published(matrix: Array, path: Path) -> Array:
    """A published pose with an exact rotation: few printed digits leave it a little off."""
    u, singular, vt = np.linalg.svd(matrix[:3, :3])
    if np.abs(singular - 1.0).max() > 1e-2:
        return nearest_rigid(matrix, path)  # which tells
    rigid = matrix.copy()
    rigid[:3, :3], rigid[3] = u @ vt, (0.0, 0.0, 0.0, 1.0)
    return nearest_rigid(rigid, path)
