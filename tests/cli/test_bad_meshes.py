"""STL, OFF and OBJ files that are damaged."""

from __future__ import annotations

import mesh_files
import pytest

RELIEF = mesh_files.relief(8)


@pytest.mark.parametrize(
    ("text", "pattern"),
    [
        ("ply\n", "not an OFF file, expected a first line 'OFF'"),
        ("OFF\n", "truncated: ends where the line of counts is expected"),
        ("OFF BINARY\n", "is a binary OFF file"),
        ("4OFF\n1 0 0\n1 2 3 4\n", "vertices of four coordinates"),
        ("OFF3 1 0\n", "expected 'OFF' and a blank before the counts"),
        ("OFF\n-1 0 0\n", "line 2: expected a whole number from 0, got '-1'"),
        ("OFF\n3\n", "line 2: expected a whole number from 0, got ''"),
        ("OFF\n4000000000 0 0\n1 2 3\n", "truncated: it declares 4000000000 vertices"),
        ("OFF\n0 0 0\n", "holds no points"),
        ("OFF\n2 0 0\n1 2 3\n", "truncated: ends where vertex 2 is expected"),
        ("OFF\n1 0 0\n1 2\n", "line 3: expected the three coordinates"),
        ("OFF\n1 0 0\n1 2 x\n", "line 3: 'x' is not a number"),
        ("OFF\n3 1 0\n1 2 3\n1 2 4\n1 3 3\n3 0 1\n", "line 6: expected the vertices of a face"),
        ("OFF\n3 1 0\n1 2 3\n1 2 4\n1 3 3\n3 0 1 3\n", "face 1 has vertex 3, counted from 0, of 3"),
    ],
)
def test_off(refused, small, tmp_path, text, pattern):
    (tmp_path / "a.off").write_text(text)
    message = refused(2, "a.off", "b.pcd", "-o", "T.txt")
    assert "'a.off': " in message and pattern in message


def test_off_with_colors_tells_that_they_are_left_out(run, tmp_path):
    text = "COFF 30 0 0\n" + "".join(f"{i} {i * i % 7} {i % 5} 1 0 0 1\n" for i in range(30))
    (tmp_path / "a.off").write_text(text)
    done = run("a.off", "a.off", "--iterations", "1", "--population", "2")
    assert "'a.off': what follows the coordinates of its vertices is left out" in done.stderr


@pytest.mark.parametrize("share", [0.0, 0.02, 0.5, 0.99])
def test_truncated_stl(refused, small, tmp_path, share):
    for data in ("ascii", "binary"):
        whole = mesh_files.write_stl(tmp_path / "a.stl", RELIEF, data).read_bytes()
        (tmp_path / "a.stl").write_bytes(whole[: int(share * len(whole))])
        message = refused(2, "a.stl", "b.pcd", "-o", "T.txt")
        assert "truncated" in message or "is empty" in message or "line" in message


@pytest.mark.parametrize(
    ("old", "new", "pattern"),
    [
        ("vertex ", "vertex a ", "line 4: expected 'vertex x y z'"),
        ("vertex ", "vertices ", "line 7 ends a face that has not three vertices"),
        ("solid", "liquid", "truncated or not an STL file"),
    ],
)
def test_bad_stl(refused, small, tmp_path, old, new, pattern):
    text = mesh_files.write_stl(tmp_path / "a.stl", RELIEF, "ascii").read_text()
    (tmp_path / "a.stl").write_text(text.replace(old, new, 1))
    message = refused(2, "a.stl", "b.pcd", "-o", "T.txt")
    assert "'a.stl': " in message and pattern in message


@pytest.mark.parametrize("corner", ["0", "65", "-65", "x", "1.5", "99999999999999999999"])
def test_obj_face_of_a_vertex_that_is_not_there(refused, small, tmp_path, corner):
    path = mesh_files.write_obj(tmp_path / "a.obj", RELIEF)
    path.write_text(path.read_text() + f"f 1 2 {corner}\n")
    message = refused(2, "a.obj", "b.pcd", "-o", "T.txt")
    assert "'a.obj': " in message and ("is not a vertex" in message or "has vertex" in message)


@pytest.mark.parametrize("name", ["m.stl", "m.off", "m.npy", "m.xyz"])
def test_formats_that_are_only_read(refused, small, name):
    message = refused(2, *small, "--aligned", name)
    assert "only read, --aligned expects .pcd, .ply or .obj" in message


def test_obj_has_no_room_for_other_fields(refused, run, small, tmp_path):
    import cloud_files
    import numpy as np
    from conftest import surface

    rows = cloud_files.table(surface(40, 1), intensity=np.ones(40, "f4"))
    cloud_files.write_pcd(tmp_path / "a.pcd", rows)
    message = refused(2, *small, "--aligned", "m.obj")
    assert "'m.obj': OBJ cannot hold field 'intensity' of 'a.pcd', write a .ply or .pcd" in message


def test_obj_has_no_room_for_residuals(refused, small):
    message = refused(1, *small, "-o", "T.txt", "--aligned", "m.obj", "--residuals")
    assert "--residuals: OBJ cannot hold field 'residual'" in message
