"""Where the sensors stood: given, in the files, or unknown."""

from __future__ import annotations

import json
import re

import cloud_files
import numpy as np
import pytest
from conftest import QUICK, surface

ABOVE = [0.25, -0.5, 12.0]


@pytest.fixture
def files(tmp_path, pair):
    """The pair with these VIEWPOINT lines."""

    def write(of_source: str = "0 0 0 1 0 0 0", of_target: str = "0 0 0 1 0 0 0") -> list[str]:
        cloud_files.write_pcd(tmp_path / "a.pcd", pair.source, viewpoint=of_source)
        cloud_files.write_pcd(tmp_path / "b.pcd", pair.target, viewpoint=of_target)
        return ["a.pcd", "b.pcd"]

    return write


@pytest.fixture
def found(run, tmp_path):
    """Returns the report of a run."""

    def call(*arguments) -> dict:
        done = run(*arguments, "--report", "r.json")
        assert done.returncode in (0, 3), done.stderr
        return json.loads((tmp_path / "r.json").read_text()) | {"talk": done.stderr}

    return call


def test_default_of_pcd_means_unknown(found, files):
    report = found(*files(), *QUICK)
    assert report["viewpoints"] == {"source": None, "target": None}
    assert "sensor" not in report["talk"]


def test_taken_from_the_files(found, files):
    clouds = files("500123.4375 2.5 -3 1 0 0 0", "0 0 0 0.6 0.8 0 0")
    report = found(*clouds, *QUICK)
    # all digits; and at the origin, which the orientation tells from the default
    assert report["viewpoints"] == {"source": [500123.4375, 2.5, -3], "target": [0, 0, 0]}
    assert report["talk"].count("sensor at") == 2
    report = found(*clouds, *QUICK, "--viewpoint", "none")
    assert report["viewpoints"] == {"source": None, "target": None}


def test_given_goes_before_the_files(found, files):
    clouds = files("1 2 3 1 0 0 0", "4 5 6 1 0 0 0")
    given = ["--viewpoint-source", "0", "-1.5", "2e1"]
    assert found(*clouds, *QUICK, *given)["viewpoints"] == {
        "source": [0, -1.5, 20],
        "target": [4, 5, 6],
    }
    assert found(*given, "--viewpoint", "none", *QUICK, *clouds)["viewpoints"] == {
        "source": [0, -1.5, 20],
        "target": None,
    }


def test_taken_from_a_ply_camera(run, found, files, tmp_path):
    """As this command writes it."""
    run(*files("7 8 9 1 0 0 0"), *QUICK, "-o", "T.txt", "--aligned", "m.ply")
    T = np.loadtxt(tmp_path / "T.txt")
    report = found("m.ply", "b.pcd", *QUICK)
    assert np.allclose(report["viewpoints"]["source"], T[:3, :3] @ [7, 8, 9] + T[:3, 3], atol=1e-4)


CAMERA = {"view_px": 7, "view_py": -8, "view_pz": 9.5} | {
    f"{i}_axis{j}": float(i == j) for i in "xyz" for j in "xyz"
}


def ply_with_camera(path, points, data, camera, faces=False):
    """A cloud, perhaps a face, and then a camera of these floats."""
    cloud_files.write_ply(path, points, data, faces)
    kind = {"ascii": str, "binary": "<f4", "big": ">f4"}[data]
    values = np.array(list(camera.values())).astype(kind)
    header = "element camera 1\n" + "".join(f"property float {name}\n" for name in camera)
    body = " ".join(values).encode() + b"\n" if data == "ascii" else values.tobytes()
    path.write_bytes(cloud_files.with_element(path.read_bytes(), header, body))


@pytest.mark.parametrize("data", ["ascii", "binary", "big"])
def test_taken_from_any_ply_camera(found, files, pair, tmp_path, data):
    files()
    ply_with_camera(tmp_path / "c.ply", pair.source, data, CAMERA)
    assert found("c.ply", "b.pcd", *QUICK)["viewpoints"]["source"] == [7, -8, 9.5]


@pytest.mark.parametrize("data", ["ascii", "binary"])
@pytest.mark.parametrize("change", [{"view_pz": np.nan}, {"x_axisx": 3.0}])
def test_a_camera_that_stands_nowhere(found, files, pair, tmp_path, data, change):
    files()
    ply_with_camera(tmp_path / "c.ply", pair.source, data, CAMERA | change)
    assert found("c.ply", "b.pcd", *QUICK)["viewpoints"]["source"] is None


@pytest.mark.parametrize(("data", "place"), [("ascii", [7, -8, 9.5]), ("binary", None)])
def test_a_camera_behind_faces(found, files, pair, tmp_path, data, place):
    """Binary faces are as long as they say, each: they are not followed."""
    files()
    ply_with_camera(tmp_path / "c.ply", pair.source, data, CAMERA, faces=True)
    assert found("c.ply", "b.pcd", *QUICK)["viewpoints"]["source"] == place


def test_they_act(found, files, pair):
    """Above the relief both sensors see all of it; by the file and given they are the same."""
    above = pair.T[:3, :3] @ ABOVE + pair.T[:3, 3]
    line = "{:.17g} {:.17g} {:.17g} 1 0 0 0"
    thorough = ["--preset", "thorough"]
    given = ["--viewpoint-source", *ABOVE, "--viewpoint-target", *map(repr, above.tolist())]
    by_hand = found(*files(), *thorough, *given)
    by_file = found(*files(line.format(*ABOVE), line.format(*above)), *thorough)
    for name in ("transformation", "quality", "confidence", "viewpoints"):
        assert by_hand[name] == by_file[name]
    assert by_hand["registered"] and pair.error(np.array(by_hand["transformation"]))[0] < 1
    below = [ABOVE[0], ABOVE[1], -ABOVE[2]]  # the side of the surface that the other saw
    wrong = found(*files(), *thorough, "--viewpoint-source", *below, *given[4:])
    assert wrong["quality"]["score"] < by_hand["quality"]["score"] - 0.3


@pytest.mark.parametrize(
    ("arguments", "pattern"),
    [
        (["--viewpoint-source", "1", "2"], "--viewpoint-source"),
        (["--viewpoint-source", "1", "2", "x"], "--viewpoint-source: 'x' is not a finite number"),
        (
            ["--viewpoint-target", "1", "nan", "3"],
            "--viewpoint-target: 'nan' is not a finite number",
        ),
        (
            ["--viewpoint-target", "1", "2", "3", "--viewpoint-target", "1", "2", "3"],
            "--viewpoint-target",
        ),
        (["--viewpoint", "1"], "--viewpoint: '1' is not file or none; .*--viewpoint-source X Y Z"),
    ],
)
def test_refused(refused, small, arguments, pattern):
    assert re.search(pattern, refused(1, *small, *arguments))


def test_a_viewpoint_that_is_not_finite_is_left_out(run, tmp_path):
    for name in ("a.pcd", "b.pcd"):
        cloud_files.write_pcd(tmp_path / name, surface(240, 3), viewpoint="nan 0 0 1 0 0 0")
    done = run("a.pcd", "b.pcd", *QUICK)
    assert done.stderr.count("its VIEWPOINT is left out, it is not finite") == 2
    assert done.returncode in (0, 3) and "sensor" not in done.stderr
