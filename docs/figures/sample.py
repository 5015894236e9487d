"""The sample pair that the figures are drawn of, and what they share."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))

from sample_pair import make_pair  # noqa: E402

Array = NDArray[np.float64]

SOURCE, TARGET = "#ed8021", "#2978bd"  # as in the pictures of pyemtr.plot
RIGHT, WRONG = "#2a9d5c", "#c0392b"
INK, PALE = "#333333", "#b8b8b8"


@dataclass
class Sample:
    """Two scans (N, 3) and (M, 3) in mm, their sensors (3,), and the true pose (4, 4)."""

    source: Array
    target: Array
    source_sensor: Array
    target_sensor: Array
    pose: Array

    @property
    def moved(self) -> Array:
        """The source in the target's frame, by the true pose: (N, 3)."""
        return moved(self.source, self.pose)


def moved(points: Array, pose: Array) -> Array:
    return np.asarray(points @ pose[:3, :3].T + pose[:3, 3])


def make_sample(points: int = 40000) -> Sample:
    """The pair that tools/sample_pair.py makes, as its files have it."""
    pair = make_pair(points=points)
    clouds = [
        moved(seen.points, pose).astype(np.float32).astype(np.float64)
        for seen, pose in ((pair.source, pair.source_pose), (pair.target, pair.target_pose))
    ]
    sensors = [
        moved(seen.viewpoint, pose)
        for seen, pose in ((pair.source, pair.source_pose), (pair.target, pair.target_pose))
    ]
    return Sample(*clouds, *sensors, pair.transformation)


def new_figure(width: float, height: float, columns: int = 1) -> tuple[Figure, list[Axes]]:
    """A white figure of so many inches, with axes side by side."""
    figure = Figure(figsize=(width, height), facecolor="white", layout="constrained")
    axes = figure.subplots(1, columns, squeeze=False)[0]
    for ax in axes:
        ax.spines[["top", "right"]].set_visible(False)
        ax.spines[["left", "bottom"]].set_color(PALE)
        ax.tick_params(colors=INK, labelsize=9)
        ax.xaxis.label.set_color(INK)
        ax.yaxis.label.set_color(INK)
    return figure, list(axes)


def heading(ax: Axes, text: str, **options: Any) -> None:
    ax.set_title(text, loc="left", fontsize=10.5, color=INK, fontweight="bold", **options)
