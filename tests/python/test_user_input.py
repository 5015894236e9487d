"""Normals, features and correspondences that users bring along."""

from __future__ import annotations

import re

import numpy as np
import pytest
import shapes
from hypothesis import given, settings
from hypothesis import strategies as st
from shapes import bits

import pyemtr

QUICK = {"preset": "fast", "iterations": 2, "threads": 1}


class Known:
    """Two overlapping parts of one sampled egg, so that it is known which rows are one point."""

    def __init__(self, count: int = 6000, seed: int = 3) -> None:
        rng = np.random.default_rng(seed)
        points = shapes.lump(rng, count)
        self.truth = shapes.random_transformation(rng)
        in_source, in_target = points[:, 0] > -0.5, points[:, 0] < 0.5
        self.target = points[in_target]
        self.source = shapes.apply(np.linalg.inv(self.truth), points[in_source])
        both = in_source & in_target
        self.matches = np.column_stack([np.cumsum(in_source)[both], np.cumsum(in_target)[both]]) - 1
        self.mixed = rng.permutation(len(self.matches))

    def correspondences(self, count: int, wrong: float, seed: int = 1) -> np.ndarray:
        """So many, a share of which lead anywhere."""
        rng = np.random.default_rng(seed)
        pairs = self.matches[self.mixed[:count]].copy()
        bad = rng.random(count) < wrong
        pairs[bad, 1] = rng.integers(0, len(self.target), bad.sum())
        return pairs

    def codes(self, points: np.ndarray, numbers: int = 6) -> np.ndarray:
        """Descriptors that depend on where on the egg a point is, given in the target's frame."""
        waves = np.random.default_rng(11).normal(scale=4, size=(3, numbers))
        return np.sin(points @ waves).astype(np.float32)

    def error(self, result: pyemtr.Result) -> float:
        return float(np.abs(result.transformation - self.truth).max())

    def features(self, numbers: int = 6) -> dict[str, np.ndarray]:
        return {
            "source_features": self.codes(shapes.apply(self.truth, self.source), numbers),
            "target_features": self.codes(self.target, numbers),
        }


@pytest.fixture(scope="module")
def known() -> Known:
    return Known()


@pytest.mark.parametrize("wrong", [0.0, 0.5, 0.8])
def test_correspondences_register_though_most_are_wrong(known, wrong):
    pairs = known.correspondences(600, wrong)
    result = pyemtr.register(known.source, known.target, correspondences=pairs, threads=2)
    assert result.registered and known.error(result) < 0.02
    assert result.correspondences == 600
    preprocessed = [pyemtr.Cloud(cloud) for cloud in (known.source, known.target)]
    assert bits(pyemtr.register(*preprocessed, correspondences=pairs.tolist())) == bits(result)


@pytest.mark.parametrize("numbers", [3, 33, 128])
def test_features_of_any_dimension_register(known, numbers):
    features = known.features(numbers)
    result = pyemtr.register(known.source, known.target, threads=2, **features)
    assert result.registered and known.error(result) < 0.02
    # of any type, layout and strides; and with preprocessed clouds
    odd = {name: np.asfortranarray(values, np.float64) for name, values in features.items()}
    assert bits(pyemtr.register(known.source, known.target, **odd)) == bits(result)
    wide = np.repeat(features["source_features"], 2, axis=1)[:, ::2]
    assert not wide.flags.c_contiguous
    assert bits(
        pyemtr.register(
            pyemtr.Cloud(known.source, features=wide),
            known.target,
            target_features=features["target_features"],
        )
    ) == bits(result)


def test_the_library_s_features_give_its_own_correspondences(known):
    own = pyemtr.Problem(known.source, known.target)
    given_own = pyemtr.Problem(
        own.source_dense,
        own.target_dense,
        source_features=own.source_features,
        target_features=own.target_features,
    )
    rows = np.column_stack(
        [
            given_own.source_feature_rows[given_own.correspondences[:, 0]],
            given_own.target_feature_rows[given_own.correspondences[:, 1]],
        ]
    )
    np.testing.assert_array_equal(rows, own.correspondences)
    assert len(rows) > 50
    assert own.source_feature_rows.size == own.target_feature_rows.size == 0
    np.testing.assert_array_equal(own.source_feature_points, own.source_dense)


def matched_rows(problem: pyemtr.Problem) -> set[tuple[int, int]]:
    pairs = problem.correspondences
    source = problem.source_feature_rows[pairs[:, 0]].tolist()
    return set(zip(source, problem.target_feature_rows[pairs[:, 1]].tolist(), strict=True))


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 2**32 - 1), missing=st.integers(0, 200), bad=st.integers(0, 20))
def test_points_may_stand_in_any_order(seed, missing, bad):
    """Permuted with their features they are matched as before; rows are those of the caller."""
    rng = np.random.default_rng(seed)
    known = Known(1200, seed=5)
    # Sums of such numbers are exact, so their order cannot change a bit of the frame.
    source = np.round(known.source * 4096) / 4096
    target = np.round(known.target * 4096) / 4096
    features = known.features(4)
    source_features = features["source_features"].copy()
    source_features[rng.choice(len(source), missing, replace=False), 2] = np.nan
    source[rng.choice(len(source), bad, replace=False), 1] = np.inf
    order, other = rng.permutation(len(source)), rng.permutation(len(target))
    settings = {"max_correspondences": 20000, **QUICK}
    plain = pyemtr.Problem(
        source,
        target,
        source_features=source_features,
        target_features=features["target_features"],
        **settings,
    )
    mixed = pyemtr.Problem(
        source[order],
        target[other],
        source_features=source_features[order],
        target_features=features["target_features"][other],
        **settings,
    )
    assert {(order[s], other[t]) for s, t in matched_rows(mixed)} == matched_rows(plain)
    rows = plain.source_feature_rows
    assert np.isfinite(source_features[rows]).all() and np.isfinite(source[rows]).all()
    expected = (source[rows] - plain.center_source) / plain.normalization_scale
    np.testing.assert_allclose(plain.source_feature_points, expected, atol=1e-6)
    np.testing.assert_array_equal(plain.source_features, source_features[rows])


def test_problems_and_tasks_take_them(known):
    pairs = known.correspondences(300, 0.5)
    problem = pyemtr.Problem(known.source, known.target, correspondences=pairs)
    assert matched_rows(problem) == set(map(tuple, pairs.tolist()))
    assert problem.source_features.shape == (0, 33)
    wanted = pyemtr.register(known.source, known.target, correspondences=pairs)
    assert bits(problem.solve()) == bits(wanted)
    particles = np.random.default_rng(1).uniform(-1, 1, (5, 3))
    task = pyemtr.TaskBeta(known.source, known.target, correspondences=pairs)
    np.testing.assert_array_equal(task.evaluate(particles), problem.evaluate_beta(particles))


def test_of_too_many_correspondences_some_from_all_over_are_taken(known):
    pairs = known.matches[:1500]
    problem = pyemtr.Problem(known.source, known.target, correspondences=pairs, **QUICK)
    taken = sorted(matched_rows(problem))
    assert taken == [tuple(pairs[i * 1500 // 1000]) for i in range(1000)]


def up(points: np.ndarray) -> np.ndarray:
    """Directions away from the origin, of any length: on the egg, roughly outwards."""
    return points * np.linspace(0.5, 20, len(points))[:, None]


def test_normals_replace_the_estimated_ones(known):
    outwards = up(known.target)
    outwards_of_source = up(known.source - known.truth[:3, :3].T @ -known.truth[:3, 3])
    given = pyemtr.Problem(
        known.source, known.target, source_normals=outwards_of_source, target_normals=outwards
    )
    lengths = np.linalg.norm(given.target_normals, axis=1)
    np.testing.assert_allclose(lengths, 1, atol=1e-5)
    # The mean of a cube's points is what their directions are, but for the width of the cube.
    at = given.target_dense * given.normalization_scale + given.center_target
    cosine = (at * given.target_normals).sum(axis=1) / np.linalg.norm(at, axis=1)
    assert cosine.min() > 0.99
    estimated = pyemtr.Problem(known.source, known.target)
    inwards = (at * estimated.target_normals).sum(axis=1) < 0
    assert inwards.mean() > 0.5  # they look to the centroid

    result = given.solve()
    assert known.error(result) < 0.05
    clouds = (
        pyemtr.Cloud(known.source, normals=outwards_of_source),
        pyemtr.Cloud(known.target, normals=outwards.tolist()),
    )
    assert bits(pyemtr.register(*clouds)) == bits(result)


def test_normals_in_an_object_are_not_used_by_themselves(known):
    class Scan:
        def __init__(self, points: np.ndarray, normals: np.ndarray) -> None:
            self.points, self.normals = points, normals

    wanted = bits(pyemtr.register(known.source, known.target, **QUICK))
    scans = Scan(known.source, up(known.source)), Scan(known.target, up(known.target))
    assert bits(pyemtr.register(*scans, **QUICK)) == wanted


def test_what_a_cloud_tells(known):
    features = known.features(4)["target_features"].copy()
    features[:10] = np.nan
    made = pyemtr.Cloud(known.target, normals=up(known.target), features=features)
    assert made.has_normals and made.keypoints == len(known.target) - 10
    assert f"normals, {len(known.target) - 10} features of 4, radius" in repr(made)
    plain = pyemtr.Cloud(known.target)
    assert not plain.has_normals and plain.keypoints == 0
    assert "features" not in repr(plain)


def test_a_large_preprocessed_cloud_keeps_its_points_when_asked():
    rng = np.random.default_rng(2)
    points = shapes.lump(rng, 210_000)
    target = points[::50]
    pairs = np.column_stack([np.arange(0, 210_000, 50), np.arange(len(target))])[::7]
    truth = shapes.random_transformation(rng)
    source = shapes.apply(np.linalg.inv(truth), points)
    plain = pyemtr.register(source, target, correspondences=pairs, **QUICK)
    assert np.abs(plain.transformation - truth).max() < 0.02
    kept = pyemtr.Cloud(source, keep_points=True)
    assert bits(pyemtr.register(kept, target, correspondences=pairs, **QUICK)) == bits(plain)
    with pytest.raises(ValueError, match="cloud: preprocessed without keep_points"):
        pyemtr.register(pyemtr.Cloud(source), target, correspondences=pairs, **QUICK)


BAD = [
    ({"source_normals": np.zeros((5, 3))}, ValueError, "source_normals: expected one row for each"),
    ({"target_normals": np.zeros((300, 4))}, ValueError, r"target_normals: .* shape \(300, 3\)"),
    ({"target_normals": np.zeros((300, 3))}, ValueError, "target cloud: normals are given, but no"),
    ({"source_normals": [["a"] * 3] * 300}, TypeError, "source_normals: expected an array of real"),
    ({"source_features": np.ones((300, 4))}, ValueError, "given for the source cloud only"),
    ({"target_features": np.ones((300, 4))}, ValueError, "given for the target cloud only"),
    ({"source_features": np.ones(300)}, ValueError, r"source_features: .* shape \(300,\)"),
    ({"source_features": np.ones((33, 300))}, ValueError, "source_features: expected one row"),
    ({"source_features": np.ones((300, 0))}, ValueError, "at least one number a point"),
    ({"source_features": np.ones((300, 2), complex)}, TypeError, "source_features: .* real"),
    (
        {"source_features": np.ones((300, 4)), "target_features": np.ones((300, 5))},
        ValueError,
        "4 numbers in the source cloud and 5 in the target cloud",
    ),
    (
        {"source_features": np.full((300, 4), np.nan), "target_features": np.ones((300, 4))},
        ValueError,
        "source cloud: features are given, but no finite point has one",
    ),
    ({"correspondences": np.ones((5, 3), int)}, ValueError, r"shape \(K, 2\), .* got \(5, 3\)"),
    ({"correspondences": np.ones((0, 2), int)}, ValueError, r"got \(0, 2\)"),
    ({"correspondences": np.ones((5, 2))}, TypeError, "whole numbers, got dtype float64"),
    ({"correspondences": [[0, 0], [1, 1]]}, ValueError, "2 different ones, expected at least 3"),
    ({"correspondences": [[0, 0]] * 9}, ValueError, "1 different ones, expected at least 3"),
    ({"correspondences": [[0, 0], [1, -1]]}, ValueError, r"row 1: \[1, -1\] are no rows"),
    ({"correspondences": [[0, 0], [2**33, 1]]}, ValueError, r"row 1: \[8589934592, 1\] are no"),
    (
        {"correspondences": [[0, 0], [1, 1], [300, 4]]},
        ValueError,
        "correspondences: row 2: source point 300, expected 0 to 299",
    ),
    (
        {"correspondences": [[0, 0], [1, 7], [2, 4]]},
        ValueError,
        "correspondences: row 1: target point 7 is not finite",
    ),
]


@pytest.mark.parametrize(("given", "error", "pattern"), BAD)
def test_what_is_wrong_is_named(given, error, pattern):
    rng = np.random.default_rng(1)
    source, target = shapes.lump(rng, 300), shapes.lump(rng, 300)
    target[7] = np.nan
    with pytest.raises(error) as caught:
        pyemtr.register(source, target, **given, **QUICK)
    assert re.search(pattern, str(caught.value)), caught.value


def test_a_cloud_brings_its_own(known):
    with pytest.raises(TypeError, match=r"source_normals: a pyemtr\.Cloud has its own"):
        pyemtr.register(
            pyemtr.Cloud(known.source), known.target, source_normals=known.source, **QUICK
        )
    with pytest.raises(TypeError, match=r"target_features: a pyemtr\.Cloud has its own"):
        pyemtr.register(
            known.source, pyemtr.Cloud(known.target), target_features=known.target, **QUICK
        )
    with pytest.raises(ValueError, match="normals: expected one row for each of the"):
        pyemtr.Cloud(known.source, normals=known.target)
