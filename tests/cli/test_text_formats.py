"""Text tables of points: separators, comments, a header line, further columns."""

from __future__ import annotations

import cloud_files
import numpy as np
import pytest
from conftest import QUICK, surface

POINTS = surface(240, 3).astype("f4")


def rows(separator: str, points: np.ndarray = POINTS) -> str:
    return "".join(separator.join(map(repr, row)) + "\n" for row in points.tolist())


@pytest.fixture
def reference(run, tmp_path) -> str:
    cloud_files.write_pcd(tmp_path / "reference.pcd", POINTS)
    return run("reference.pcd", "reference.pcd", *QUICK).stdout


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.xyz", rows(" ")),
        ("A.XYZ", rows(" ").replace("\n", "\r\n")),
        ("a.txt", rows("\t")),
        ("a.asc", rows("   ").replace("\n", "  \n\n")),
        ("a.csv", rows(",")),
        ("a.csv", rows(" , ")),
        ("a.csv", rows(";")),
        ("a.csv", rows(",").replace("\n", ",\n")),
        ("a.csv", "x,y,z\n" + rows(",")),
        ("a.csv", "\ufeff\"X\",\"Y\",\"Z\"\n" + rows(",")),
        ("a.csv", "east;north;height\n" + rows(";")),
        ("a.txt", "# made by a test\n" + rows(" ") + "# its end\n"),
        ("a.txt", "// X Y Z\n" + rows(" ")),
        ("a.txt", "% one\n! two\n" + rows(" ").rstrip("\n")),
        ("a.pts", "240\n" + rows(" ")),
        ("a.pts", "100\n" + rows(" ", POINTS[:100]) + "140\n" + rows(" ", POINTS[100:])),
        ("a.pts", rows(" ")),
        ("a.csv", "z,x,y\n" + rows(",", POINTS[:, [2, 0, 1]])),
    ],
)  # fmt: skip
def test_same_cloud(run, tmp_path, reference, name, text):
    (tmp_path / name).write_text(text, encoding="utf-8")
    done = run(name, name, *QUICK)
    assert done.stdout == reference, done.stderr
    assert "warning" not in done.stderr.replace("warning: not registered", "")


def test_named_columns_are_fields(run, tmp_path):
    more = np.column_stack([np.arange(240), POINTS, np.linspace(0, 1, 240)])
    (tmp_path / "a.csv").write_text("id,X,Y,Z,Nx\n" + rows(",", more))
    done = run("a.csv", "a.csv", *QUICK, "-o", "T.txt", "--aligned", "m.pcd")
    assert done.returncode in (0, 3), done.stderr
    found, _ = cloud_files.read_pcd(tmp_path / "m.pcd")
    assert found.dtype.names == ("x", "y", "z", "id", "normal_x")
    assert np.array_equal(found["id"], np.arange(240))
    assert np.array_equal(found["normal_x"], np.linspace(0, 1, 240))


@pytest.mark.parametrize(
    ("columns", "note"),
    [(1, "column 4 of it is left out"), (4, "columns 4 to 7 of it are left out")],
)
def test_columns_without_a_name_are_told(run, tmp_path, reference, columns, note):
    more = np.hstack([POINTS, np.ones((240, columns), "f4")])
    (tmp_path / "a.xyz").write_text(rows(" ", more))
    done = run("a.xyz", "a.xyz", *QUICK)
    assert done.stdout == reference
    assert f"warning: 'a.xyz': {note}, no header line with x, y and z names" in done.stderr


def test_normals_by_their_names(run, tmp_path):
    normals = np.tile([0.0, 0.0, 1.0], (240, 1))
    text = "x y z nx ny nz\n" + rows(" ", np.hstack([POINTS.astype(float), normals]))
    (tmp_path / "a.txt").write_text(text)
    done = run("a.txt", "a.txt", *QUICK, "--use-normals")
    assert done.returncode in (0, 3), done.stderr


def test_empty_cells_are_dropped_points(run, tmp_path, reference):
    (tmp_path / "a.csv").write_text("x,y,z\n1,,2\n" + rows(",") + "1,2,\nnan,0,0\n")
    done = run("a.csv", "a.csv", *QUICK)
    assert done.stdout == reference
    assert done.stderr.count("240 finite points, 3 dropped") == 2


@pytest.mark.parametrize(
    ("text", "pattern"),
    [
        ("", "is empty"),
        ("\n\n", "holds no points, expected lines of x, y, z"),
        ("x y z\n", "holds no points"),
        ("1 2\n", "line 1 has 2 values, expected at least x, y and z"),
        ("1 2 3\n\n4 5\n", "line 3 has 2 values, expected 3"),
        ("1 2 3\n4 5 6 7\n", "line 2 has 4 values, expected 3"),
        ("1 2 3\n4 abc 6\n", "line 2 has 'abc', which is not a number"),
        ("1,5;2,5;3,5\n", "line 1 has '1,5', which is not a number"),
        ("5\n1 2 3\n", "truncated: 4 points fewer than the number before them"),
        ("1\n1 2 3\n4 5 6\n", "line 3 is a point more than the number before them says"),
        ("3\nwater\nO 0 0 0\n", "line 2 has 1 value, expected at least x, y and z"),
        ("1 2 3\n4 \0 6\n", "line 2 has a zero byte"),
    ],
)
def test_refused(refused, small, tmp_path, text, pattern):
    (tmp_path / "a.xyz").write_text(text)
    message = refused(2, "a.xyz", "b.pcd", "-o", "T.txt")
    assert "'a.xyz': " in message and pattern in message


def test_output_may_have_an_extension_of_text(run, small, tmp_path):
    assert run(*small, *QUICK, "-o", "T.txt").returncode in (0, 3)
