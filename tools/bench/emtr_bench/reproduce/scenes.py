"""A picture of each pair, as the paper's rows of pictures: the input, where each method puts the
source, and the truth. Colors tell how far each point is from its true place."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..pairs import Pair
from ..protocol import apply
from ..runner import Array, Moved, moved
from . import plan
from .figures import canvas, save
from .figures_of_runs import chosen
from .run_log import Record

POINTS = 4000  # of each cloud
MOTION = 0  # of the pictures
COLUMNS = 5
#: Of the colors, percent of the radius.
NEAREST, FARTHEST = 0.1, 100.0


def draw(records: Sequence[Record], pairs: Sequence[Pair], folder: Path) -> list[tuple[str, Path]]:
    """Row and file of each pair whose first motion the library has registered."""
    folder.mkdir(parents=True, exist_ok=True)
    found = []
    for pair in pairs:
        runs = methods(records, pair)
        if plan.OURS in runs:
            path = _picture(moved(pair, MOTION), runs, folder / f"{pair.name}.png")
            found.append((pair.paper_row or pair.name, path))
    return found


def methods(records: Sequence[Record], pair: Pair) -> dict[str, Record]:
    """A run of each method on the pictures' motion, ours the last; of the evolving ones that with
    the larger budget, if it was made."""
    found: dict[str, Record] = {}
    for section in ("evolving", "evaluations", "traditional", "library"):
        for run in chosen(records, section, pair=pair.name):
            if run["index"] == MOTION and (section != "library" or run["method"] == plan.OURS):
                found[run["method"]] = run
    return found


def _picture(case: Moved, runs: dict[str, Record], path: Path) -> Path:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LogNorm

    source, target = _some(case.source), _some(case.target)
    true = apply(case.motion.T_true, source)
    plane = np.linalg.svd(target - target.mean(axis=0), full_matrices=False)[2][:2].T
    rows = math.ceil((len(runs) + 2) / COLUMNS)
    figure, axes = canvas(rows, COLUMNS, (2.3 * COLUMNS, 2.2 * rows))
    scale = ScalarMappable(LogNorm(NEAREST, FARTHEST), "turbo")
    places = iter(axes.ravel())

    def panel(title: str, cloud: Array, colors: Any) -> None:
        axis = next(places)
        axis.set_title(title, fontsize=8)
        for points, color in ((target, "#c8c8c8"), (cloud, colors)):
            axis.scatter(*(points @ plane).T, s=0.4, c=color, linewidths=0)

    panel("input", source, "#d98324")
    for name, run in runs.items():
        if run.get("T") is None:
            next(places).set_title(f"{name}, no pose", fontsize=8)
            continue
        placed = apply(np.array(run["T"]), source)
        off = np.linalg.norm(placed - true, axis=1) / case.scale * 100.0
        panel(f"{name}, {run['E_R']:.2f} degrees", placed, scale.to_rgba(off))
    panel("truth", true, "#2e6da4")
    for axis in axes.ravel():
        axis.set_aspect("equal")
        axis.set_axis_off()
    figure.colorbar(scale, ax=axes, label="off the true place, % of the radius", shrink=0.8)
    return save(figure, path)


def _some(points: Array) -> Array:
    if len(points) <= POINTS:
        return points
    return points[np.random.default_rng(0).choice(len(points), POINTS, replace=False)]
