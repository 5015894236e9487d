"""Files in place of clouds: each format, and what is wrong with a bad one."""

from __future__ import annotations

import gzip
import sys
import types
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pyemtr
from pyemtr.points import as_points

POINTS = np.round(np.random.default_rng(8).normal(size=(30, 3)), 6)


def lines(rows: Any, between: str = " ") -> str:
    return "".join(between.join(f"{value:.17g}" for value in row) + "\n" for row in rows)


MORE = np.hstack([POINTS, 100 + POINTS])  # normals, colors
MOVED = MORE[:, [5, 2, 0, 3, 1, 4]]
TEXTS = {
    "a.xyz": lines(POINTS),
    "more.xyz": lines(MORE, "\t"),
    "count.pts": "30\n" + lines(MORE[:, :4]),
    "comments.txt": "# x y z\n\n// made by hand\n" + lines(POINTS),
    "between.txt": lines(MORE[:15]) + "# the other half\n" + lines(MORE[15:]),
    "upper.XYZ": lines(POINTS),
    "a.csv": lines(POINTS, ","),
    "spaces.csv": lines(POINTS, ", "),
    "semicolons.csv": lines(MORE, "; "),
    "names.csv": "i,z,x,label,Y,n\n" + lines(MOVED, ","),
    "quoted.csv": '"i";"Z";"X";"label";"Y";"n"\n' + lines(MOVED, ";"),
    "names.asc": "i Z X label y n\n" + lines(MOVED),
    "bom.csv": "\ufeffx,y,z\n" + lines(POINTS, ","),
    "percent.txt": "% one\n! two\n" + lines(POINTS),
    "comment.txt": "# made by hand\n# i Z X label y n\n// the end of it\n" + lines(MOVED),
    "comment.csv": "// i, z, x, label, Y, n\n" + lines(MOVED, ","),
    "short comment.txt": "# z y x\n" + lines(MORE),
    "parts.pts": "12\n" + lines(POINTS[:12]) + "18\n" + lines(POINTS[12:]),
    "ends.csv": lines(POINTS, ",").replace("\n", ",\n"),
}


@pytest.mark.parametrize("name", TEXTS)
@pytest.mark.parametrize("kind", [str, Path])
def test_text(tmp_path: Path, name: str, kind: type) -> None:
    (tmp_path / name).write_text(TEXTS[name], encoding="utf-8")
    assert np.array_equal(as_points(kind(tmp_path / name), "source"), POINTS)


@settings(max_examples=60, deadline=None)
@given(
    rows=st.lists(st.tuples(*[st.floats(-1e6, 1e6)] * 5), min_size=1, max_size=9),
    between=st.sampled_from([" ", "\t", ",", ";", ", ", "   "]),
    wide=st.integers(3, 5),
)
def test_any_number_is_read_as_it_was_written(tmp_path_factory, rows, between, wide):
    file = tmp_path_factory.mktemp("text") / "a.txt"
    array = np.array(rows)[:, :wide]
    file.write_text(lines(array, between))
    assert np.array_equal(as_points(file, "source"), array[:, :3])


def test_nan_in_text_is_a_point_to_drop(tmp_path: Path) -> None:
    (tmp_path / "a.xyz").write_text("nan nan nan\n" + lines(POINTS))
    assert pyemtr.Cloud(tmp_path / "a.xyz").dropped == 1


@pytest.mark.parametrize("text", ["1,,3\n", ",2,3,\n", "1, ,3\n", "1;2;\n"])
def test_an_empty_cell_is_a_point_to_drop(tmp_path: Path, text: str) -> None:
    between = ";" if ";" in text else ","
    (tmp_path / "a.csv").write_text(lines(POINTS, between) + text)
    found = as_points(tmp_path / "a.csv", "source")
    assert np.array_equal(found[:-1], POINTS) and np.isnan(found[-1]).sum() == 1


def test_numpy_files(tmp_path: Path) -> None:
    np.save(tmp_path / "a.npy", POINTS.astype(np.float32))
    np.savez(tmp_path / "one.npz", whatever=np.hstack([POINTS, np.ones((30, 1))]))
    np.savez_compressed(tmp_path / "named.npz", normals=MORE[:, 3:], points=POINTS)
    table = np.zeros(30, [("z", "f8"), ("y", "f8"), ("x", "f8")])
    table["x"], table["y"], table["z"] = POINTS.T
    np.save(tmp_path / "table.npy", table)
    for name in ("a.npy", "one.npz", "named.npz", "table.npy"):
        points = as_points(tmp_path / name, "source")
        assert np.array_equal(points, POINTS.astype(points.dtype)), name
    assert as_points(tmp_path / "a.npy", "source").dtype == np.float32


def ply(path: Path, faces: list[list[int]] | None, field: str = "vertex_indices") -> None:
    plyfile = pytest.importorskip("plyfile", reason="plyfile is not installed")
    vertices = np.zeros(30, [("nx", "f4"), ("x", "f8"), ("y", "f8"), ("z", "f8")])
    vertices["x"], vertices["y"], vertices["z"] = POINTS.T
    elements = [plyfile.PlyElement.describe(vertices, "vertex")]
    if faces is not None:
        rows = np.empty(len(faces), [(field, "O")])
        rows[field] = [np.array(face, "i4") for face in faces]
        elements.append(plyfile.PlyElement.describe(rows, "face"))
    plyfile.PlyData(elements).write(path)


def test_ply_points(tmp_path: Path) -> None:
    ply(tmp_path / "a.ply", None)
    assert np.array_equal(as_points(tmp_path / "a.ply", "source"), POINTS)
    ply(tmp_path / "b.ply", [])
    assert np.array_equal(as_points(tmp_path / "b.ply", "source"), POINTS)


@pytest.mark.parametrize("field", ["vertex_indices", "vertex_index"])
@pytest.mark.parametrize(
    "faces",
    [
        [[i, i + 1, i + 2] for i in range(0, 28, 3)],
        [[i, i + 1, i + 2, i + 3] for i in range(0, 24, 3)] + [[27, 28, 29]],
    ],
)
def test_a_ply_with_faces_is_a_mesh(tmp_path: Path, field: str, faces: list) -> None:
    ply(tmp_path / "a.ply", faces, field)
    split = [[f[0], f[i], f[i + 1]] for f in faces for i in range(1, len(f) - 1)]
    mesh = types.SimpleNamespace(vertices=POINTS, faces=np.array(split))
    wanted = as_points(mesh, "source", 200)
    assert np.array_equal(as_points(tmp_path / "a.ply", "source", 200), wanted)


def test_a_file_whose_faces_are_no_surface_is_a_cloud(tmp_path: Path) -> None:
    """As for the command: most vertices in no face, or faces without area."""
    for faces in ([[0, 1, 2], [3, 4, 5]], [[i, i, i] for i in range(30)]):
        ply(tmp_path / "a.ply", faces)
        assert np.array_equal(as_points(tmp_path / "a.ply", "source"), POINTS)


def test_pcd(tmp_path: Path) -> None:
    pytest.importorskip("pypcd4", reason="pypcd4 is not installed")
    (tmp_path / "a.pcd").write_text(
        "VERSION 0.7\nFIELDS intensity x y z\nSIZE 4 8 8 8\nTYPE F F F F\nCOUNT 1 1 1 1\n"
        "WIDTH 30\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 30\nDATA ascii\n"
        + lines(np.hstack([np.ones((30, 1)), POINTS]))
    )
    np.testing.assert_allclose(as_points(tmp_path / "a.pcd", "source"), POINTS, rtol=1e-12)


def test_las(tmp_path: Path) -> None:
    laspy = pytest.importorskip("laspy", reason="laspy is not installed")
    header = laspy.LasHeader(point_format=0, version="1.2")
    header.scales = [1e-6] * 3
    las = laspy.LasData(header)
    las.x, las.y, las.z = POINTS.T
    las.write(tmp_path / "a.las")
    np.testing.assert_allclose(as_points(tmp_path / "a.las", "source"), POINTS, atol=1e-6)
    np.testing.assert_allclose(as_points(las, "source"), POINTS, atol=1e-6)


BAD = {
    "words.xyz": ("1 2 3\n4 five 6\n", "five"),
    "short.xyz": ("1 2\n3 4\n", "line 1: expected at least three numbers, got '1 2'"),
    "shorter.csv": ("1,2,3\n4,5\n", "column"),
    "empty.txt": ("", "at least one point"),
    "comments.txt": ("# nothing else\n", "at least one point"),
    "commas.txt": (",,,\n", "names of columns"),
    "names.csv": ("a,b,c\n1,2,3\n", "x, y and z, or numbers, got 'a,b,c'"),
    "twice.csv": ("x,X,y,z\n1,2,3,4\n", "one column each of x, y and z"),
    "count.pts": ("3\n1 2 3\n4 5 6\n", "says that it has 3 points, and has 2"),
    "binary.xyz": (b"\xff\xfe\x00\x01", "decode"),
    "a.npy": (b"not numpy", "allow_pickle|magic|pickle"),
    "a.npz": (b"not an archive", ""),
    "cut.npy": (b"\x93NUMPY\x01\x00v\x00{'descr'", ""),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_content_names_argument_and_file(tmp_path: Path, name: str) -> None:
    content, text = BAD[name]
    file = tmp_path / name
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(ValueError, match=rf"^target: .*{name}: .*{text}"):
        pyemtr.register(POINTS, file)


def test_an_archive_of_several_arrays_names_them(tmp_path: Path) -> None:
    np.savez(tmp_path / "a.npz", left=POINTS, right=POINTS)
    with pytest.raises(ValueError, match=r"a\.npz: .*points, xyz or vertices.*left, right"):
        as_points(tmp_path / "a.npz", "source")


def test_objects_in_a_file_are_never_loaded(tmp_path: Path) -> None:
    np.save(tmp_path / "a.npy", np.array([{"x": 1}], dtype=object), allow_pickle=True)
    with pytest.raises(ValueError, match=r"a\.npy: .*allow_pickle"):
        as_points(tmp_path / "a.npy", "source")


def test_a_shape_in_a_file_is_refused_by_the_file_s_name(tmp_path: Path) -> None:
    np.save(tmp_path / "a.npy", MORE)
    with pytest.raises(ValueError, match=r"^source: .*a\.npy: .*\(30, 6\)"):
        as_points(tmp_path / "a.npy", "source")


HINTS = {"glb": "trimesh", "bin": "fromfile", "doc": r"\.ply", "ply.xz": r"\.gz behind them"}


@pytest.mark.parametrize("ending", HINTS)
def test_another_format_has_a_hint(tmp_path: Path, ending: str) -> None:
    (tmp_path / f"a.{ending}").write_bytes(b"content")
    with pytest.raises(ValueError, match=rf"^source: .*a\.{ending}: no format .*{HINTS[ending]}"):
        as_points(tmp_path / f"a.{ending}", "source")


def test_a_file_that_is_not_there_is_the_system_s_error(tmp_path: Path) -> None:
    for name in ("a.npy", "a.ply", "a.xyz"):
        with pytest.raises(FileNotFoundError, match=name):
            pyemtr.register(str(tmp_path / name), POINTS)
    (tmp_path / "folder.xyz").mkdir()
    with pytest.raises(IsADirectoryError):
        as_points(tmp_path / "folder.xyz", "source")


PACKAGES = {
    "a.ply": "plyfile", "a.pcd": "pypcd4", "a.las": "laspy", "a.laz": "laspy", "a.e57": "pye57",
    "a.ply.gz": "plyfile",
}  # fmt: skip


@pytest.mark.parametrize("name", PACKAGES)
def test_a_missing_package_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.setitem(sys.modules, PACKAGES[name], None)
    content = gzip.compress(b"content") if name.endswith(".gz") else b"content"
    (tmp_path / name).write_bytes(content)
    extra = "e57" if name == "a.e57" else "files"
    wanted = rf"^source: .*{name}: .*{PACKAGES[name]}.*pyemtr\[{extra}\]"
    with pytest.raises(ImportError, match=wanted):
        as_points(tmp_path / name, "source")


def test_files_are_registered(tmp_path: Path, pair: Any) -> None:
    np.save(tmp_path / "source.npy", pair.source)
    np.savetxt(tmp_path / "target.xyz", pair.target, fmt="%.17g")
    quick = {"iterations": 3, "threads": 2}
    wanted = pyemtr.register(pair.source, pair.target, **quick).transformation
    found = pyemtr.register(tmp_path / "source.npy", str(tmp_path / "target.xyz"), **quick)
    assert found.transformation.tobytes() == wanted.tobytes()
