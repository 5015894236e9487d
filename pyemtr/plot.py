"""Pictures of a registration: the clouds before and after, and the distances between them.

Needs matplotlib and scipy: ``pip install 'pyemtr[plot]'``.
"""

from __future__ import annotations

import io
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .arrays import Floats, as_transformation, as_vector
from .camera import Camera, best_view, side_view
from .drawing import INK, draw_points, shaded
from .neighborhood import neighbor_tree, spacing, subsampled, surface_normals
from .points import as_points
from .whole_file import write_whole

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["plot_alignment"]

SOURCE_COLOR = np.array([0.93, 0.50, 0.13])
TARGET_COLOR = np.array([0.16, 0.47, 0.74])
_BEYOND = np.array([0.80, 0.80, 0.80])  # points with no counterpart


def plot_alignment(
    source: Any,
    target: Any,
    transformation: Any,
    path: str | os.PathLike[str] | None = None,
    *,
    title: str | None = None,
    unit: str = "",
    up: Sequence[float] = (0.0, 0.0, 1.0),
    view: Sequence[float] | None = None,
    max_points: int = 50000,
    dpi: int = 130,
) -> Figure:
    """Draws the clouds as they were given, after the registration from two sides, and an error map.

    The error map shows the distance of each moved source point to its nearest target point, up
    to four times the target's point spacing; what lies beyond has no counterpart and is gray.

    Args:
        source, target: clouds as :func:`pyemtr.register` takes them, in one unit. Points with NaN
            or infinity are left out.
        transformation: (4, 4), source into target: q = R p + t; or a :class:`pyemtr.Result`.
        path: file to write (.png, .pdf, .svg ...), whole or not at all, without a display. None:
            the figure belongs to pyplot, for ``matplotlib.pyplot.show()``.
        title: a line above the panels, such as the verdict.
        unit: name of the clouds' unit, for the scale bars and the color bar.
        up: direction (3,) in the target's frame that is drawn upwards.
        view: direction (3,) in the target's frame, from the clouds to the viewer. None: the side
            from which most points are seen.
        max_points: of each cloud that are drawn, evenly over its rows; the distances are taken
            to all of the target.
        dpi: dots an inch of the 13 x 11.4 inch figure.

    Returns:
        The matplotlib Figure.

    Raises:
        ImportError: matplotlib or scipy is not installed.
        TypeError, ValueError: not a cloud, no finite point, not a finite (4, 4) matrix, a
            direction without length, ``max_points`` or ``dpi`` below 1.
        OSError: the file cannot be written.
    """
    _require_libraries()
    clouds = {"source": _finite(source, "source"), "target": _finite(target, "target")}
    matrix = as_transformation(transformation, "transformation")
    upward = _direction(up, "up")
    for name, value in (("max_points", max_points), ("dpi", dpi)):
        if value < 1:
            raise ValueError(f"{name}: expected 1 or more, got {value}")

    before = subsampled(clouds["source"], max_points)
    after = before @ matrix[:3, :3].T + matrix[:3, 3]
    fixed = subsampled(clouds["target"], max_points)
    normals_after = surface_normals(after)
    normals_fixed = surface_normals(fixed)
    normals_before = normals_after @ matrix[:3, :3]
    both = np.concatenate([after, fixed]), np.concatenate([normals_after, normals_fixed])
    # Points of the two clouds may coincide, so each cloud has its own spacing.
    gap = max(spacing(after), spacing(fixed))
    if view is None:
        front = best_view(both[0], upward, gap)
    else:
        front = Camera.towards(_direction(view, "view"), upward)
    side, aside = side_view(front, both[0], upward, gap)

    figure = _new_figure(path is None, dpi)
    (first, second), (third, fourth) = _panels(figure)
    colors = np.concatenate(
        [np.broadcast_to(SOURCE_COLOR, after.shape), np.broadcast_to(TARGET_COLOR, fixed.shape)]
    )
    for ax, name, points, normals, eye in (
        (
            first,
            "before, as in the files",
            np.concatenate([before, fixed]),
            np.concatenate([normals_before, normals_fixed]),
            front,
        ),
        (second, "after", *both, front),
        (third, f"after, from further {side}", *both, aside),
    ):
        draw_points(ax, points, shaded(colors, normals, eye), eye, gap, unit)
        _caption(ax, name)
    _legend(first)
    _error_map(fourth, after, normals_after, clouds["target"], front, unit)
    if title:
        figure.suptitle(title, x=0.02, y=0.985, ha="left", va="top", fontsize=15, color=INK)
    if path is not None:
        _save(figure, Path(path), dpi)
    return figure


def _error_map(
    ax: Axes, points: Floats, normals: Floats, target: Floats, camera: Camera, unit: str
) -> None:
    from matplotlib import colormaps
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    distances, _ = neighbor_tree(target).query(points)
    limit = 4 * spacing(target) or float(distances.max()) or 1.0
    near = distances <= limit
    scale = ScalarMappable(Normalize(0, limit), colormaps["RdYlBu_r"])
    colors = np.where(near[:, None], scale.to_rgba(distances)[:, :3], _BEYOND)
    draw_points(ax, points, shaded(colors, normals, camera), camera, spacing(points), unit)
    _caption(ax, "moved source: distance to the target")
    inside = ax.inset_axes((0.94, 0.05, 0.022, 0.42))
    bar = ax.figure.colorbar(scale, cax=inside)
    bar.ax.yaxis.set_ticks_position("left")
    bar.ax.tick_params(labelsize=9, colors=INK)
    bar.ax.set_title(unit, fontsize=9, color=INK)
    text = f"{near.mean():.0%} within {limit:.3g} {unit}".rstrip()
    if near.any():
        rms = float(np.sqrt(np.mean(distances[near] ** 2)))
        text += f", rms {rms:.3g} {unit}".rstrip()
    ax.text(
        0.03,
        0.915,
        f"{text}; gray: beyond",
        transform=ax.transAxes,
        fontsize=10,
        color=INK,
        va="top",
    )


def _panels(figure: Figure) -> list[list[Axes]]:
    width, height = 0.475, 0.465
    return [
        [figure.add_axes((left, bottom, width, height)) for left in (0.015, 0.51)]
        for bottom in (0.485, 0.01)
    ]


def _caption(ax: Axes, text: str) -> None:
    ax.text(
        0.03,
        0.965,
        text,
        transform=ax.transAxes,
        fontsize=12,
        fontweight="bold",
        color=INK,
        va="top",
    )


def _legend(ax: Axes) -> None:
    for row, (name, color) in enumerate((("source", SOURCE_COLOR), ("target", TARGET_COLOR))):
        ax.text(
            0.97,
            0.965 - 0.05 * row,
            name,
            transform=ax.transAxes,
            fontsize=12,
            fontweight="bold",
            color=tuple(color),
            ha="right",
            va="top",
        )


def _finite(cloud: Any, name: str) -> Floats:
    points: Floats = as_points(cloud, name).astype(np.float64)
    points = points[np.isfinite(points).all(axis=1)]
    if not len(points):
        raise ValueError(f"{name}: expected at least one finite point, got none")
    return points


def _direction(vector: Sequence[float], name: str) -> Floats:
    direction = as_vector(vector, name, 3)
    if not direction.any():
        raise ValueError(f"{name}: expected a direction, got a vector without length")
    return direction


def _require_libraries() -> None:
    try:
        import matplotlib  # noqa: F401
        import scipy.spatial  # noqa: F401
    except ImportError as error:
        raise ImportError(
            f"plots need matplotlib and scipy, and {error.name} is not installed: "
            "pip install 'pyemtr[plot]'"
        ) from error


def _new_figure(interactive: bool, dpi: int) -> Figure:
    size = (13.0, 11.4)
    if interactive:
        from matplotlib import pyplot

        return pyplot.figure(figsize=size, facecolor="white")
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, dpi=dpi, facecolor="white")
    FigureCanvasAgg(figure)
    return figure


def _save(figure: Figure, path: Path, dpi: int) -> None:
    content = io.BytesIO()
    figure.savefig(content, dpi=dpi, format=path.suffix[1:] or "png")
    write_whole(path, content.getvalue())
