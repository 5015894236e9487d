"""The sample pair that the quickstart registers: tools/sample_pair.py."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

TOOLS = Path(__file__).resolve().parents[2] / "tools"
sys.path.insert(0, str(TOOLS))

import sample_pair  # noqa: E402
from virtual_scan import distance, files  # noqa: E402
from virtual_scan.overlap import overlap, resolution  # noqa: E402

spatial = pytest.importorskip("scipy.spatial")


def run(*options: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(TOOLS / "sample_pair.py"), *options]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)


@pytest.fixture(scope="module")
def pair() -> sample_pair.Pair:
    return sample_pair.make_pair()


@pytest.fixture(scope="module")
def folder(pair: sample_pair.Pair, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("sample") / "made" / "here"
    sample_pair.write_pair(pair, folder)
    return folder


@pytest.fixture(scope="module", params=["source", "target"])
def scan(request: pytest.FixtureRequest, pair: sample_pair.Pair):
    return getattr(pair, request.param)


def test_about_forty_thousand_points_each(folder: Path) -> None:
    for name in ("source", "target"):
        points, _ = files.read_pcd(folder / f"{name}.pcd")
        assert 35000 <= len(points) <= 45000
        assert np.isfinite(points).all()


def test_overlap_under_the_true_transformation(folder: Path) -> None:
    source, _ = files.read_pcd(folder / "source.pcd")
    target, _ = files.read_pcd(folder / "target.pcd")
    true = np.loadtxt(folder / "T_true.txt")
    moved = source @ true[:3, :3].T + true[:3, 3]
    trees = spatial.cKDTree(moved), spatial.cKDTree(target)
    steps = [tree.query(tree.data, k=2)[0][:, 1].mean() for tree in trees]
    radius = 2 * max(steps)
    shares = (
        (trees[1].query(moved)[0] <= radius).mean(),
        (trees[0].query(target)[0] <= radius).mean(),
    )
    assert all(0.55 <= share <= 0.65 for share in shares), shares
    # what the generator prints, from a part of the points
    assert resolution(moved) == pytest.approx(steps[0], rel=0.05)
    assert overlap(moved, target, radius) == pytest.approx(shares[0], abs=0.02)


def test_true_transformation_is_rigid_and_the_frames_are_unrelated(folder: Path) -> None:
    true = np.loadtxt(folder / "T_true.txt")
    rotation = true[:3, :3]
    assert np.abs(rotation.T @ rotation - np.eye(3)).max() < 1e-12
    assert np.linalg.det(rotation) == pytest.approx(1.0, abs=1e-12)
    assert true[3].tolist() == [0, 0, 0, 1]
    angle = np.degrees(np.arccos((np.trace(rotation) - 1) / 2))
    assert angle > 45
    assert np.linalg.norm(true[:3, 3]) > 10


def test_viewpoint_is_the_sensor_in_the_frame_of_the_file(
    folder: Path, pair: sample_pair.Pair
) -> None:
    for name in ("source", "target"):
        points, viewpoint = files.read_pcd(folder / f"{name}.pcd")
        seen = getattr(pair, name)
        there = np.linalg.norm(points - viewpoint, axis=1)
        here = np.linalg.norm(seen.points - seen.viewpoint, axis=1)
        assert np.abs(there - here).max() < 1e-3


def test_noise_is_along_the_ray_and_as_strong_as_asked(scan) -> None:
    rays = scan.surface - scan.viewpoint
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    noise = scan.points - scan.surface
    along = np.einsum("ij,ij->i", noise, rays)
    assert along.std() == pytest.approx(0.1, rel=0.03)
    assert abs(along.mean()) < 0.003
    assert np.abs(noise - along[:, None] * rays).max() < 1e-9
    size = np.ptp(scan.surface, axis=0).max()
    assert 0.0005 < along.std() / size < 0.002


def test_points_face_the_scanner_and_nothing_hides_them(scan) -> None:
    assert np.abs(distance.signed_distance(scan.surface)).max() < 0.01
    some = scan.surface[::16]
    rays = scan.viewpoint - some
    lengths = np.linalg.norm(rays, axis=1, keepdims=True)
    rays /= lengths
    assert (np.einsum("ij,ij->i", distance.normals(some), rays) > 0).all()
    # The way to the scanner is free: walked in small steps, not by the tracer under test.
    for step in np.arange(0.5, 140, 0.5):
        inside = distance.signed_distance(some + step * rays) < -0.05
        assert not inside.any(), f"{inside.sum()} points are hidden {step} mm before them"


def test_scans_hide_parts_of_each_other(pair: sample_pair.Pair) -> None:
    way = pair.target.viewpoint - pair.source.surface
    facing = np.einsum("ij,ij->i", distance.normals(pair.source.surface), way) > 0
    assert 0.03 < 1 - facing.mean() < 0.6


def test_same_options_same_bytes(tmp_path: Path) -> None:
    for name, seed in (("a", "8"), ("b", "8"), ("c", "9")):
        done = run("--out", str(tmp_path / name), "--points", "5000", "--seed", seed)
        assert done.returncode == 0, done.stderr
        assert "overlap" in done.stdout
    for name in ("source.pcd", "target.pcd", "T_true.txt"):
        first, again, other = ((tmp_path / f / name).read_bytes() for f in "abc")
        assert first == again
        assert first != other


@pytest.mark.parametrize(
    "option",
    [
        ("--points", "5"),
        ("--noise", "-1"),
        ("--seed", "-3"),
        ("--points", "many"),
        ("--noise", "nan"),
    ],
)
def test_bad_options_are_named(tmp_path: Path, option: tuple[str, str]) -> None:
    done = run("--out", str(tmp_path / "out"), *option)
    assert done.returncode == 2
    assert option[0] in done.stderr and option[1] in done.stderr
    assert not (tmp_path / "out").exists()


def test_a_folder_that_cannot_be_made_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    done = run("--out", str(tmp_path / "file" / "sub"), "--points", "1000")
    assert done.returncode == 1
    assert "--out" in done.stderr and "Traceback" not in done.stderr


def test_files_are_written_whole_or_not_at_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "T_true.txt"
    path.write_text("before")

    def broken(*_: object) -> None:
        raise OSError("no space left")

    monkeypatch.setattr(files.os, "replace", broken)
    with pytest.raises(OSError, match="no space"):
        files.write_transformation(path, np.eye(4))
    assert path.read_text() == "before"
    assert list(tmp_path.iterdir()) == [path]


def test_a_cut_file_is_refused(folder: Path, tmp_path: Path) -> None:
    cut = tmp_path / "cut.pcd"
    cut.write_bytes((folder / "source.pcd").read_bytes()[:-7])
    with pytest.raises(ValueError, match=r"cut.pcd"):
        files.read_pcd(cut)
