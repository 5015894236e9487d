"""The pages of an alignment: one of the models, and one of each pair that was registered."""

from __future__ import annotations

import os
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ..arrays import Floats, as_vector
from ..html import page_payload, write_page
from ..html.point_block import point_block
from ..html.report import versions
from ..html.template_files import model_with
from ..result_json import to_json
from ..whole_file import write_whole

if TYPE_CHECKING:
    from .edges import Edge
    from .result import MultiwayResult

PAIRS = "pairs"  # the folder of the pages of pairs
Which = Literal["all", "taken", "none"]
_POINTS = 150_000  # that the page of the models shows, of all scans together
_CACHED = 8  # scans whose points stay in memory while pages of pairs are written
_EDGE = ("source", "target", "taken", "why", "alternative", "confidence", "probability", "loops",
         "degrees", "distance", "registered")  # fmt: skip


def write_pages(
    result: MultiwayResult,
    folder: str | os.PathLike[str],
    *,
    title: str,
    unit: str,
    up: Sequence[float],
    pairs: Which,
    max_points: int,
    threads: int,
) -> list[str]:
    """Does what :meth:`pyemtr.MultiwayResult.to_html` says."""
    if pairs not in ("all", "taken", "none"):
        raise ValueError(f"pairs: expected all, taken or none, got {pairs!r}")
    upward = as_vector(up, "up", 3)
    if not upward.any():
        raise ValueError("up: expected a direction, got a vector without length")
    out = Path(folder)
    (out / PAIRS).mkdir(parents=True, exist_ok=True)
    shown = [edge for edge in result.edges if pairs == "all" or (pairs == "taken" and edge.taken)]
    written = []

    @lru_cache(maxsize=_CACHED)
    def points(scan: int) -> Floats:
        return result.points(scan)

    for edge in shown:
        names = result.scans[edge.source].name, result.scans[edge.target].name
        payload = page_payload(
            result.registration(edge.source, edge.target), points(edge.source), points(edge.target),
            names=names, unit=unit, up=None, max_points=max_points, threads=threads,
        )  # fmt: skip
        write_page(payload, out / page_of(edge))
        written.append(page_of(edge))
    links = {id(edge) for edge in shown}
    payload = models_payload(result, title, unit, upward, links)
    write_whole(out / "index.html", model_with(payload).encode())
    return [*written, "index.html"]


def page_of(edge: Edge) -> str:
    """Returns the path of the page of a pair, from the folder of the pages."""
    return f"{PAIRS}/{edge.source:03d}_{edge.target:03d}.html"


def models_payload(
    result: MultiwayResult, title: str, unit: str, up: Floats, links: set[int]
) -> dict[str, Any]:
    """Returns what the page of the models shows, as JSON values. ``links`` has the ids of the edges
    that have a page."""
    each = max(_POINTS // max(len(result.placed), 1), 1)
    scans = []
    for i, scan in enumerate(result.scans):
        known = {name: getattr(scan, name)
                 for name in ("name", "placed", "text", "model", "edges", "overlap")}  # fmt: skip
        block = None
        if scan.placed:
            # A center that is not known: the surface has no strays.
            block = point_block(result.surface(i), np.full(3, np.nan), np.nan, each).to_json()
        pose = scan.pose.tolist() if scan.placed else None
        scans.append({**to_json(known), "pose": pose, "cloud": block})
    edges = [
        {
            **to_json({name: getattr(edge, name) for name in _EDGE}),
            "page": page_of(edge) if id(edge) in links else None,
        }
        for edge in result.edges
    ]
    return {
        "format": 1,
        "title": title,
        "unit": unit,
        "up": up.tolist(),
        "models": result.models,
        "scans": scans,
        "edges": edges,
        "seconds": result.seconds,
        "versions": versions(),
    }
