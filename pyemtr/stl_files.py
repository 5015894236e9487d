"""Reads meshes from STL files."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from .arrays import Floats
from .mesh_files import surface_or_points, three_numbers

_STL_HEAD = 84  # bytes before the triangles, the last four of which are their number
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])


def read_stl(path: str) -> Any:
    """Returns the mesh of an STL file, ascii or binary. Equal corners are one vertex.

    Raises ValueError for what is no STL file, and for a truncated one.
    """
    size = os.path.getsize(path)
    with open(path, "rb") as file:
        head = file.read(_STL_HEAD)
        count = int.from_bytes(head[80:84], "little")
        # The text of a binary file may begin with "solid" too; its size is exact.
        if size >= _STL_HEAD and size == _STL_HEAD + _TRIANGLE.itemsize * count:
            rows = np.fromfile(file, _TRIANGLE, count)
            corners = rows["corners"].reshape(-1, 3).astype(np.float64)
        elif head.split()[:1] == [b"solid"]:
            file.seek(0)
            corners = _text_corners(file)
        else:
            raise ValueError(
                "truncated or no STL file: expected a first word 'solid', or 84 bytes and then 50"
                f" for each of {count} triangles"
            )
    if not len(corners):
        raise ValueError("expected facets, got none")
    corners += 0.0  # -0 and 0 are one place
    keys = corners.view(np.dtype((np.void, 24))).ravel()
    _, first, same = np.unique(keys, return_index=True, return_inverse=True)
    order = np.argsort(first)  # the vertices in the order in which they come first
    place = np.empty(len(order), dtype=np.int64)
    place[order] = np.arange(len(order))
    return surface_or_points(corners[first[order]], place[same].reshape(-1, 3))


def _text_corners(file: Any) -> Floats:
    corners: list[list[float]] = []
    words: list[bytes] = []
    for number, line in enumerate(file, 1):
        if not line.split():
            continue
        words = line.split()
        if words[0] == b"vertex":
            corners.append(three_numbers(words[1:], number))
        elif words[0] == b"endloop" and len(corners) % 3:
            raise ValueError(f"line {number} ends a face that has not three vertices")
    if words[:1] != [b"endsolid"]:
        raise ValueError("truncated: it has no last line 'endsolid'")
    return np.array(corners).reshape(-1, 3)
