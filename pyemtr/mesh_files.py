"""Reads meshes from OBJ and OFF files, and tells which files are meshes.

Faces and vertices keep the order of the file. Points are spread over the faces in that order, here
and by the command, so both get the same points. Packages that read meshes sort the faces by their
numbers of corners, or leave out vertices that are in none.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from .arrays import Floats
from .mesh import has_area, triangles


class MeshFile(NamedTuple):
    """A mesh as a file has it."""

    vertices: Any
    faces: Any


def surface_or_points(vertices: Floats, polygons: Any, points: Any = None) -> Any:
    """Returns the mesh of a file: vertices (V, 3), and the rows of each face's corners, as lists or
    as triangles (F, 3).

    It is no surface if most of its vertices are in no face, or if the faces have no area. Then
    ``points`` are returned, the vertices if nothing is said.

    Raises ValueError when a face names a vertex that is not there.
    """
    if isinstance(polygons, np.ndarray):
        corners = polygons.ravel()
    else:
        corners = np.fromiter(chain.from_iterable(polygons), dtype=np.int64)
    if corners.size and not 0 <= corners.min() <= corners.max() < len(vertices):
        raise ValueError(f"a face names a vertex that is not among the {len(vertices)}")
    faces = polygons if isinstance(polygons, np.ndarray) else triangles(polygons)
    known = 2 * len(np.unique(corners)) >= len(vertices)
    if len(polygons) and known and has_area(vertices, faces):
        return MeshFile(vertices, faces)
    return vertices if points is None else points


def read_obj(path: str) -> Any:
    """Returns the mesh of an OBJ file, or its vertices (V, 3) if it has no faces.

    Raises ValueError for a line "v" or "f" that is none, by its number.
    """
    vertices: list[list[float]] = []
    polygons: list[list[int]] = []
    with open(path, "rb") as file:
        for number, line in enumerate(file, 1):
            words = line.split()
            if words[:1] == [b"v"]:
                vertices.append(three_numbers(words[1:], number))
            elif words[:1] == [b"f"]:
                polygons.append([_corner(word, len(vertices), number) for word in words[1:]])
    if not vertices:
        raise ValueError("expected lines 'v x y z', got none")
    return surface_or_points(np.array(vertices), polygons)


def _corner(word: bytes, known: int, line: int) -> int:
    """The row of a corner, "7", "7/2" or "-1//3": counted from 1, or from the last vertex."""
    place = _whole(word.split(b"/")[0], line)
    row = place - 1 if place > 0 else known + place
    if place == 0 or row < 0:
        raise ValueError(f"line {line}: {word.decode(errors='replace')!r} is no vertex")
    return row


def read_off(path: str) -> Any:
    """Returns the mesh of an ascii OFF file, or its vertices (V, 3) if it has no faces.

    Raises ValueError for what is no OFF file, and for a line that is not what it should be.
    """
    with open(path, "rb") as file:
        lines = _filled_lines(file)
        _, head = next(lines, (0, [b""]))
        keyword, more = head[0], head[1:]
        if not keyword.endswith(b"OFF") or keyword[:-3].strip(b"STCN"):
            raise ValueError("expected a first line 'OFF', with three coordinates a vertex")
        if more[:1] == [b"BINARY"]:
            raise ValueError("expected an ascii OFF file, got a binary one")
        number, counts = (1, more) if more else next(lines, (2, []))
        if len(counts) < 2:
            raise ValueError(f"line {number}: expected the numbers of vertices and of faces")
        rows, polygons = (_whole(word, number) for word in counts[:2])
        vertices = [three_numbers(words, at) for at, words in _next(lines, rows)]
        faces = []
        for at, words in _next(lines, polygons):
            corners = _whole(words[0], at)
            if not 0 <= corners < len(words):
                raise ValueError(f"line {at}: expected the vertices of a face, as many as it says")
            faces.append([_whole(word, at) for word in words[1 : 1 + corners]])
    return surface_or_points(np.array(vertices).reshape(-1, 3), faces)


def _filled_lines(file: Any) -> Iterator[tuple[int, list[bytes]]]:
    for number, line in enumerate(file, 1):
        words = line.split(b"#")[0].split()
        if words:
            yield number, words


def _next(
    lines: Iterator[tuple[int, list[bytes]]], count: int
) -> Iterator[tuple[int, list[bytes]]]:
    for _ in range(count):
        line = next(lines, None)
        if line is None:
            raise ValueError("truncated: it has fewer lines than it says")
        yield line


def three_numbers(words: list[bytes], line: int) -> list[float]:
    """Returns the first three of the words of a line as numbers; ValueError names the line."""
    try:
        values = [float(word) for word in words[:3]]
    except ValueError as error:
        raise ValueError(f"line {line}: {error}") from error
    if len(values) < 3:
        raise ValueError(f"line {line}: expected three coordinates, got {len(values)}")
    return values


def _whole(word: bytes, line: int) -> int:
    try:
        return int(word)
    except ValueError as error:
        text = word.decode(errors="replace")
        raise ValueError(f"line {line}: expected a whole number, got {text!r}") from error
