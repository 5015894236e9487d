"""User-provided normals and features in the clouds' files, and a file of correspondences."""

from __future__ import annotations

import json
import re
import shutil
import subprocess

import cloud_files
import numpy as np
import pytest
from conftest import QUICK, surface


class Known:
    """Two parts of one sampled surface, so that it is known which rows are one point."""

    def __init__(self, pair) -> None:
        points = surface(4000, 1)
        self.in_source, self.in_target = points[:, 0] < 0.6, points[:, 0] > -0.6
        self.T = pair.T
        self.source = points[self.in_source].astype("f4")
        self.target = (points[self.in_target] @ self.T[:3, :3].T + self.T[:3, 3]).astype("f4")
        both = self.in_source & self.in_target
        self.matches = (
            np.column_stack([np.cumsum(self.in_source)[both], np.cumsum(self.in_target)[both]]) - 1
        )
        waves = np.random.default_rng(2).normal(scale=4, size=(3, 33))
        self.codes = np.sin(points @ waves).astype("f4")

    def write(self, folder, name: str = "fpfh", **of_both: np.ndarray) -> tuple[str, str]:
        for file, points, chosen in (
            ("a.pcd", self.source, self.in_source),
            ("b.pcd", self.target, self.in_target),
        ):
            fields = {name: self.codes[chosen]} | {k: v[chosen] for k, v in of_both.items()}
            cloud_files.write_pcd(folder / file, cloud_files.table(points, **fields))
        return "a.pcd", "b.pcd"


@pytest.fixture
def known(pair) -> Known:
    return Known(pair)


def wrongs(known: Known, share: float) -> np.ndarray:
    rng = np.random.default_rng(4)
    pairs = known.matches[::5].copy()
    bad = rng.random(len(pairs)) < share
    pairs[bad, 1] = rng.integers(0, len(known.target), bad.sum())
    return pairs


def test_correspondences_of_which_most_are_wrong(run, known, pair, tmp_path):
    pairs = wrongs(known, 0.8)
    lines = [f"{s}\t{t} \r" for s, t in pairs.tolist()]
    (tmp_path / "m.txt").write_text("# source target\n\n" + "\n".join(lines) + "\n")
    clouds = known.write(tmp_path)
    done = run(*clouds, "--correspondences", "m.txt", "-o", "T.txt", "--report", "r.json")
    assert done.returncode == 0, done.stderr
    degrees, off = pair.error(np.loadtxt(tmp_path / "T.txt"))
    assert degrees < 1 and off < 0.02
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["counts"]["correspondences"] == len(pairs)
    assert report["user_provided"] == {
        "normals": False,
        "features": None,
        "correspondences": len(pairs),
    }
    assert report["files"]["correspondences"] == "m.txt"


@pytest.mark.parametrize("option", ["--use-features", "--use-features=shot"])
def test_features_of_a_field(run, known, pair, tmp_path, option):
    clouds = known.write(tmp_path, option.partition("=")[2] or "fpfh")
    done = run(option, *clouds, "-o", "T.txt", "--report", "r.json")  # takes no file for a field
    assert done.returncode == 0, done.stderr
    degrees, off = pair.error(np.loadtxt(tmp_path / "T.txt"))
    assert degrees < 1 and off < 0.02
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["user_provided"]["features"] == (option.partition("=")[2] or "fpfh")
    assert report["counts"]["correspondences"] == 1000  # the true ones are exact, and many


@pytest.mark.parametrize("kind", ["f4", "f8"])
def test_normals_of_the_fields(run, known, tmp_path, kind):
    """Normals of either type, beside points of floats, and side by side or not."""
    rng = np.random.default_rng(3)
    normals = rng.normal(size=(4000, 3)).astype("f4")
    plain = run(*known.write(tmp_path), *QUICK).stdout
    columns = {f"normal_{axis}": normals[:, i].astype(kind) for i, axis in enumerate("xyz")}
    clouds = known.write(tmp_path, **columns)
    assert run(*clouds, *QUICK).stdout == plain  # only when asked for
    given = run(*clouds, *QUICK, "--use-normals").stdout
    assert given not in ("", plain)
    apart = {"normal_z": columns["normal_z"], "normal_y": columns["normal_y"]}
    apart |= {"curvature": normals[:, 0], "normal_x": columns["normal_x"]}
    assert run(*known.write(tmp_path, **apart), *QUICK, "--use-normals").stdout == given


def test_clouds_written_by_the_tools_of_pcl(run, pair, tmp_path):
    tools = [shutil.which(f"pcl_{name}_estimation") for name in ("normal", "fpfh")]
    if None in tools:
        pytest.skip("no pcl_normal_estimation and pcl_fpfh_estimation: install pcl-tools")
    for name, points in (("a", pair.source), ("b", pair.target)):
        cloud_files.write_pcd(tmp_path / f"{name}.pcd", points.astype("f4"))
        for tool, before, after, radius in (
            (tools[0], name, name + "n", "0.15"),
            (tools[1], name + "n", name + "f", "0.3"),
        ):
            words = [tool, before + ".pcd", after + ".pcd", "-radius", radius, "-k", "0"]
            subprocess.run(words, cwd=tmp_path, check=True, capture_output=True, timeout=300)
    for options in (["--use-normals"], ["--use-features"], ["--use-normals", "--use-features"]):
        done = run("af.pcd", "bf.pcd", *options, "-o", "T.txt")
        assert done.returncode == 0, done.stderr
        degrees, off = pair.error(np.loadtxt(tmp_path / "T.txt"))
        assert degrees < 2 and off < 0.05, options


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("0 0\n1 1\n2\n", "'m.txt': line 3: expected two rows, .* got 1 words"),
        ("0 0\n1 1 1\n", "'m.txt': line 2: expected two rows, .* got 3 words"),
        ("# c\n0 0\n1 -1\n", "'m.txt': line 3: '-1' is not a row"),
        ("0 0\n1 1.0\n", "'m.txt': line 2: '1.0' is not a row"),
        ("0 0\n99999999999 1\n", "'m.txt': line 2: '99999999999' is not a row"),
        ("# nothing\n", "'m.txt': has no correspondences"),
        ("0 0\n1 1\n", "'m.txt': 2 different ones, expected at least 3"),
        ("0 0\n\n1 1\n2 240\n", "'m.txt': line 4: target point 240, expected 0 to 239"),
        ("0 0\n1 1\n# c\n5 2\n", "'m.txt': line 4: source point 5 is not finite"),
    ],
)
def test_bad_correspondences(refused, tmp_path, text, message):
    source = surface(240, 3)
    source[5] = np.nan
    cloud_files.write_pcd(tmp_path / "a.pcd", source)
    cloud_files.write_pcd(tmp_path / "b.pcd", surface(240, 4))
    (tmp_path / "m.txt").write_text(text)
    found = refused(2, "a.pcd", "b.pcd", "--correspondences", "m.txt")
    assert re.search(message, found), found


def test_fields_that_are_not_there(refused, small, tmp_path):
    assert "'a.pcd': has no field 'normal_x' for --use-normals, only x, y, z" in refused(
        2, *small, "--use-normals"
    )
    assert "'a.pcd': has no field 'fpfh' for --use-features, only x, y, z" in refused(
        2, *small, "--use-features"
    )
    codes = np.zeros((240, 5))
    cloud_files.write_pcd(tmp_path / "a.pcd", cloud_files.table(surface(240, 3), mine=codes))
    assert "expected field 'mine' to be of floats" in refused(2, *small, "--use-features=mine")
    for name, numbers in (("a", 5), ("b", 6)):
        rows = cloud_files.table(surface(240, 3), fpfh=np.ones((240, numbers), "f4"))
        cloud_files.write_pcd(tmp_path / f"{name}.pcd", rows)
    message = refused(2, *small, "--use-features")
    assert "'a.pcd', 'b.pcd': features have 5 numbers in the source cloud and 6 in" in message
    rows = cloud_files.table(surface(240, 3), fpfh=np.full((240, 5), np.nan, "f4"))
    cloud_files.write_pcd(tmp_path / "a.pcd", rows)
    assert "'a.pcd': features are given, but no finite point has one" in refused(
        2, *small, "--use-features"
    )


def test_files_that_are_not_there(refused, small):
    assert "'m.txt': No such file" in refused(2, *small, "--correspondences", "m.txt")
    assert "--correspondences" in refused(1, *small, "--correspondences", "")
    assert "is a directory" in refused(2, *small, "--correspondences", ".")
