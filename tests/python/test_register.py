"""register() recovers random transformations, in any unit, and repeats itself to the bit."""

import json

import numpy as np
import pytest
import shapes
from shapes import bits

import pyemtr

QUICK = {"iterations": 6, "threads": 2}


@pytest.fixture(scope="module")
def solved(pair):
    return pyemtr.register(pair.source, pair.target, threads=2)


@pytest.mark.parametrize("preset", pyemtr.presets())
@pytest.mark.parametrize(
    "seed, scale, offset", [(1, 1, 0), (2, 1000, 0), (3, 0.01, 0), (4, 50, 4.5e6)]
)
def test_recovers_the_transformation_in_any_unit(preset, seed, scale, offset):
    pair = shapes.make_pair(seed, scale=scale, offset=offset)
    result = pyemtr.register(pair.source, pair.target, preset=preset, threads=2)
    assert result.registered and result.reason == "registered"
    degrees, share = (3, 0.05) if preset == "paper" else (0.3, 0.005)  # one is not refined
    assert shapes.rotation_error(result.transformation, pair.truth) < degrees
    assert shapes.centroid_error(result.transformation, pair.truth, pair.source) < share * scale
    rotation = result.transformation[:3, :3]
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(rotation) > 0
    assert result.transformation[3].tolist() == [0, 0, 0, 1]


def test_unrelated_clouds_are_not_called_registered(pair):
    rng = np.random.default_rng(0)
    result = pyemtr.register(rng.uniform(size=(5000, 3)), pair.target, **QUICK)
    assert not result.registered and result.reason != "registered"


@pytest.mark.parametrize("preset", pyemtr.presets())
def test_same_seed_same_bits_for_any_threads_and_both_ways(pair, preset):
    quick = {"seed": 9, "preset": preset, "iterations": 25}
    results = [
        pyemtr.register(pair.source, pair.target, threads=threads, **quick)
        for threads in (1, 1, 2, 4, 8)
    ]
    assert len({bits(result) for result in results}) == 1
    assert [result.threads for result in results] == [1, 1, 2, 4, 8]
    problem = pyemtr.Problem(pair.source, pair.target, threads=2, **quick)
    alone = pyemtr.register(pair.source, pair.target, threads=2, coarse_points=0, **quick)
    assert bits(problem.solve()) == bits(alone)
    assert bits(problem.solve()) == bits(alone)


def test_each_seed_is_its_own(pair):
    # The swarm runs alone: seeds and refinement would all lead to one pose. The last two seeds
    # differ only beyond what a double can hold.
    seeds = [0, 1, 2**53, 2**53 + 1, 2**64 - 2, 2**64 - 1, np.uint64(5)]
    results = [
        pyemtr.register(pair.source, pair.target, seed=seed, preset="paper", **QUICK)
        for seed in seeds
    ]
    assert [result.seed for result in results] == [int(seed) for seed in seeds]
    assert len({bits(result) for result in results}) == len(seeds)


def test_a_power_of_two_in_the_unit_changes_no_digit(pair):
    one = pyemtr.register(pair.source, pair.target, **QUICK)
    other = pyemtr.register(pair.source * 1024, pair.target * 1024, **QUICK)
    assert one.transformation[:3, :3].tobytes() == other.transformation[:3, :3].tobytes()
    assert (one.transformation[:3, 3] * 1024).tobytes() == other.transformation[:3, 3].tobytes()


def test_points_that_are_not_finite_are_dropped_and_counted(pair):
    clean = pyemtr.register(pair.source, pair.target, **QUICK)
    source, target = np.insert(pair.source, [0, 7, 99], np.nan, axis=0), pair.target.copy()
    target = np.vstack([target, [[0, np.inf, 0], [-np.inf, 0, 0]]])
    result = pyemtr.register(source, target, **QUICK)
    assert (result.dropped_source, result.dropped_target) == (3, 2)
    assert (result.points_source, result.points_target) == (len(pair.source), len(pair.target))
    assert bits(result) == bits(clean)

    masked = np.ma.array(source, mask=np.isnan(source), fill_value=5.0)
    assert bits(pyemtr.register(masked, target, **QUICK)) == bits(clean)


@pytest.mark.parametrize("preset", pyemtr.presets())
def test_a_true_guess_is_found_at_once(pair, preset):
    result = pyemtr.register(
        pair.source, pair.target, guess=pair.truth, iterations=1, preset=preset, threads=2
    )
    assert shapes.rotation_error(result.transformation, pair.truth) < 3


def test_the_fields_say_what_happened(pair, solved):
    assert solved.settings["seed"] == solved.seed == 0
    assert solved.dense_source + solved.dense_target == pytest.approx(2500, rel=0.05)
    assert sum(seconds for stage, seconds in solved.timings.items() if stage != "total") == (
        pytest.approx(solved.timings["total"])
    )
    assert all(
        seconds > 0 for stage, seconds in solved.timings.items() if not stage.endswith("_search")
    )
    assert 0 <= solved.fitness <= 1 and 0 < solved.inlier_ratio_source <= 1
    np.testing.assert_allclose(solved.center_source, pair.source.mean(axis=0), atol=1e-12)


def test_without_a_coarse_search_all_points_are_searched(pair, solved):
    found = pyemtr.register(pair.source, pair.target, coarse_points=0, threads=2)
    assert found.dense_source + found.dense_target == pytest.approx(9000, rel=0.05)
    for result in (found, solved):
        assert shapes.rotation_error(result.transformation, pair.truth) < 0.2


def test_the_paper_preset_keeps_to_the_paper(pair):
    found = pyemtr.register(pair.source, pair.target, preset="paper", threads=2)
    assert found.iterations == 100 == len(found.history["alpha"]) == len(found.history["beta"])
    assert np.all(np.diff(found.history["beta"]) <= 0)
    assert found.dense_source + found.dense_target == pytest.approx(4000, rel=0.05)
    particles, sparse, dense = 50, found.sparse_source, found.dense_source + found.dense_target
    assert found.queries["switch"] == particles * dense
    assert found.queries["evaluation"] == particles * (60 * sparse + 40 * dense)
    assert found.queries["complement"] > 0 and found.queries["complement"] % sparse == 0


def test_the_settings_repeat_the_run(pair):
    first = pyemtr.register(
        pair.source,
        pair.target,
        seed=2**64 - 3,
        guess=pair.truth,
        transfer=False,
        neighbors="brute",
        dense_points=2000,
        source_viewpoint=[4, 3, 2.5],
        target_viewpoint=(1, 2, 3),
        fallback_search="always",
        fallback_points=3000,
        **QUICK,
    )
    assert first.settings["transfer"] is False and first.settings["neighbors"] == "brute"
    second = pyemtr.register(pair.source, pair.target, **first.settings)
    assert bits(first) == bits(second) and first.settings == second.settings


def test_apply_moves_source_into_target(pair, solved):
    np.testing.assert_allclose(
        solved.apply(pair.source.astype(np.float32)),
        shapes.apply(solved.transformation, pair.source),
        atol=1e-6,
    )
    with pytest.raises(ValueError, match=r"points: .*transpose"):
        solved.apply(pair.source.T)


def test_it_can_be_written_down(solved):
    assert json.loads(json.dumps(solved.to_dict(), allow_nan=False)) == solved.to_dict()
    stopped = pyemtr.register(
        shapes.make_pair(1).source, shapes.make_pair(1).target, callback=lambda progress: True
    )
    assert json.loads(json.dumps(stopped.to_dict(), allow_nan=False))["fitness"] is None
    text = repr(solved)
    assert "registered" in text and "source into target" in text and "seed 0" in text
    assert "not registered" in repr(stopped)
    assert f"confidence {solved.confidence:.1%}" in text and "confidence" not in repr(stopped)
