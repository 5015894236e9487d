"""pyemtr-align as users run it, and what it leaves behind."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from children import environment
from many_scans import scene

from pyemtr.multiway import read_g2o, read_open3d
from pyemtr.multiway.command import parser

pytest.importorskip("gtsam", reason="gtsam is not installed")
plyfile = pytest.importorskip("plyfile", reason="plyfile is not installed")


def run(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "pyemtr.multiway", *words],
        capture_output=True,
        text=True,
        cwd=cwd,
        env=environment(),
        timeout=300,
        check=False,
    )


def write_ply(path: Path, points: np.ndarray, color: tuple[int, int, int]) -> None:
    table = np.zeros(len(points), dtype=[(axis, "f4") for axis in "xyz"]
                     + [(name, "u1") for name in ("red", "green", "blue")])  # fmt: skip
    for i, axis in enumerate("xyz"):
        table[axis] = points[:, i]
    for name, value in zip(("red", "green", "blue"), color):
        table[name] = value
    plyfile.PlyData([plyfile.PlyElement.describe(table, "vertex")]).write(str(path))


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory):
    """A run on three scans of one thing and one of another, with colors."""
    folder = tmp_path_factory.mktemp("scans")
    made = scene({2: 3, 3: 1}, seed=5, count=2000, half_angle=85.0)
    (folder / "in").mkdir()
    for i, cloud in enumerate(made.clouds):
        write_ply(folder / "in" / f"s{i}.ply", cloud, (255, 0, 0) if i % 2 else (0, 0, 255))
    process = run("in", "--out", "out", "--preset", "fast", cwd=folder)
    return process, folder, made


def test_it_tells_which_scans_are_placed(done) -> None:
    process, _, made = done
    assert process.returncode == 3, process.stderr  # one is left out
    assert "3 of 4 scans placed in 1 model," in process.stdout
    outsider = made.things.index(3)
    line = next(line for line in process.stdout.splitlines() if line.startswith(f"s{outsider}.ply"))
    assert "left out" in line and not process.stderr


def test_the_files_read_back(done) -> None:
    _, folder, made = done
    out = folder / "out"
    report = json.loads((out / "report.json").read_text(encoding="utf-8"))
    (members,) = report["models"]
    graph, other = read_g2o(out / "graph.g2o"), read_open3d(out / "posegraph.json")
    assert sorted(graph.poses) == members and len(other.poses) == 3
    assert len(graph.edges) == len(other.edges) == sum(e["taken"] for e in report["edges"])
    assert {path.name for path in (out / "poses").iterdir()} == {f"s{i}.ply.txt" for i in members}
    for node, scan in enumerate(members):
        pose = np.loadtxt(out / "poses" / f"s{scan}.ply.txt")
        assert pose.tolist() == report["scans"][scan]["pose"]
        np.testing.assert_allclose(graph.poses[scan], pose, atol=1e-12)
        np.testing.assert_allclose(other.poses[node], pose, atol=1e-12)
        wanted = np.linalg.inv(made.truth[members[0]]) @ made.truth[scan]
        assert np.abs(pose - wanted).max() < 0.03


def test_the_fused_cloud_lies_on_the_thing_and_has_its_colors(done) -> None:
    _, folder, made = done
    vertex = plyfile.PlyData.read(str(folder / "out" / "fused.ply"))["vertex"].data
    assert {"red", "green", "blue"} <= set(vertex.dtype.names)
    assert 3000 < len(vertex) <= 6000
    report = json.loads((folder / "out" / "report.json").read_text(encoding="utf-8"))
    first = report["models"][0][0]
    points = np.column_stack([vertex[axis] for axis in "xyz"])
    from scipy.spatial import cKDTree

    near = cKDTree(points).query(made.clouds[first])[0]
    assert near.max() < 0.02  # the model has the frame of its first scan


def test_a_picture_is_drawn_where_matplotlib_is(done) -> None:
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    _, folder, _ = done
    assert (folder / "out" / "model.png").read_bytes().startswith(b"\x89PNG")


def test_a_folder_that_is_not_empty_needs_force(done) -> None:
    _, folder, _ = done
    again = run("in", "--out", "out", cwd=folder)
    assert again.returncode == 2 and "--force writes into it" in again.stderr


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["nowhere"], "clouds: nowhere: expected a folder"),
        (["a.xyz", "b.xyz"], "a.xyz"),
        (["."], "expected two or more files"),
    ],
)
def test_bad_input_is_told_and_nothing_is_written(words, message, tmp_path: Path) -> None:
    process = run(*words, "--out", "out", cwd=tmp_path)
    assert process.returncode == 2 and message in process.stderr
    assert process.stderr.startswith("pyemtr-align: ") and "Traceback" not in process.stderr
    assert not (tmp_path / "out").exists()


def test_help_names_the_files_and_the_exit_codes() -> None:
    text = parser().format_help()
    for word in ("posegraph.json", "graph.g2o", "fused.ply", "report.json", "exit code: 0"):
        assert word in text
