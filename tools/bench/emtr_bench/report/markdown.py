"""Tables and numbers in Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

Quartiles = dict[str, Any]  # low, median, high; null in JSON is None


def table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """The first column to the left, figures to the right."""
    lines = [heads, ["---"] + ["--:"] * (len(heads) - 1), *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


def number(value: float | None, digits: int = 2) -> str:
    return "" if value is None else f"{value:.{digits}f}"


def quartiles(values: Quartiles, digits: int = 3) -> str:
    """``0.152 (0.120 to 0.201)``: the median and the quartiles."""
    if values["median"] is None:
        return ""
    low, high = (number(values[key], digits) for key in ("low", "high"))
    return f"{number(values['median'], digits)} ({low} to {high})"
