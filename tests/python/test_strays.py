"""Strays, a few points far outside of all the others, change nothing and are counted."""

import numpy as np
import pytest
import shapes

import pyemtr

QUICK = {"preset": "fast", "threads": 1}


@pytest.fixture(scope="module")
def pair():
    return shapes.make_pair(5, count=6000)


def with_strays(cloud, count, radii, seed=0):
    """The cloud with strays somewhere between its points."""
    rng = np.random.default_rng(seed)
    far = shapes.directions(rng, count) * rng.uniform(radii, 2 * radii, (count, 1))
    center, radius = cloud.mean(axis=0), np.ptp(cloud, axis=0).max() / 2
    return np.insert(cloud, rng.integers(0, len(cloud), count), center + radius * far, axis=0)


@pytest.mark.parametrize("radii", [10, 50, 1e4, 1e9])
def test_the_pose_is_that_without_them(pair, radii):
    clean = pyemtr.register(pair.source, pair.target, **QUICK)
    result = pyemtr.register(
        with_strays(pair.source, 5, radii), with_strays(pair.target, 9, radii, 1), **QUICK
    )
    assert (clean.strays_source, clean.strays_target) == (0, 0)
    assert (result.strays_source, result.strays_target) == (5, 9)
    assert (result.points_source, result.points_target) == (
        len(pair.source) + 5,
        len(pair.target) + 9,
    )
    assert clean.registered and result.registered
    assert np.allclose(result.transformation, clean.transformation, atol=1e-3)
    assert np.isclose(result.normalization_scale, clean.normalization_scale)


def test_large_coordinates_keep_their_digits(pair):
    offset = np.array([5e5, 4e6, 100.0])
    source = with_strays(pair.source, 5, 40) + offset
    source[7] = 0  # a mark for no measurement
    result = pyemtr.register(source, pair.target + offset, **QUICK)
    assert result.registered and result.strays_source == 6
    moved = shapes.apply(result.transformation, pair.source + offset) - offset
    assert np.abs(moved - shapes.apply(pair.truth, pair.source)).max() < 0.02


def test_they_have_residuals(pair):
    source = np.vstack([pair.source, [[100.0, 0, 0]]])
    result = pyemtr.register(source, pair.target, **QUICK)
    distances = result.residuals(source, pair.target)
    assert distances.shape == (len(source),)
    assert distances[-1] > 90 and np.median(distances) < 0.1


def test_correspondences_of_strays_are_left_out(pair):
    source = np.vstack([pair.source, [[100.0, 0, 0]]])
    wanted = shapes.apply(pair.truth, pair.source)
    rows = np.arange(0, len(pair.source), 10)
    nearest = [int(np.argmin(((pair.target - p) ** 2).sum(axis=1))) for p in wanted[rows]]
    named = np.column_stack([rows, nearest])
    clean = pyemtr.register(source, pair.target, correspondences=named, **QUICK)
    named = np.vstack([named, [[len(source) - 1, 3]]])
    result = pyemtr.register(source, pair.target, correspondences=named, **QUICK)
    assert result.registered and result.correspondences == clean.correspondences


def test_a_cloud_counts_them(pair):
    cloud = pyemtr.Cloud(with_strays(pair.source, 3, 30))
    assert cloud.strays == 3 and len(cloud) == len(pair.source) + 3
    assert ", 3 strays, radius" in repr(cloud)
    assert pyemtr.Cloud(pair.source).strays == 0
