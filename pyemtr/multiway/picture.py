"""A picture of a model: each scan in a color of its own, from two sides."""

from __future__ import annotations

import importlib.util
import io
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Floats
from ..camera import best_view, side_view
from ..drawing import INK, draw_points, shaded
from ..neighborhood import spacing, subsampled, surface_normals
from .rigid import moved

if TYPE_CHECKING:
    from .result import MultiwayResult

_POINTS = 60_000  # that are drawn, of all scans together
_LEGEND = 24  # names of scans that there is room for


def has_matplotlib() -> bool:
    """Tells whether the package is installed that draws."""
    return importlib.util.find_spec("matplotlib") is not None


def model_picture(result: MultiwayResult, model: int) -> bytes:
    """Returns a PNG of a model's scans after the alignment."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    members = result.models[model]
    parts, colors = [], []
    for k, scan in enumerate(members):
        surface = result.surface(scan)
        points = subsampled(moved(result.scans[scan].pose, surface), _POINTS // len(members))
        parts.append(points)
        colors.append(np.broadcast_to(color_of(k, len(members)), points.shape))
    points, tints = np.concatenate(parts), np.concatenate(colors)
    gap = max(spacing(part) for part in parts)
    normals = surface_normals(points)
    up = np.array([0.0, 0.0, 1.0])
    front = best_view(points, up, gap)
    _, aside = side_view(front, points, up, gap)
    figure = Figure(figsize=(13.0, 6.6), dpi=130, facecolor="white")
    FigureCanvasAgg(figure)
    for left, camera in ((0.01, front), (0.43, aside)):
        ax = figure.add_axes((left, 0.02, 0.41, 0.9))
        draw_points(ax, points, shaded(tints, normals, camera), camera, gap, "")
    left_out = len(result.left_out)
    title = f"model {model}: {len(members)} of {len(result.scans)} scans, {left_out} left out"
    figure.suptitle(title, x=0.015, y=0.985, ha="left", va="top", fontsize=14, color=INK)
    for k, scan in enumerate(members[:_LEGEND]):
        name = f"\N{BLACK CIRCLE} {result.scans[scan].name[:22]}"
        tint = tuple(0.85 * color_of(k, len(members)))
        figure.text(0.85, 0.9 - 0.036 * k, name, color=tint, fontsize=10, va="top")
    if len(members) > _LEGEND:
        figure.text(0.85, 0.9 - 0.036 * _LEGEND, f"and {len(members) - _LEGEND} more",
                    color=INK, fontsize=10, va="top")  # fmt: skip
    content = io.BytesIO()
    figure.savefig(content, format="png")
    return content.getvalue()


def color_of(index: int, count: int) -> Floats:
    """Returns the color (3,) of a scan, 0 to 1: hues around the circle, of two brightnesses."""
    from matplotlib.colors import hsv_to_rgb

    hue = (index * 0.618034) % 1.0 if count > 6 else index / max(count, 1)
    return np.asarray(hsv_to_rgb((hue, 0.72, 0.92 if index % 2 == 0 else 0.75)), dtype=np.float64)
