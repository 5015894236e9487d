"""The pages of --batch: of clouds in each format that the command reads."""

from __future__ import annotations

import gzip
import json
import re
from pathlib import Path

import cloud_files
import mesh_files
import numpy as np
import pytest
from conftest import surface
from test_modules import has_module, write_las

RELIEF = mesh_files.relief(20)
POINTS = surface(300, 5).astype("f4").astype(float)
SMALL = ["--preset", "fast", "--iterations", "2", "--population", "4", "--mesh-points", "700"]


def text(head: str, between: str = " "):
    return lambda path: path.write_text(
        head + "".join(between.join(map(repr, row)) + "\n" for row in POINTS.tolist())
    )


def packed(write, name: str):
    def both(path: Path) -> None:
        write(path.with_name(name))
        path.write_bytes(gzip.compress(path.with_name(name).read_bytes()))

    return both


def ply(path: Path) -> None:
    pytest.importorskip("plyfile", reason="pip install 'pyemtr[files]'")
    mesh_files.write_ply(path, RELIEF)


def pcd(path: Path) -> None:
    pytest.importorskip("pypcd4", reason="pip install 'pyemtr[files]'")
    cloud_files.write_pcd(path, POINTS)


def las(path: Path) -> None:
    pytest.importorskip("laspy", reason="pip install 'pyemtr[files]'")
    write_las(path)


# Writes a file; and how many points of it are registered.
FILES = {
    "a.npy": (lambda path: np.save(path, POINTS), 300),
    "a.pcd": (pcd, 300),
    "a.ply": (ply, 700),
    "a.obj": (lambda path: mesh_files.write_obj(path, RELIEF), 700),
    "last.obj": (lambda path: mesh_files.write_obj(path, RELIEF, from_last=True), 700),
    "cloud.obj": (lambda path: cloud_files.write_obj(path, POINTS), 300),
    "a.off": (lambda path: mesh_files.write_off(path, RELIEF), 700),
    "a.stl": (lambda path: mesh_files.write_stl(path, RELIEF), 700),
    "text.stl": (lambda path: mesh_files.write_stl(path, RELIEF, "ascii"), 700),
    "a.xyz": (text(""), 300),
    "a.txt": (text("% one\n! two\n"), 300),
    "a.asc": (text("// X Y Z\n"), 300),
    "a.csv": (text("x,y,z\n", ","), 300),
    "a.pts": (text("300\n"), 300),
    "a.las": (las, 240),
    "b.stl.gz": (packed(lambda path: mesh_files.write_stl(path, RELIEF), "b.stl"), 700),
    "b.pcd.gz": (packed(pcd, "b.pcd"), 300),
    "b.PTS.GZ": (packed(text("300\n"), "b.PTS"), 300),
}


def report_of(page: Path) -> dict:
    (payload,) = re.findall(r'id="payload">(.*?)</script>', page.read_text(), re.DOTALL)
    return json.loads(payload)["report"]


@pytest.mark.parametrize("name", FILES)
def test_each_format_has_its_page(run, tmp_path, python_with_pyemtr, name):
    write, count = FILES[name]
    if name.endswith("las") and not has_module("las"):
        pytest.skip("built without EMTR_WITH_LASZIP")
    write(tmp_path / name)
    np.save(tmp_path / "target.npy", surface(300, 1))
    (tmp_path / "pairs.csv").write_text(f"source,target\n{name},target.npy\n")
    batch = ["--batch", "pairs.csv", "--out", "out", "--html", "html", *SMALL]
    done = run(*batch, env=python_with_pyemtr)
    assert done.returncode in (0, 3), done.stderr
    report = report_of(tmp_path / "html" / "pairs" / "000000.html")
    record = json.loads((tmp_path / "out" / "results.jsonl").read_text())
    assert report["counts"]["read_source"] == record["counts"]["points_source"] == count
    assert report["transformation"] == record["transformation"]
    assert report["files"]["source"] == name


@pytest.mark.parametrize("name", [name for name in FILES if name != "a.las"])
def test_python_reads_what_the_command_reads(run, tmp_path, name):
    """So their records are the same to the last bit."""
    pyemtr = pytest.importorskip("pyemtr", reason="pyemtr is not installed")
    FILES[name][0](tmp_path / name)
    np.save(tmp_path / "target.npy", surface(300, 1))
    (tmp_path / "pairs.csv").write_text(f"source,target\n{name},target.npy\n")
    done = run("--batch", "pairs.csv", "--out", "out", *SMALL)
    assert done.returncode in (0, 3), done.stderr
    settings = {"preset": "fast", "iterations": 2, "population": 4, "mesh_points": 700}
    (record,) = pyemtr.register_many(tmp_path / "pairs.csv", **settings)
    by_command = json.loads((tmp_path / "out" / "results.jsonl").read_text())
    assert {**record.values, "seconds": 0} == {**by_command, "seconds": 0}


def test_the_vertices_of_a_mesh_have_a_page(run, tmp_path, python_with_pyemtr):
    mesh_files.write_off(tmp_path / "a.off", RELIEF)
    (tmp_path / "pairs.csv").write_text("source,target,mesh_points\na.off,a.off,0\n")
    batch = ["--batch", "pairs.csv", "--out", "out", "--html", "html", *SMALL]
    done = run(*batch, env=python_with_pyemtr)
    assert done.returncode in (0, 3), done.stderr
    page = tmp_path / "html" / "pairs" / "000000.html"
    assert report_of(page)["counts"]["read_source"] == len(RELIEF[0])


def test_a_file_that_is_gone_is_told_and_the_others_have_pages(run, tmp_path, python_with_pyemtr):
    for name in ("a", "b", "c"):
        np.save(tmp_path / f"{name}.npy", surface(300, ord(name)))
    (tmp_path / "pairs.csv").write_text("source,target\na.npy,b.npy\nb.npy,c.npy\n")
    batch = ["--batch", "pairs.csv", "--out", "out", *SMALL]
    assert run(*batch).returncode in (0, 3)
    (tmp_path / "a.npy").unlink()
    done = run(*batch, "--html", "html", env=python_with_pyemtr)
    assert done.returncode == 2
    assert "no page: pair 0: " in done.stderr and "a.npy" in done.stderr
    assert [path.name for path in (tmp_path / "html" / "pairs").glob("*.html")] == ["000001.html"]
    assert (tmp_path / "html" / "index.html").is_file()
