"""A generated pair of clouds, the same bytes on each machine."""

from __future__ import annotations

import math
from pathlib import Path

COLUMNS, ROWS = 90, 70
ROTATION = (0.36, 0.48, -0.8), (-0.8, 0.6, 0.0), (0.48, 0.64, 0.6)  # orthonormal, in few digits


def write(folder: Path) -> None:
    """Writes source.xyz and target.xyz: two parts of one relief, one of them rotated and moved.

    The digits written are so few that no library of mathematics can change them.
    """
    folder.mkdir(parents=True, exist_ok=True)
    relief = [
        (
            x,
            y,
            0.3 * math.sin(3 * x + y) * math.cos(2 * y) + 0.2 * x * y + 0.1 * math.sin(7 * x * y),
        )
        for x in (i / 40 - 1 for i in range(COLUMNS))
        for y in (j / 35 - 1 for j in range(ROWS))
    ]
    source = [point for point in relief if point[0] < 0.7]
    target = [
        tuple(sum(a * b for a, b in zip(row, point, strict=True)) + 0.5 for row in ROTATION)
        for point in relief
        if point[0] > -0.6
    ]
    for name, points in (("source", source), ("target", target)):
        lines = (" ".join(f"{value:.4f}" for value in point) for point in points)
        (folder / f"{name}.xyz").write_text("\n".join(lines) + "\n")
