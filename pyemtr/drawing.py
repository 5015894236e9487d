"""Point clouds as shaded, depth-ordered points on a matplotlib Axes."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .arrays import Floats
from .camera import Camera

if TYPE_CHECKING:
    from matplotlib.axes import Axes

INK = "#333333"
_CAPTION = 0.10  # share of a panel's height that is kept free at the top
_AMBIENT = 0.34
_LIGHT = np.array([-0.45, 0.55, 0.70]) / np.linalg.norm([-0.45, 0.55, 0.70])  # of the viewer


def shaded(colors: Floats, normals: Floats, camera: Camera) -> Floats:
    """Colors (N, 3) as a lamp at the viewer's left shoulder shows them; both sides are lit."""
    seen = normals @ camera.axes.T
    seen = np.where(seen[:, 2:] < 0, -seen, seen)
    light = _AMBIENT + (1 - _AMBIENT) * np.clip(seen @ _LIGHT, 0, 1)
    gloss = 0.25 * np.clip(seen @ _LIGHT, 0, 1)[:, None] ** 24
    return np.asarray(np.clip(colors * (1.18 * light)[:, None] + gloss, 0, 1))


def draw_points(
    ax: Axes, points: Floats, colors: Floats, camera: Camera, gap: float, unit: str
) -> None:
    """Fills ``ax`` with points (N, 3) in colors (N, 3), the nearest on top, equal scales.

    ``gap``, the usual distance between neighbors, decides how large the points are drawn.
    """
    seen = points @ camera.axes.T
    low, high = seen[:, :2].min(axis=0), seen[:, :2].max(axis=0)
    inches = np.array([ax.bbox.width, ax.bbox.height]) / ax.figure.dpi
    # one length of the clouds is one length of the paper, in both directions
    room = inches * [1.0, 1 - _CAPTION]
    scale = float(np.min(room / np.maximum(1.06 * (high - low), 1e-12 + 1e-9 * abs(high))))
    center, half = (low + high) / 2, inches / scale / 2
    center[1] += _CAPTION * half[1]
    ax.set(
        xlim=(center[0] - half[0], center[0] + half[0]),
        ylim=(center[1] - half[1], center[1] + half[1]),
        xticks=[],
        yticks=[],
    )
    for spine in ax.spines.values():
        spine.set_color("#d5d5d5")

    order = np.argsort(seen[:, 2], kind="stable")
    diameter = min(max(1.5 * gap * scale * 72, 0.9), 6.0)  # in points, of 1/72 inch
    ax.scatter(
        seen[order, 0],
        seen[order, 1],
        s=diameter**2,
        c=colors[order],
        marker="o",
        linewidths=0,
        rasterized=True,
    )
    _scale_bar(ax, float(inches[0]) / scale, unit)


def _scale_bar(ax: Axes, width: float, unit: str) -> None:
    """A line of a round length, about a fifth of ``width``."""
    wanted = 0.2 * width
    power = 10.0 ** math.floor(math.log10(wanted))
    length = max(step * power for step in (1, 2, 5) if step * power <= wanted)
    ax.plot(
        [0.03, 0.03 + length / width],
        [0.035, 0.035],
        transform=ax.transAxes,
        color=INK,
        linewidth=2,
        solid_capstyle="butt",
    )
    ax.text(
        0.03,
        0.05,
        f"{length:g} {unit}".strip(),
        transform=ax.transAxes,
        color=INK,
        fontsize=9,
        va="bottom",
    )
