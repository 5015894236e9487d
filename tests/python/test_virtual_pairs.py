"""The generated pairs: that their poses are true, how much they overlap, and how they are kept."""

import subprocess
import sys

import numpy as np
import pytest
from accuracy_fakes import REPOSITORY
from emtr_bench import layout, pairs, protocol
from emtr_bench.virtual_pairs import folder as on_disk
from emtr_bench.virtual_pairs import frames

spatial = pytest.importorskip("scipy.spatial")


@pytest.fixture(scope="module")
def made():
    return layout.read_folder(on_disk.virtual_pairs())


def shares(pair):
    """The share of each cloud that has the other within twice the mean resolution."""
    clouds = pairs.load(pair)
    moved = protocol.apply(clouds.T_gt, clouds.source)
    trees = [spatial.cKDTree(points) for points in (moved, clouds.target)]
    radius = 2 * max(tree.query(tree.data, k=2)[0][:, 1].mean() for tree in trees)
    return [float((trees[1 - i].query(trees[i].data)[0] <= radius).mean()) for i in range(2)]


def test_ten_pairs_of_objects_rooms_and_streets(made):
    assert len(made) == 10
    assert {pair.group for pair in made} == {"objects", "rooms", "streets"}
    assert [pair.name for pair in made if not pair.related] == ["two_rooms"]
    assert sum(pair.size for pair in made) < 5e6
    for pair in made:
        for name in pairs.FILES[:2]:
            points = pairs.read_ply(pair.folder / name)
            assert 2000 < len(points) < 20000 and np.isfinite(points).all()


def test_each_pose_is_true_and_each_tier_says_how_much_is_shared(made):
    for pair in made:
        if pair.related:
            least, tier = min(shares(pair)), pair.tier
            assert tier == ("standard" if least >= 0.45 else "low-overlap"), (pair.name, least)
            assert least > 0.2, (pair.name, least)


def test_scans_start_apart(made):
    for pair in made:
        if pair.related:
            T = pairs.load(pair).T_gt
            assert np.trace(T[:3, :3]) < 1 + 2 * np.cos(np.radians(5)) and T[:3, 3].any()


def test_sensors_see_what_they_saw(made):
    """Every ray from the sensor to a point is the nearest in its direction, but for noise."""
    for pair in made:
        found = pairs.viewpoints(pair)
        if pair.name == "ball_bumps":
            assert found is None
            continue
        for eye, name in zip(found, pairs.FILES):
            away = pairs.read_ply(pair.folder / name) - eye
            ranges = np.linalg.norm(away, axis=1)
            rays = away / ranges[:, None]
            pairs_of_rays = spatial.cKDTree(rays).query_pairs(1e-4)
            close = [abs(ranges[i] - ranges[j]) for i, j in pairs_of_rays]
            assert len(close) < 0.01 * len(rays), pair.name  # a ray gives one point


def test_two_processes_make_the_same_bytes(tmp_path):
    code = (
        "import sys; from pathlib import Path; sys.path.insert(0, 'tools/bench')\n"
        "from emtr_bench.virtual_pairs import folder\n"
        "folder.FOLDER = Path(sys.argv[1]); print(folder.virtual_pairs())"
    )
    folders = []
    for name in ("a", "b"):
        done = subprocess.run(
            [sys.executable, "-c", code, str(tmp_path / name)], cwd=REPOSITORY,
            capture_output=True, text=True, timeout=300, check=True,
        )  # fmt: skip
        assert "making the generated pairs in" in done.stdout
        folders.append(tmp_path / name / done.stdout.split()[-1])
    files = [sorted(f.relative_to(own) for f in own.rglob("*.*")) for own in folders]
    assert files[0] == files[1] and len(files[0]) == 1 + 3 * 10 + 9
    for file in files[0]:
        assert (folders[0] / file).read_bytes() == (folders[1] / file).read_bytes()
    assert [entry.name for entry in (tmp_path / "a").iterdir()] == [folders[0].name]


def test_they_are_made_once_and_anew_when_their_sources_change(tmp_path, monkeypatch, capsys):
    calls = []

    def write(folder):
        calls.append(folder)
        folder.mkdir()
        (folder / layout.MANIFEST).write_text("made")

    monkeypatch.setattr(on_disk, "FOLDER", tmp_path / "deep" / "folder")
    monkeypatch.setattr(on_disk, "_write", write)
    first = on_disk.virtual_pairs()
    assert on_disk.virtual_pairs() == first and len(calls) == 1
    monkeypatch.setattr(on_disk, "_fingerprint", lambda: "another")
    assert on_disk.virtual_pairs() != first and len(calls) == 2


def test_the_slower_of_two_processes_takes_the_others(tmp_path, monkeypatch):
    monkeypatch.setattr(on_disk, "FOLDER", tmp_path)
    own = tmp_path / on_disk._fingerprint()

    def write(folder):
        for place in (folder, own):
            place.mkdir()
            (place / layout.MANIFEST).write_text(place.name)

    monkeypatch.setattr(on_disk, "_write", write)
    assert on_disk.virtual_pairs() == own
    assert (own / layout.MANIFEST).read_text() == own.name
    assert [entry.name for entry in tmp_path.iterdir()] == [own.name]


def test_a_folder_that_cannot_be_made_is_told(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setattr(on_disk, "FOLDER", tmp_path / "file")
    with pytest.raises(pairs.DataError, match=r"no generated pairs: .*name others by --data"):
        on_disk.virtual_pairs()


def test_between_two_frames():
    rng = np.random.default_rng(8)
    points = rng.normal(size=(20, 3))
    a, b = frames.any_pose(rng, 3.0), frames.upright_pose(rng, 3.0)
    moved = protocol.apply(frames.between(a, b), protocol.apply(a, points))
    np.testing.assert_allclose(moved, protocol.apply(b, points), atol=1e-12)
    np.testing.assert_allclose(b[2, :3], [0, 0, 1], atol=1e-15)
