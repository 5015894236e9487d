"""Priors of the pose: they hold, they are used, and contradictory ones are refused."""

import numpy as np
import pytest
import shapes
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from shapes import bits

import pyemtr

SMALL = {
    "threads": 1,
    "iterations": 3,
    "population": 8,
    "fallback_search": "off",
    "dense_points": 1500,
}


@pytest.fixture(scope="module")
def pair():
    return shapes.make_pair(11)


def vector_of(matrix):
    """The rotation's axis (unit) and angle in degrees."""
    vector = Rotation.from_matrix(matrix[:3, :3]).as_rotvec()
    angle = np.linalg.norm(vector)
    return vector / angle, np.degrees(angle)


def angle(R):
    return np.degrees(2 * np.arcsin(min(1, np.linalg.norm(R - np.eye(3)) / np.sqrt(8))))


def kept(T, cloud, wanted):
    """The name of a prior that a pose does not satisfy, by formulas of its own; None for none."""
    tiny, R = 1e-6, T[:3, :3]
    if "guess" in wanted:
        G = np.asarray(wanted["guess"])
        if angle(R @ G[:3, :3].T) > wanted["guess_rotation"] + tiny:
            return "guess_rotation"
        away = (T - G)[:3] @ np.append(cloud.mean(axis=0), 1)
        if np.linalg.norm(away) > wanted["guess_translation"] + tiny:
            return "guess_translation"
    if "axis" in wanted:
        a = np.asarray(wanted["axis"]) / np.linalg.norm(wanted["axis"])
        if np.degrees(np.arctan2(np.linalg.norm(np.cross(a, R @ a)), a @ R @ a)) > (
            wanted["axis_tilt"] + tiny
        ):
            return "axis"
        *v, w = Rotation.from_matrix(R).as_quat()
        rotated = np.degrees(2 * np.arctan2(v @ a, w))
        low, high = wanted["axis_angle_minimum"], wanted["axis_angle_maximum"]
        off = (rotated - (low + high) / 2 + 180) % 360 - 180
        if abs(off) > (high - low) / 2 + tiny:
            return "axis_angle"
    if "translation_bounds" in wanted:
        low, high = wanted["translation_bounds"]
        if (T[:3, 3] < low - tiny).any() or (T[:3, 3] > high + tiny).any():
            return "translation_bounds"
    return "maximum_rotation" if angle(R) > wanted.get("maximum_rotation", 180) + tiny else None


def random_priors(rng, which, T, cloud):
    """Some priors, all of which the pose T satisfies."""
    wanted = {}
    if which & 1:
        degrees, G = rng.uniform(0, 25), np.eye(4)
        G[:3, :3] = Rotation.from_rotvec(
            np.radians(degrees) * shapes.directions(rng, 1)[0]
        ).as_matrix()
        center, translation = cloud.mean(axis=0), rng.uniform(-0.3, 0.3, 3)
        to = T[:3, :3] @ center + T[:3, 3]
        G[:3, 3] = to - G[:3, :3] @ to + translation
        wanted["guess"] = (G @ T).tolist()
        wanted["guess_rotation"] = degrees + rng.uniform(0.001, 10)
        wanted["guess_translation"] = np.linalg.norm(translation) + rng.uniform(0.001, 0.2)
    if which & 2:
        axis, degrees = vector_of(T)
        wanted["axis"] = (rng.uniform(0.1, 10) * axis).tolist()
        wanted["axis_tilt"] = rng.choice([0, rng.uniform(0, 10)])
        wanted["axis_angle_minimum"] = degrees - rng.uniform(0, 90)
        wanted["axis_angle_maximum"] = degrees + rng.uniform(0, 90)
    if which & 4:
        wanted["translation_bounds"] = (
            T[:3, 3] - rng.uniform(0.001, 0.3, 3),
            T[:3, 3] + rng.uniform(0.001, 0.3, 3),
        )
    if which & 8:
        wanted["maximum_rotation"] = min(180, vector_of(T)[1] + rng.uniform(0.001, 20))
    return wanted


@settings(max_examples=60, deadline=None)
@given(
    seed=st.integers(0, 2**32),
    which=st.integers(1, 15),
    preset=st.sampled_from(["default", "paper"]),
    true=st.booleans(),
)
def test_every_pose_that_is_given_satisfies_the_priors(seed, which, preset, true):
    """The pose obeys the priors whether or not the clouds do."""
    rng = np.random.default_rng(seed)
    source, target, truth = shapes.make_pair(seed % 5, count=1500)
    about = truth if true else shapes.random_transformation(rng)
    wanted = random_priors(rng, which, about, source)
    few = SMALL if preset == "default" else {**SMALL, "candidates": 0}
    found = pyemtr.register(source, target, preset=preset, seed=seed % 97, **few, **wanted)
    for T in [found.transformation, *(a.transformation for a in found.alternatives)]:
        assert kept(T, source, wanted) is None
    assert bits(pyemtr.register(source, target, **found.settings)) == bits(found)


@pytest.mark.parametrize("which", [1, 2, 4, 8, 15])
def test_a_true_prior_leads_to_the_true_pose(pair, which):
    rng = np.random.default_rng(which)
    found = pyemtr.register(
        pair.source, pair.target, threads=2, **random_priors(rng, which, pair.truth, pair.source)
    )
    assert found.registered
    assert shapes.rotation_error(found.transformation, pair.truth) < 0.1


@pytest.mark.parametrize("preset", ["default", "paper"])
def test_a_prior_without_the_true_pose_is_not_registered(pair, preset):
    axis, degrees = vector_of(pair.truth)
    off = np.cross(axis, [1, 0, 0])
    G = pair.truth.copy()
    G[:3, :3] = Rotation.from_rotvec(0.7 * off / np.linalg.norm(off)).as_matrix() @ G[:3, :3]
    wrong = [
        {"axis": off},
        {"maximum_rotation": degrees / 2},
        {"guess": G, "guess_rotation": 20},
        {"axis": axis, "axis_angle_minimum": degrees + 20, "axis_angle_maximum": degrees + 90},
        {"translation_bounds": (pair.truth[:3, 3] + 0.5, pair.truth[:3, 3] + 0.8)},
    ]
    for prior in wrong:
        found = pyemtr.register(pair.source, pair.target, threads=2, preset=preset, **prior)
        assert not found.registered, (prior, found)


def test_upright_the_refinement_is_the_optimum_of_four(pair):
    """With the axis known the rotation is nearer to the truth than without, over some pairs."""
    free, upright = [], []
    for seed in range(6):
        source, target, truth = shapes.make_pair(seed + 20, count=5000)
        axis, _ = vector_of(truth)
        for errors, prior in ((free, {}), (upright, {"axis": axis})):
            found = pyemtr.register(source, target, threads=2, preset="fast", **prior)
            assert found.registered and found.refined
            errors.append(shapes.rotation_error(found.transformation, truth))
    assert np.mean(upright) < np.mean(free)


def test_any_threads_and_a_problem_give_the_same_bits(pair):
    wanted = random_priors(np.random.default_rng(3), 15, pair.truth, pair.source)
    one = pyemtr.register(pair.source, pair.target, threads=1, **wanted)
    other = pyemtr.register(pair.source, pair.target, threads=3, **wanted)
    assert bits(one) == bits(other)
    clouds = pair.source, pair.target
    problem = pyemtr.Problem(*clouds, **wanted)
    assert bits(problem.solve()) == bits(pyemtr.register(*clouds, coarse_points=0, **wanted))
    assert problem.settings["axis"] == wanted["axis"]
    low, high = wanted["translation_bounds"]
    assert problem.settings["translation_bounds"] == [low.tolist(), high.tolist()]


def test_the_complement_keeps_to_the_bounds(pair):
    angles = pyemtr.Problem(pair.source, pair.target, **SMALL).to_particle(pair.truth)[:3]
    away = pair.truth[:3, 3] + [0.3, 0, 0]
    problem = pyemtr.Problem(
        pair.source, pair.target, translation_bounds=(away - 0.01, away + 0.01), **SMALL
    )
    T = problem.to_transformation([*angles, *problem.complement(angles)])
    assert np.allclose(T[:3, :3], pair.truth[:3, :3])
    assert (np.abs(T[:3, 3] - away) <= 0.01 + 1e-9).all()


def test_the_unit_of_the_clouds_is_that_of_the_priors(pair):
    wanted = random_priors(np.random.default_rng(4), 5, pair.truth, pair.source)
    one = pyemtr.register(pair.source, pair.target, threads=2, **wanted)
    G = np.array(wanted["guess"])
    G[:3, 3] *= 1024
    low, high = wanted["translation_bounds"]
    large = {
        **wanted,
        "guess": G,
        "guess_translation": 1024 * wanted["guess_translation"],
        "translation_bounds": (1024 * low, 1024 * high),
    }
    other = pyemtr.register(1024 * pair.source, 1024 * pair.target, threads=2, **large)
    assert other.confidence == one.confidence
    np.testing.assert_array_equal(other.transformation[:3, :3], one.transformation[:3, :3])


@pytest.mark.parametrize(
    "arguments, error, text",
    [
        ({"axis": [0, 0, 0]}, ValueError, "'axis' is no direction"),
        ({"axis": [0, 1]}, ValueError, r"axis.*\(3,\)"),
        ({"axis": [0, np.nan, 1]}, ValueError, "axis.*NaN"),
        ({"axis": "z"}, TypeError, "axis"),
        ({"axis": [0, 0, 1], "axis_tilt": -1}, ValueError, "axis_tilt"),
        ({"axis_tilt": 3}, ValueError, "axis_tilt.*without 'axis'"),
        ({"guess_rotation": 3}, ValueError, "guess_rotation.*without 'guess'"),
        ({"guess": np.eye(4), "guess_rotation": 181}, ValueError, "guess_rotation"),
        ({"guess": np.eye(4), "guess_translation": np.inf}, ValueError, "guess_translation"),
        ({"maximum_rotation": np.nan}, ValueError, "maximum_rotation"),
        ({"translation_bounds": [0, 1]}, ValueError, r"translation_bounds.*\(2, 3\)"),
        ({"translation_bounds": [[0, 0, 0], [1, -1, 1]]}, ValueError, "the minimum of y"),
        ({"translation_bounds": [[0, 0, 0], [1, np.inf, 1]]}, ValueError, "translation_bounds"),
        (
            {"axis": [0, 0, 1], "axis_angle_minimum": 60, "maximum_rotation": 50},
            ValueError,
            "'axis' and 'maximum_rotation' contradict",
        ),
    ],
)
def test_bad_priors_are_named(pair, arguments, error, text):
    with pytest.raises(error, match=text):
        pyemtr.register(pair.source, pair.target, **arguments)


def rectangles(rng, count=9):
    """Straight walls at right angles, in places of their own; all z are 0."""
    walls = []
    for _ in range(count):
        start, length = rng.uniform(0, 10, 2), rng.uniform(1, 6)
        along = np.array([length, 0] if rng.uniform() < 0.5 else [0, length])
        walls.append(start + rng.uniform(size=(200, 1)) * along)
    points = np.vstack(walls)
    return np.column_stack([points, np.zeros(len(points))])


PLANE = {"axis": (0, 0, 1), "translation_bounds": ((-30, -30, 0), (30, 30, 0))}


@pytest.mark.parametrize("seed", range(3))
def test_two_dimensions(seed):
    rng = np.random.default_rng(seed)
    plan = rectangles(rng)
    source = plan + np.append(rng.normal(scale=0.01, size=2), 0)
    truth = np.eye(4)
    truth[:3, :3] = Rotation.from_rotvec([0, 0, rng.uniform(-3, 3)]).as_matrix()
    truth[:2, 3] = rng.uniform(-9, 9, 2)
    target = shapes.apply(truth, plan[rng.permutation(len(plan))[:1500]])
    result = pyemtr.register(source[source[:, 0] < 9], target, threads=1, **PLANE)
    assert result.registered
    moved = shapes.apply(result.transformation, source)
    assert np.abs(moved - shapes.apply(truth, source)).max() < 0.1
    assert np.abs(result.transformation[2] - [0, 0, 1, 0]).max() < 1e-9

    open_height = pyemtr.register(source, target, threads=1, axis=(0, 0, 1))
    assert open_height.reason == "degenerate"


@pytest.mark.parametrize("seed", range(4))
def test_unrelated_plans_are_not_registered(seed):
    rng = np.random.default_rng(100 + seed)
    result = pyemtr.register(rectangles(rng), rectangles(rng), threads=1, seed=seed, **PLANE)
    assert not result.registered
