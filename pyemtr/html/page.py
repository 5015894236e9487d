"""The page of one registration."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Floats, as_vector
from ..mesh import MESH_POINTS
from ..points import as_points
from ..whole_file import write_whole
from .point_block import PointBlock, point_block
from .pose_residuals import pose_residuals
from .report import report_of
from .template_files import page_with

if TYPE_CHECKING:
    from ..result import Result

MAX_POINTS = 30_000
_MOST = 100_000  # points of a cloud, with which a page stays below 6 MB


def write_page(payload: dict[str, Any], path: str | os.PathLike[str]) -> None:
    """Writes the page that shows a :func:`page_payload`, whole or not at all. Raises OSError."""
    write_whole(path, page_with(payload).encode())


def page_payload(
    result: Result,
    source: Any,
    target: Any,
    *,
    title: str = "",
    names: Sequence[str] | None = None,
    unit: str = "",
    up: Sequence[float] | None = None,
    max_points: int = MAX_POINTS,
    threads: int = 0,
    mesh_points: int = MESH_POINTS,
) -> dict[str, Any]:
    """Returns what the page shows, as JSON values: the report, the points and their residuals.
    :meth:`pyemtr.Result.to_html` has the arguments and the errors."""
    if not 1 <= max_points <= _MOST:
        raise ValueError(f"max_points: expected 1 to {_MOST}, got {max_points}")
    if up is None:
        up = result.settings.get("axis") or (0.0, 0.0, 1.0)
    upward = as_vector(up, "up", 3)
    if not upward.any():
        raise ValueError("up: expected a direction, got a vector without length")
    called = _names(names, source, target)
    from_points = as_points(source, "source", mesh_points).astype(np.float64)
    to_points = as_points(target, "target", mesh_points).astype(np.float64)
    known = np.isfinite(result.transformation).all()  # else stopped before it was measured
    # The normalized frame's unit is the target's: the source's own is `scale` of it.
    radius = result.normalization_scale if known else np.nan
    shown = _block(from_points, "source", result.center_source, radius / result.scale, max_points)
    fixed = _block(to_points, "target", result.center_target, radius, max_points)
    poses = [result.transformation, *(other.transformation for other in result.alternatives)]
    return {
        "format": 1,
        "title": title,
        "unit": unit,
        "up": upward.tolist(),
        "report": report_of(result, called, (len(from_points), len(to_points))),
        "clouds": {"source": shown.to_json(), "target": fixed.to_json()},
        "residuals": pose_residuals(shown.points, to_points, poses, threads),
    }


def _block(points: Floats, name: str, center: Floats, radius: float, max_points: int) -> PointBlock:
    try:
        return point_block(points, center, radius, max_points)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from error


def _names(names: Sequence[str] | None, source: Any, target: Any) -> tuple[str, str]:
    """What the user calls the clouds: file names tell it, arrays do not."""
    if names is None:
        pairs = ((source, "source"), (target, "target"))
        first, second = (
            os.path.basename(os.fspath(cloud)) if isinstance(cloud, (str, os.PathLike)) else name
            for cloud, name in pairs
        )
        return str(first), str(second)
    if isinstance(names, str) or len(names) != 2 or not all(isinstance(n, str) for n in names):
        raise ValueError(f"names: expected two names, of the source and the target, got {names!r}")
    return names[0], names[1]
