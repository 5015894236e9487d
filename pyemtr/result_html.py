"""A result as notebooks show it: the verdict, and a small picture in SVG."""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .result import Result

_GOOD, _DOUBTFUL, _BACK = "#2a7f3f", "#b3541e", "#dddddd"


def html_of(result: Result) -> str:
    """Returns HTML that needs neither a script nor another package."""
    color = _GOOD if result.registered else _DOUBTFUL
    verdict = "registered" if result.registered else f"not registered: {result.reason_text}"
    rows = "<br>".join(
        " ".join(f"{value:12.6g}" for value in row).replace(" ", "&nbsp;")
        for row in result.transformation
    )
    return (
        f'<div><b style="color:{color}">{escape(verdict)}</b>, {escape(_facts(result))}<br>'
        f"{_picture(result, color)}<br>"
        f'transformation, source into target:<div style="font-family:monospace">{rows}</div></div>'
    )


def _facts(result: Result) -> str:
    parts = [
        f"{result.points_source} points to {result.points_target}",
        f"rmse {result.inlier_rmse:.4g}",
        f"{len(result.alternatives)} alternatives",
        f"{result.timings['total']:.3f} s",
    ]
    return ", ".join(part for part in parts if "nan" not in part)


def _picture(result: Result, color: str) -> str:
    bars = [
        ("confidence", result.confidence),
        ("overlap, source", result.overlap_source),
        ("overlap, target", result.overlap_target),
    ]
    parts = [_bar(row, name, share, color) for row, (name, share) in enumerate(bars)]
    return (
        '<svg width="260" height="84" font-family="sans-serif" font-size="11" fill="currentColor">'
        f"{''.join(parts)}</svg>"
    )


def _bar(row: int, name: str, share: float, color: str) -> str:
    top = 6 + 26 * row
    known = math.isfinite(share)
    length = 100 * min(max(share, 0.0), 1.0) if known else 0.0
    return (
        f'<text x="0" y="{top + 11}">{name}</text>'
        f'<rect x="95" y="{top}" width="100" height="14" fill="{_BACK}"/>'
        f'<rect x="95" y="{top}" width="{length:.1f}" height="14" fill="{color}"/>'
        f'<text x="200" y="{top + 11}">{f"{share:.0%}" if known else "unknown"}</text>'
    )
