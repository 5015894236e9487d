"""Runs and their scores, against an engine whose answers are known."""

import math
from dataclasses import replace
from types import SimpleNamespace

import accuracy_fakes
import numpy as np
import pytest
from accuracy_fakes import FakeEngine, Options
from emtr_bench import layout, pairs, protocol, runner, summary
from emtr_bench.paper_tables import ROWS, row_of
from emtr_bench.sensors import sensor_positions


@pytest.fixture
def manifest(tmp_path):
    return layout.read_folder(accuracy_fakes.write_data(tmp_path))


def run_all(manifest, transforms=5, engine=None, jobs=1):
    register = (engine or FakeEngine()).register
    return list(runner.run_all(manifest, transforms, register, Options(), jobs))


def test_an_exact_engine_has_no_error(manifest):
    runs = run_all(manifest)
    assert [(r.pair.name, r.index) for r in runs] == [
        (name, i) for name in ("hare", "hall", "duck") for i in range(5)
    ]
    assert [r.kind for r in runs[:5]] == list(protocol.CLASSES)
    # The files hold float32 at about 100: 1e-5 of a cloud that is a few units large.
    assert all(r.rotation < 1e-3 and r.translation < 1e-5 for r in runs)
    assert all(r.success and r.joint and r.registered and not r.error for r in runs)


def test_run_i_has_seed_base_plus_i_and_the_moved_source(manifest):
    seen = []

    def register(source, target, options, sensors):
        assert sensors is None
        seen.append((source, target, options))
        return FakeEngine().register(source, target, options)

    options = Options(seed=100, threads=3, settings={"population": 9})
    runs = list(runner.run_all(manifest[:1], 3, register, options))
    assert [o.seed for _, _, o in seen] == [r.seed for r in runs] == [100, 101, 102]
    assert {(o.threads, tuple(o.settings.items())) for _, _, o in seen} == {
        (3, (("population", 9),))
    }
    for (source, target, _), run in zip(seen, runs):
        np.testing.assert_allclose(protocol.apply(run.T_true, source), target, atol=1e-4)


@pytest.mark.parametrize(
    ("degrees", "share", "success", "joint"),
    [(4.9, 0.0, True, True), (5.1, 0.0, False, False), (0.0, 0.07, True, False),
     (1.0, 0.05, True, True), (170.0, 0.5, False, False)],
)  # fmt: skip
def test_errors_are_those_put_in(manifest, degrees, share, success, joint):
    scale = runner.moved(manifest[0], 1).scale
    engine = FakeEngine(spoiled={1: (degrees, share * scale)})
    run = run_all(manifest[:1], 2, engine)[1]
    assert run.rotation == pytest.approx(degrees, abs=1e-3)
    assert run.translation == pytest.approx(share, abs=1e-4)
    assert (run.success, run.joint) == (success, joint)


def test_a_crash_is_one_lost_run_and_keeps_its_traceback(manifest):
    runs = run_all(manifest[:1], 3, FakeEngine(crashing=(1,)))
    assert [bool(r.error) for r in runs] == [False, True, False]
    assert "RuntimeError: seed 1 is not to my taste" in runs[1].error
    assert not runs[1].success and not runs[1].joint and math.isnan(runs[1].rotation)
    row = summary.summarise(runs)
    assert row.crashed == 1 and row.figures.success == pytest.approx(200 / 3)


def test_a_pose_of_nan_is_a_failure(manifest):
    def register(source, target, options, sensors):
        outcome = FakeEngine().register(source, target, options)
        outcome.transformation[:] = np.nan
        return outcome

    (run,) = runner.run_all(manifest[:1], 1, register, Options())
    assert math.isnan(run.rotation) and not run.success and not run.joint and not run.error


def test_processes_give_the_same_as_one(manifest):
    engine = FakeEngine(spoiled={1: (30.0, 1.0)})
    one, two = run_all(manifest, 2, engine), run_all(manifest, 2, engine, jobs=2)
    assert [(r.pair, r.index, r.seed, r.rotation, r.translation) for r in one] == [
        (r.pair, r.index, r.seed, r.rotation, r.translation) for r in two
    ]
    for a, b in zip(one, two):
        np.testing.assert_array_equal(a.T_true, b.T_true)
        np.testing.assert_array_equal(a.outcome.transformation, b.outcome.transformation)


def test_a_row_sums_up_its_runs(manifest):
    scale = runner.moved(manifest[0], 0).scale
    spoiled = {0: (1.0, 0.01 * scale), 1: (3.0, 0.03 * scale), 2: (2.0, 0.5 * scale),
               3: (90.0, 0.0)}  # fmt: skip
    engine = FakeEngine(spoiled=spoiled, sure=(0, 2))
    row = summary.summarise(run_all(manifest[:1], 5, engine))
    f = row.figures
    assert (row.runs, row.crashed, row.paper) == (5, 0, ROWS["Bunny"])
    assert (f.success, f.joint) == (pytest.approx(80.0), pytest.approx(60.0))
    # The successes have 1, 3, 2 and 0 degrees; 1, 3, 50 and 0 hundredths.
    assert f.median_rotation == pytest.approx(1.5, abs=1e-3)
    assert f.rotation.mean == pytest.approx(1.5, abs=1e-3)
    assert f.rotation.std == pytest.approx(math.sqrt(5.0 / 3.0), abs=1e-3)
    assert f.translation.mean == pytest.approx(13.5, abs=1e-2)
    # Registered: 0 and 2 of the spoiled and the clean 4; right: 0, 1 and 4.
    assert f.precision == pytest.approx(200 / 3) and f.recall == pytest.approx(200 / 3)
    assert (f.switch, f.complement) == (pytest.approx(7e-6), pytest.approx(9e-6))
    assert f.evaluation == pytest.approx(0.196)


def test_the_auc_is_the_share_of_pairs_in_order():
    def run(confidence, joint):
        return SimpleNamespace(confidence=confidence, joint=joint)

    runs = [run(0.9, True), run(0.5, True), run(0.5, False), run(0.1, False), run(0.7, False)]
    # 0.9 wins all three of the six pairs, 0.5 one and a half.
    assert summary.auc([*runs, run(math.nan, True)]) == pytest.approx(4.5 / 6)
    assert summary.auc(runs[:1] + runs[3:4]) == 1.0
    assert math.isnan(summary.auc(runs[:2])) and math.isnan(summary.auc([]))


def test_only_an_ambiguous_run_is_excused_by_its_alternatives(manifest):
    engine = FakeEngine(
        spoiled={0: (9.0, 0.0), 1: (9.0, 0.0), 2: (9.0, 0.0)}, sure=(1,), aware=(0, 1)
    )
    runs = run_all(manifest[:1], 4, engine)
    assert [run.among for run in runs] == [True, True, False, False]
    assert [run.joint_or_among for run in runs] == [True, False, False, True]


NAMES = {
    "chef_01_05": "uwa",
    "trex_model_scene_rs1": "uwa",
    "chicken_sim": "uwa",
    "kitti_05_00": "lidar",
    "kitchen_1_0_3dmatch": "threedmatch",
    "bunny_045_000": "stanford",
}


def test_where_the_sensors_stood_is_known_of_some(tmp_path):
    found = [
        name
        for name, group in NAMES.items()
        if sensor_positions(pairs.Pair(name, "standard", tmp_path, group=group)) is not None
    ]
    assert found == ["chef_01_05", "kitti_05_00", "kitchen_1_0_3dmatch"]


def test_the_sensors_move_with_the_scans(manifest):
    pair = replace(manifest[0], group="lidar")
    told = []

    def register(source, target, options, sensors):
        told.append((source, sensors))
        return FakeEngine().register(source, target, options)

    list(runner.run_all([pair, manifest[1]], 2, register, Options(viewpoints=True)))
    assert [sensors is None for _, sensors in told] == [False, False, True, True]
    raw = pairs.load(pair).source
    for source, sensors in told[:2]:
        np.testing.assert_allclose(
            np.linalg.norm(source - sensors.source, axis=1), np.linalg.norm(raw, axis=1)
        )
        assert np.linalg.norm(sensors.source) > 1  # it has moved
        np.testing.assert_array_equal(sensors.target, 0)


def test_a_file_says_where_the_sensors_stood(manifest):
    pair = manifest[0]
    (pair.folder / "viewpoints.txt").write_text("1 2 3\n4 5 6\n")
    case = runner.moved(pair, 1)
    raw = pairs.load(pair).source
    np.testing.assert_allclose(
        np.linalg.norm(case.source - case.sensors.source, axis=1),
        np.linalg.norm(raw - [1.0, 2.0, 3.0], axis=1),
    )
    np.testing.assert_array_equal(case.sensors.target, [4.0, 5.0, 6.0])


def test_the_mean_weighs_pairs_alike_and_leaves_out_what_is_not_known(manifest):
    engine = FakeEngine(spoiled={0: (90.0, 0.0), 1: (2.0, 0.0)})
    lost = run_all(manifest[:1], 1, engine)
    found = run_all(manifest[1:2], 2, engine)
    rows = [summary.summarise(lost), summary.summarise(found)]
    mean = summary.mean_figures(rows, lost + found)
    assert rows[0].figures.success == 0.0 and math.isnan(rows[0].figures.rotation.mean)
    assert mean.success == pytest.approx(25.0)
    assert mean.rotation.mean == pytest.approx(2.0, abs=1e-3)
    assert math.isnan(mean.precision)  # nothing was called registered
    assert mean.recall == 0.0


def test_rows_of_the_paper_are_found_by_the_manifests_names():
    assert row_of("") is None
    assert row_of("7a (stand-in)") is ROWS["7a"]
    with pytest.raises(KeyError, match="no row 'Teapot'"):
        row_of("Teapot")
