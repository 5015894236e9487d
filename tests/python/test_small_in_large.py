"""An object in a scene that is many times larger."""

import numpy as np
import pytest
import shapes

import pyemtr

SPACING = 0.01
SIZE = 0.14  # of the object's longest half axis; the scene is 4 wide


def panel(rng, corner, a, b):
    """Points of a parallelogram, SPACING apart on average."""
    corner, a, b = (np.array(v, float) for v in (corner, a, b))
    count = int(np.linalg.norm(np.cross(a, b)) / SPACING**2)
    return corner + rng.random((count, 1)) * a + rng.random((count, 1)) * b


def room(rng):
    """A floor, two walls, a table and things of simple shapes."""
    parts = [
        panel(rng, (0, 0, 0), (4, 0, 0), (0, 3, 0)),
        panel(rng, (0, 0, 0), (4, 0, 0), (0, 0, 2)),
        panel(rng, (0, 0, 0), (0, 3, 0), (0, 0, 2)),
        panel(rng, (1, 1, 0.7), (1.6, 0, 0), (0, 0.9, 0)),
    ]
    for _ in range(10):
        at = rng.uniform((0.3, 0.3, 0.1), (3.7, 2.7, 0.1))
        sizes = rng.uniform(0.05, 0.2, 3)
        parts.append(at + shapes.directions(rng, 900) * sizes)
    return np.vstack(parts)


def scan(rng, count=20000):
    return shapes.lump(rng, count) * SIZE


def placed(rng, at):
    """A scan of the object in the scene, and its pose."""
    pose = shapes.random_transformation(rng, 0)
    pose[:3, 3] = at
    return shapes.apply(pose, scan(rng, 2500)), pose


def scene(seed, *places):
    rng = np.random.default_rng(seed)
    objects = [placed(rng, at) for at in places]
    return np.vstack([room(rng), *[points for points, _ in objects]]), [T for _, T in objects]


ON_TABLE, ON_FLOOR = (1.8, 1.4, 0.85), (3.2, 0.6, 0.15)


@pytest.mark.parametrize("swapped", [False, True])
def test_the_object_is_found_and_the_scene_is_reported_whole(swapped):
    large, (truth,) = scene(1, ON_TABLE)
    small = scan(np.random.default_rng(2))
    if swapped:
        result = pyemtr.register(large, small)
        truth = np.linalg.inv(truth)
    else:
        result = pyemtr.register(small, large)
    assert result.registered and result.used_fallback_search
    assert shapes.rotation_error(result.transformation, truth) < 1.5
    center = (large if swapped else small)[-2500:]
    assert shapes.centroid_error(result.transformation, truth, center) < 0.02 * SIZE
    report = result.to_dict()
    counts = report["points_source"], report["points_target"]
    assert counts == ((len(large), len(small)) if swapped else (len(small), len(large)))
    assert (result.overlap_source if swapped else result.overlap_target) < 0.1
    assert result.timings["total"] >= result.timings["fallback_search"] > 0


def test_threads_and_kept_points_do_not_change_the_bits():
    large, _ = scene(1, ON_TABLE)
    small = scan(np.random.default_rng(2))
    kept = [pyemtr.Cloud(cloud, keep_points=True) for cloud in (small, large)]
    one, two = pyemtr.register(small, large, threads=1), pyemtr.register(*kept, threads=2)
    assert shapes.bits(one) == shapes.bits(two)


def test_preprocessed_clouds_will_do():
    large, (truth,) = scene(1, ON_TABLE)
    small = scan(np.random.default_rng(2))
    result = pyemtr.register(pyemtr.Cloud(small), pyemtr.Cloud(large))
    assert result.registered and shapes.rotation_error(result.transformation, truth) < 1.5


def test_two_of_the_object_are_two_answers():
    """In most scenes; in the others the one that was found is an answer too."""
    told = 0
    for seed in range(4):
        large, truths = scene(seed, ON_TABLE, ON_FLOOR)
        result = pyemtr.register(scan(np.random.default_rng(50 + seed)), large)
        poses = [result.transformation, *[other.transformation for other in result.alternatives]]
        errors = [min(shapes.rotation_error(pose, truth) for pose in poses) for truth in truths]
        assert min(errors) < 3
        if result.reason == "ambiguous":
            told += 1
            assert max(errors) < 3
    assert told >= 3


def test_an_object_that_is_not_there_is_not_found():
    large, _ = scene(5)
    result = pyemtr.register(scan(np.random.default_rng(6)), large)
    assert not result.registered and result.confidence < 0.5


def test_a_callback_sees_one_more_stage_and_can_stop_there():
    large, _ = scene(1, ON_TABLE)
    small = scan(np.random.default_rng(2))
    seen = []

    def stop_in_search(progress):
        seen.append(progress.stage)
        return progress.stage == "fallback_search"

    result = pyemtr.register(small, large, callback=stop_in_search)
    assert result.reason == "interrupted" and not result.registered
    assert seen[0] == "normalization" and set(seen) == {"normalization", "fallback_search"}


def test_a_guess_is_looked_at_first():
    large, truths = scene(3, ON_TABLE, ON_FLOOR)
    small = scan(np.random.default_rng(4))
    for truth in truths:  # each of two that are alike
        guess = truth.copy()
        guess[:3, 3] += 0.3 * SIZE
        result = pyemtr.register(small, large, guess=guess)
        assert result.registered and shapes.rotation_error(result.transformation, truth) < 1.5


def test_parts_without_points_are_no_error():
    large, _ = scene(1, ON_TABLE)
    guess = np.eye(4)
    guess[:3, 3] = 20  # where nothing is
    result = pyemtr.register(scan(np.random.default_rng(2)), large, guess=guess)
    assert result.registered
