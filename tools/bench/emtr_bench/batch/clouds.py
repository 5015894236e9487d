"""Small pairs in a folder: scans of bumpy balls, and a list of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ..bumpy_ball import ball_pair

LIST = "pairs.csv"
PAIRS_OF_A_BALL = 20  # each cloud is in so many pairs, which differ by their seeds


def write_pairs(folder: Path, pairs: int, points: int) -> Path:
    """Writes the clouds and returns the list."""
    lines = ["source,target,name,seed"]
    for number in range(pairs):
        ball, seed = divmod(number, PAIRS_OF_A_BALL)
        source, target = f"source_{ball}.npy", f"target_{ball}.npy"
        if seed == 0:
            made = ball_pair(points, ball)
            np.save(folder / source, made.source)
            np.save(folder / target, made.target)
        lines.append(f"{source},{target},ball {ball}.{seed},{seed}")
    path = folder / LIST
    path.write_text("\n".join(lines) + "\n")
    return path
