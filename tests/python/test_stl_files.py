"""Meshes in STL files, by their bytes and by their text."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest

from pyemtr.stl_files import read_stl

VERTICES = np.random.default_rng(4).normal(size=(7, 3)).astype("f4").astype(float)
FACES = np.array([[3, 0, 1], [1, 0, 2], [2, 4, 5], [6, 5, 4]])
FIRST = [3, 0, 1, 2, 4, 5, 6]  # the vertices in the order in which they come first


def binary(corners: np.ndarray, count: int | None = None) -> bytes:
    rows = np.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("m", "<u2")])
    rows["corners"] = corners
    declared = len(rows) if count is None else count
    return b"solid, but binary".ljust(80) + struct.pack("<I", declared) + rows.tobytes()


def text(corners: np.ndarray) -> bytes:
    lines = ["solid made by a test", ""]
    for face in corners.tolist():
        lines += ["facet normal 0 0 0", " outer loop"]
        lines += [f"  vertex {x!r} {y!r} {z!r}" for x, y, z in face]
        lines += [" endloop", "endfacet"]
    return "\n".join([*lines, "endsolid made by a test", ""]).encode()


@pytest.mark.parametrize("write", [binary, text])
def test_equal_corners_are_one_vertex(tmp_path: Path, write) -> None:
    (tmp_path / "a.stl").write_bytes(write(VERTICES[FACES]))
    mesh = read_stl(str(tmp_path / "a.stl"))
    assert np.array_equal(mesh.vertices, VERTICES[FIRST])
    assert np.array_equal(mesh.vertices[mesh.faces], VERTICES[FACES])


def test_minus_zero_is_zero(tmp_path: Path) -> None:
    corners = np.array(
        [[[0.0, 0, 0], [1, 0, 0], [0, 1, 0]], [[-0.0, 0, 0], [1, -0.0, 0], [0, 0, 1]]]
    )
    (tmp_path / "a.stl").write_bytes(text(corners))
    assert len(read_stl(str(tmp_path / "a.stl")).vertices) == 4


BAD = {
    "empty": (b"", "truncated or no STL file"),
    "another count": (binary(VERTICES[FACES], 5)[5:].rjust(284), "50 for each of 5 triangles"),
    "cut text": (text(VERTICES[FACES])[:-40], "no last line 'endsolid'|is no vertex|three"),
    "no facets": (b"solid x\nendsolid x\n", "expected facets, got none"),
    "no binary facets": (binary(VERTICES[FACES][:0]), "expected facets, got none"),
    "two corners": (
        text(VERTICES[FACES]).replace(b"  vertex", b"  vertx", 1),
        "line 8 ends a face",
    ),
    "a word": (b"solid x\nvertex 1 2 c\nendsolid\n", "line 2: could not convert"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_files_are_refused(tmp_path: Path, name: str) -> None:
    content, message = BAD[name]
    (tmp_path / "a.stl").write_bytes(content)
    with pytest.raises(ValueError, match=message):
        read_stl(str(tmp_path / "a.stl"))
