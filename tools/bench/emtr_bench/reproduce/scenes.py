"""A picture of each pair: before and after the registration, and how far each point is off."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ..pairs import Pair
from ..protocol import apply
from ..runner import Array, moved
from . import plan
from .figures import canvas, save
from .figures_of_runs import chosen
from .run_log import Record

POINTS = 8000  # of each cloud


def draw(records: Sequence[Record], pairs: Sequence[Pair], folder: Path) -> list[tuple[str, Path]]:
    """Row and file of each pair whose first motion the library has registered."""
    folder.mkdir(parents=True, exist_ok=True)
    found = []
    for pair in pairs:
        runs = [r for r in chosen(records, "library", plan.OURS, pair.name) if r["index"] == 0]
        if runs:
            path = _picture(pair, np.array(runs[0]["T"]), folder / f"{pair.name}.png")
            found.append((pair.paper_row or pair.name, path))
    return found


def _picture(pair: Pair, T: Array, path: Path) -> Path:
    case = moved(pair, 0)
    source, target = _some(case.source), _some(case.target)
    placed, true = apply(T, source), apply(case.motion.T_true, source)
    axes_of_target = np.linalg.svd(target - target.mean(axis=0), full_matrices=False)[2]
    figure, axes = canvas(1, 3, (11.0, 3.6))
    for axis, cloud, title in zip(axes[0], (source, placed), ("before", "after")):
        for points, color in ((target, "#2e6da4"), (cloud, "#d98324")):
            flat = points @ axes_of_target[:2].T
            axis.scatter(*flat.T, s=0.5, c=color, linewidths=0)
        axis.set_title(title)
    flat = placed @ axes_of_target[:2].T
    off = np.linalg.norm(placed - true, axis=1) / case.scale * 100.0
    dots = axes[0, 2].scatter(*flat.T, s=0.5, c=off, linewidths=0, cmap="viridis")
    figure.colorbar(dots, ax=axes[0, 2], label="% of the radius")
    axes[0, 2].set_title("distance from the true place")
    for axis in axes[0]:
        axis.set_aspect("equal")
        axis.set_axis_off()
    return save(figure, path)


def _some(points: Array) -> Array:
    if len(points) <= POINTS:
        return points
    return points[np.random.default_rng(0).choice(len(points), POINTS, replace=False)]
