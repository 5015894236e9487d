"""Reads text files with one point a line."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np

from .columns import axes_among

_COMMENTS = ("#", "%", "!", "//")


class _Layout(NamedTuple):
    skipped: int  # lines before the first point
    delimiter: str | None  # None: white space
    columns: list[int]  # of x, y and z
    points: int | None  # how many follow, where the file says it


def read_text(path: str) -> Any:
    """Returns the points of a text file: float64 (N, 3).

    A line has x, y, z and any further numbers, between white space, commas or semicolons. Lines
    that begin with #, %, ! or // are comments. A line of names may come first, a comment too: x, y
    and z, in either case, are then taken by name. So may a line with the number of points that
    follow, and again behind them (PTS). An empty cell between commas or semicolons is a NaN.

    Raises:
        ValueError: a line is no point, or the number of points is not as the file says.
    """
    with open(path, encoding="utf-8-sig") as file:
        layout = _layout(file)
        try:
            return _points(file, layout)
        except ValueError:
            if layout.delimiter is None:
                raise
            return _points(file, layout, _number)  # it takes empty cells, and its time


def _points(file: Any, layout: _Layout, number: Any = None) -> Any:
    counts = [] if layout.points is None else [layout.points]
    file.seek(0)
    lines = itertools.islice(file, layout.skipped, None)
    points = np.loadtxt(
        _without_counts(lines, counts) if counts else lines,
        comments=_COMMENTS,
        converters=number,
        delimiter=layout.delimiter,
        usecols=layout.columns,
        ndmin=2,
    )
    if counts and sum(counts) != len(points):
        raise ValueError(f"it says that it has {sum(counts)} points, and has {len(points)}")
    return points


def _without_counts(lines: Iterable[str], counts: list[int]) -> Iterator[str]:
    """The lines but those of one whole number, which are added to ``counts``."""
    for line in lines:
        if line.strip().isdigit():
            counts.append(int(line))
        else:
            yield line


def _number(cell: str | bytes) -> float:
    return float(cell) if cell.strip() else np.nan


def _layout(lines: Any) -> _Layout:
    count, columns, comment = None, [0, 1, 2], ""
    for number, line in enumerate(lines):
        text = line.strip()
        if text.startswith(_COMMENTS):
            comment = text if _axes_in(text) or not comment else comment
        if not text or text.startswith(_COMMENTS):
            continue
        delimiter = _delimiter(text)
        words = [word for word in re.split(r"[;,\s]+", text) if word] or [""]
        if count is None and len(words) == 1 and words[0].isdigit():
            count = int(words[0])
        elif not _is_number(words[0]):
            columns = _named(text)
        else:
            if len(words) < 3:
                raise ValueError(
                    f"line {number + 1}: expected at least three numbers, got {text!r}"
                )
            cells = len(text.rstrip(";,").split(delimiter))
            if columns == [0, 1, 2] and len(_names(comment)) == cells:
                columns = _axes_in(comment) or columns
            return _Layout(number, delimiter, columns, count)
    raise ValueError("expected at least one point, got none")


def _delimiter(text: str) -> str | None:
    return next((mark for mark in ";," if mark in text), None)


def _names(line: str) -> list[str]:
    """The names of columns in a line, which may be a comment."""
    text = line.lstrip("#%!/ \t")
    return [name.strip(" \t\"'") for name in text.split(_delimiter(text))]


def _axes_in(comment: str) -> list[int] | None:
    """The columns of x, y and z that a comment names, None where it does not."""
    names = [name.lower() for name in _names(comment)]
    return [names.index(axis) for axis in "xyz"] if {"x", "y", "z"} <= set(names) else None


def _named(text: str) -> list[int]:
    places = axes_among(_names(text))
    if places is None:
        raise ValueError(
            f"expected names of columns with x, y and z, or numbers, got {text[:80]!r}"
        )
    return places


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
