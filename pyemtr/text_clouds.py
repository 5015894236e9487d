"""Reads text files with one point a line."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

import numpy as np

from .columns import axes_among

_COMMENTS = ("#", "//")


class _Layout(NamedTuple):
    skipped: int  # lines before the first point
    delimiter: str | None  # None: white space
    columns: list[int]  # of x, y and z
    points: int | None  # how many, where the file says it


def read_text(path: str) -> Any:
    """Returns the points of a text file: float64 (N, 3).

    A line has x, y, z and any further numbers, between white space, commas or semicolons. Lines
    that begin with # or // are comments. A line of names may come first: x, y and z, in either
    case, are then taken by name. So may a line with the number of points (PTS).

    Raises:
        ValueError: a line is no point, or the number of points is not as the file says.
    """
    with open(path, encoding="utf-8-sig") as file:
        layout = _layout(file)
        file.seek(0)
        points = np.loadtxt(
            file,
            comments=_COMMENTS,
            delimiter=layout.delimiter,
            skiprows=layout.skipped,
            usecols=layout.columns,
            ndmin=2,
        )
    if layout.points not in (None, len(points)):
        raise ValueError(f"it says that it has {layout.points} points, and has {len(points)}")
    return points


def _layout(lines: Any) -> _Layout:
    count, columns = None, [0, 1, 2]
    for number, line in enumerate(lines):
        text = line.strip()
        if not text or text.startswith(_COMMENTS):
            continue
        delimiter = next((mark for mark in ";," if mark in text), None)
        words = [word for word in re.split(r"[;,\s]+", text) if word] or [""]
        if count is None and len(words) == 1 and words[0].isdigit():
            count = int(words[0])
        elif not _is_number(words[0]):
            columns = _named(text, delimiter)
        else:
            if len(words) < 3:
                raise ValueError(
                    f"line {number + 1}: expected at least three numbers, got {text!r}"
                )
            return _Layout(number, delimiter, columns, count)
    raise ValueError("expected at least one point, got none")


def _named(text: str, delimiter: str | None) -> list[int]:
    names = [name.strip(" \t\"'") for name in text.split(delimiter)]
    places = axes_among(names)
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
