"""The benchmark of many scans: its scenes, and how it judges."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from emtr_bench import machine
from emtr_bench.align_all.judge import judge
from emtr_bench.align_all.scenes import Scene, generated, scenes_of
from emtr_bench.layout import read_folder, write_pair
from shapes import random_transformation

import pyemtr


def made_scene(chain: list[int]) -> Scene:
    rng = np.random.default_rng(1)
    clouds = [rng.normal(size=(50, 3)) for _ in chain]
    return Scene("made", clouds, [random_transformation(rng) for _ in chain], chain)


def test_the_version_of_a_package_without_metadata_is_known(monkeypatch) -> None:
    """As of one that runs from a build folder."""

    def version(package: str) -> str:
        raise machine.metadata.PackageNotFoundError(package)

    monkeypatch.setattr(machine.metadata, "version", version)
    assert machine.describe(("pyemtr",))["pyemtr"] == pyemtr.__version__


def test_a_scan_is_judged_against_its_chain() -> None:
    scene = made_scene([0, 0, 0, 3, 3, 5])
    frames = [random_transformation(np.random.default_rng(9))] * 6  # any frame of the model
    poses = [frame @ pose for frame, pose in zip(frames, scene.truth)]
    judged = judge(scene, poses, [0] * 6)
    assert (judged.scans, judged.precise, judged.right, judged.wrong) == (5, 5, 5, 0)
    off = np.eye(4)
    off[:2, :2] = [[np.cos(0.05), -np.sin(0.05)], [np.sin(0.05), np.cos(0.05)]]  # 2.9 degrees
    judged = judge(scene, [poses[0], poses[1], poses[2] @ off, *poses[3:]], [0] * 6)
    assert (judged.precise, judged.right, judged.wrong) == (4, 5, 0)
    judged = judge(scene, [*poses[:2], np.eye(4), *poses[3:]], [0] * 6)
    assert (judged.precise, judged.right, judged.wrong) == (4, 4, 1)


def test_scans_that_are_left_out_are_not_right_and_not_wrong() -> None:
    scene = made_scene([0, 0, 0, 3, 3])
    poses = [*scene.truth[:2], None, scene.truth[3], None]
    judged = judge(scene, poses, [0, 0, None, 0, None])
    assert (judged.scans, judged.right, judged.wrong) == (5, 2, 0)


def test_two_models_do_not_place_scans_against_each_other() -> None:
    scene = made_scene([0, 0])
    judged = judge(scene, list(scene.truth), [0, 1])
    assert (judged.right, judged.wrong) == (0, 1)


def test_pairs_that_share_files_make_a_scene(tmp_path: Path) -> None:
    rng = np.random.default_rng(4)
    views = [rng.normal(size=(40, 3)).astype(np.float32).astype(float) for _ in range(3)]
    T = [random_transformation(rng) for _ in range(2)]
    write_pair(tmp_path / "things" / "cup_1_0", views[1], views[0], T[0])
    write_pair(tmp_path / "things" / "cup_2_1", views[2], views[1], T[1])
    write_pair(tmp_path / "things" / "jug_1_0", views[1], views[0], T[0])
    (scene,) = scenes_of(read_folder(tmp_path), seed=0)  # the jug has two scans alone
    assert scene.name == "things/cup" and len(scene.clouds) == 3 and set(scene.chain) == {0}
    # Each scan was moved, and the truth with it.
    for cloud, truth, view, pose in zip(
        scene.clouds, scene.truth, [views[1], views[0], views[2]],
        [np.eye(4), np.linalg.inv(T[0]), T[1]],
    ):  # fmt: skip
        np.testing.assert_allclose(
            cloud @ truth[:3, :3].T + truth[:3, 3], view @ pose[:3, :3].T + pose[:3, 3], atol=1e-6
        )
        assert np.abs(cloud - view).max() > 0.1


def test_the_generated_scene_is_the_same_for_a_seed() -> None:
    one, other = generated(3, {1: 2, 2: 1}), generated(3, {1: 2, 2: 1})
    assert one.chain == [1, 1, 2]
    assert all(np.array_equal(a, b) for a, b in zip(one.clouds, other.clouds))


def test_a_made_site_is_written_and_judged(tmp_path: Path) -> None:
    from emtr_bench.align_all.large import judged, write_site

    truth = write_site(tmp_path, scans=3, points=2000, seed=1)
    scans = [np.load(tmp_path / f"scan_{k:04d}.npy") for k in range(3)]
    assert all(scan.shape == (2000, 3) and scan.dtype == np.float32 for scan in scans)
    for pose, other, scan in zip(truth, truth[1:], scans):
        ground = scan @ pose[:3, :3].T + pose[:3, 3]
        assert np.abs(ground[:, 2]).max() < 8  # it lies flat again
        assert 1 < np.linalg.norm(pose[:3, 3] - other[:3, 3]) < 6
    found = {"models": [[0, 1, 2]], "poses": [np.linalg.inv(truth[0]) @ pose for pose in truth]}
    assert judged(found, truth) == {
        "models": 1, "placed": 3, "precise": 3, "right": 3, "wrong": 0, "largest": 3,
    }  # fmt: skip
    found["poses"][2] = found["poses"][2].copy()
    found["poses"][2][0, 3] += 5
    assert judged(found, truth)["wrong"] == 1


def test_the_factor_of_edges_is_one_for_errors_that_are_as_they_say() -> None:
    from emtr_bench.align_all.edges import motion_between, row

    rng = np.random.default_rng(0)
    raw = (rng.normal(size=(4000, 6)) ** 2).sum(axis=1)
    errors = [{"raw": one, "normalized": one / 100, "degrees": 0.1, "radii": 0.01} for one in raw]
    found = row("x", "all", errors)
    assert abs(found["factor"] - 1) < 0.03 and abs(found["factor_90"] - 1) < 0.03
    assert abs(found["with_10"] - 0.1) < 0.003
    true = random_transformation(rng)
    center = np.array([1.0, 2.0, 3.0])
    motion = np.array([0.01, -0.02, 0.03, 0.1, 0.2, -0.3])
    from pyemtr.multiway.rigid import exponential

    step = exponential(motion)
    step[:3, 3] += center - step[:3, :3] @ center
    np.testing.assert_allclose(motion_between(true, step @ true, center), motion, atol=1e-12)


def test_the_ways_of_the_experiment_begin_and_end_with_poses() -> None:
    from emtr_bench.align_all import swarm

    scene = generated(0, {1: 4})
    model = swarm.Model(scene, [0, 1, 2, 3])
    assert model.errors(model.truth).max() < 1e-5 and model.pairs
    moved = swarm.posed(model, model.truth, np.full(18, 0.02))
    assert 1 < model.errors(moved)[:, 0].min() < 3
    first, second = (model.distance(poses, model.pairs[0]) for poses in (model.truth, moved))
    assert first < second


def test_the_ground_of_the_site_is_the_sum_of_its_bumps() -> None:
    from emtr_bench.align_all.large import ground

    rng = np.random.default_rng(0)
    bumps, heights, widths = (
        rng.uniform(-13, 13, (180, 2)), rng.uniform(0.2, 1.4, 180), rng.uniform(0.4, 1.3, 180),
    )  # fmt: skip
    at = rng.uniform(-7, 7, (1000, 2))
    away = ((at[:, None] - bumps) ** 2).sum(axis=2)
    expected = (heights * np.exp(-away / widths**2)).sum(axis=1)
    for place in ([0.3, -0.2], [-1.0, 2.01]):  # the same ground from each place
        found = ground(at, np.array(place), bumps, heights, widths)
        assert np.abs(found - expected).max() < 0.02
