"""Meshes in files: OBJ and OFF, and which files are surfaces."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pyemtr.mesh import sample_mesh, triangles
from pyemtr.mesh_files import MeshFile, read_obj, read_off, surface_or_points

VERTICES = np.random.default_rng(4).normal(size=(9, 3))
POLYGONS = [[0, 1, 2], [2, 3, 4, 5], [5, 6, 7], [8, 0, 3, 6, 1], [1, 7, 8]]


def obj(faces: list[str]) -> str:
    text = "mtllib none.mtl\no one\n" + "".join(
        f"v {x!r} {y!r} {z!r}\n" for x, y, z in VERTICES.tolist()
    )
    return (
        text + "vt 0 1\nvn 0 0 1\ng part\nusemtl none\n" + "".join(f"f {face}\n" for face in faces)
    )


def off(head: str = "OFF\n# made by a test\n9 5 0\n") -> str:
    text = head + "".join(f"{x!r} {y!r} {z!r}\n\n" for x, y, z in VERTICES.tolist())
    return text + "".join(f"{len(f)} {' '.join(map(str, f))} 255 0 0 # red\n" for f in POLYGONS)


CORNERS = {
    "plain": lambda i: f"{i + 1}",
    "textured": lambda i: f"{i + 1}/1",
    "normals": lambda i: f"{i + 1}//1",
    "from the last": lambda i: f"{i - 9}/1/1",
}


@pytest.mark.parametrize("corner", CORNERS)
def test_obj(tmp_path: Path, corner: str) -> None:
    """The faces keep their order, whatever their numbers of corners: so points do."""
    faces = [" ".join(map(CORNERS[corner], polygon)) for polygon in POLYGONS]
    (tmp_path / "a.obj").write_text(obj(faces).replace("\n", "\r\n"))
    mesh = read_obj(str(tmp_path / "a.obj"))
    assert np.array_equal(mesh.vertices, VERTICES)
    assert np.array_equal(mesh.faces, triangles(POLYGONS))


def test_obj_without_faces_is_a_cloud(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_text(obj([]).replace("\nvt", " 0.5 0.5 0.5\nvt"))
    assert np.array_equal(read_obj(str(tmp_path / "a.obj")), VERTICES)


@pytest.mark.parametrize(
    "head", ["OFF\n9 5 0\n", "OFF 9 5 0\n", "STCNOFF\n9 5\n", "# first\n\nOFF # this\n9 5 0\n"]
)
def test_off(tmp_path: Path, head: str) -> None:
    (tmp_path / "a.off").write_text(off(head))
    mesh = read_off(str(tmp_path / "a.off"))
    assert np.array_equal(mesh.vertices, VERTICES)
    assert np.array_equal(mesh.faces, triangles(POLYGONS))


BAD = {
    "word.obj": ("v 1 2 x\n", "line 1: could not convert"),
    "short.obj": ("\nv 1 2\n", "line 2: expected three coordinates, got 2"),
    "zero.obj": (obj(["1 2 0"]), "line 16: '0' is no vertex"),
    "far back.obj": (obj(["1 2 -10"]), "line 16: '-10' is no vertex"),
    "far.obj": (obj(["1 2 10"]), "not among the 9"),
    "name.obj": (obj(["1 2 a/1"]), "line 16: expected a whole number, got 'a'"),
    "none.obj": ("# nothing\n", "lines 'v x y z', got none"),
    "none.off": ("", "a first line 'OFF'"),
    "other.off": (off("PLY\n9 5 0\n"), "a first line 'OFF'"),
    "four.off": (off("4OFF\n9 5 0\n"), "three coordinates"),
    "binary.off": ("OFF BINARY\n", "a binary one"),
    "counts.off": ("OFF\n9\n", "line 2: expected the numbers"),
    "counts too.off": ("OFF\n", "expected the numbers"),
    "cut.off": (off()[:-40], "as many as it says|truncated"),
    "cut more.off": (off("OFF\n90 5 0\n"), "truncated"),
    "far.off": (off().replace("3 5 6 7", "3 5 6 9"), "not among the 9"),
    "negative.off": (off().replace("3 5 6 7", "-3 5 6 9"), "as many as it says"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_files_are_refused(tmp_path: Path, name: str) -> None:
    content, text = BAD[name]
    (tmp_path / name).write_text(content)
    with pytest.raises(ValueError, match=text):
        (read_obj if name.endswith("obj") else read_off)(str(tmp_path / name))


def test_what_is_no_surface_is_a_cloud() -> None:
    assert isinstance(surface_or_points(VERTICES, POLYGONS), MeshFile)
    assert isinstance(surface_or_points(VERTICES, [[0, 1, 2, 3, 4]]), MeshFile)  # five of nine
    for polygons in (
        [],
        [[0, 1, 2, 3]],
        [[i, i, i] for i in range(9)],
        [[i, i + 1] for i in range(8)],
    ):
        assert surface_or_points(VERTICES, polygons) is VERTICES
    rows = np.zeros(9)
    assert surface_or_points(VERTICES, [], rows) is rows


@settings(max_examples=50, deadline=None)
@given(seed=st.integers(0, 2**32 - 1), faces=st.integers(1, 30))
def test_any_mesh_is_the_same_by_both_formats(tmp_path_factory, seed: int, faces: int) -> None:
    rng = np.random.default_rng(seed)
    vertices = rng.normal(size=(12, 3)) * 10.0 ** rng.integers(-8, 8)
    rows = [[int(i) for i in rng.integers(0, 12, rng.integers(3, 6))] for _ in range(faces)]
    rows.append(list(range(12)))  # so that all vertices are in one
    folder = tmp_path_factory.mktemp("mesh")
    lines = [f"{x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    (folder / "a.obj").write_text(
        "".join(f"v {line}\n" for line in lines)
        + "".join("f " + " ".join(str(i + 1) for i in row) + "\n" for row in rows)
    )
    (folder / "a.off").write_text(
        f"OFF\n12 {len(rows)} 0\n" + "".join(f"{line}\n" for line in lines)
        + "".join(f"{len(row)} {' '.join(map(str, row))}\n" for row in rows)
    )  # fmt: skip
    wanted = sample_mesh(vertices, triangles(rows), 50, "a")
    for mesh in (read_obj(str(folder / "a.obj")), read_off(str(folder / "a.off"))):
        assert sample_mesh(*mesh, 50, "a").tobytes() == wanted.tobytes()
