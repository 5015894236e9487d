"""Residuals, compared with those by scipy's kd-tree."""

import numpy as np
import pytest
import shapes
from scipy.spatial import cKDTree

import pyemtr


@pytest.fixture(scope="module")
def solved(pair):
    return pyemtr.register(pair.source, pair.target, threads=2)


def nearest(points, others):
    return cKDTree(others).query(points)[0]


@pytest.mark.parametrize("scale, offset", [(1.0, 0.0), (1e-3, 0.0), (1000.0, 4e6)])
def test_they_are_the_distances_to_the_nearest_point(scale, offset):
    pair = shapes.make_pair(seed=4, count=3000, scale=scale, offset=offset)
    moved = shapes.apply(pair.truth, pair.source)
    found = pyemtr.residuals(pair.source, pair.target, pair.truth, threads=2)
    assert found.dtype == np.float64 and found.shape == (len(pair.source),)
    np.testing.assert_allclose(found, nearest(moved, pair.target), rtol=0, atol=2e-6 * scale)
    back = pyemtr.residuals(pair.source, pair.target, pair.truth, of="target")
    assert back.shape == (len(pair.target),)
    np.testing.assert_allclose(back, nearest(pair.target, moved), rtol=0, atol=2e-6 * scale)


def test_a_result_measures_at_its_own_pose(pair, solved):
    moved = solved.apply(pair.source)
    expected = nearest(moved, pair.target)
    found = solved.residuals(pair.source, pair.target)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-6)
    assert (
        found.tobytes()
        == pyemtr.residuals(pair.source, pair.target, solved.transformation).tobytes()
    )
    np.testing.assert_allclose(
        solved.residuals(pair.source, pair.target, of="target"),
        nearest(pair.target, moved),
        rtol=0,
        atol=1e-6,
    )
    np.testing.assert_allclose(pyemtr.residuals(moved, pair.target), expected, rtol=0, atol=1e-6)


def test_any_layout_and_any_number_of_threads_are_the_same(pair):
    source = np.asfortranarray(pair.source.astype(np.float32))
    wanted = pyemtr.residuals(pair.source.astype(np.float32), pair.target, pair.truth, threads=1)
    for threads in (2, 5):
        found = pyemtr.residuals(source, pair.target.tolist(), pair.truth, threads=threads)
        assert found.tobytes() == wanted.tobytes()


def test_dropped_points_have_none(pair):
    source = pair.source.copy()
    source[[2, 90]] = [[np.nan], [np.inf]]
    target = np.ma.masked_array(pair.target, mask=np.zeros_like(pair.target, bool))
    target[5] = np.ma.masked
    found = pyemtr.residuals(source, target, pair.truth)
    assert np.flatnonzero(np.isnan(found)).tolist() == [2, 90]
    back = pyemtr.residuals(source, target, pair.truth, of="target")
    assert np.flatnonzero(np.isnan(back)).tolist() == [5]
    kept = np.delete(source, [2, 90], axis=0)
    np.testing.assert_allclose(
        np.delete(back, 5),
        nearest(np.delete(pair.target, 5, axis=0), shapes.apply(pair.truth, kept)),
        rtol=0,
        atol=1e-6,
    )


def test_small_clouds_will_do():
    assert pyemtr.residuals([[1.0, 2.0, 3.0]], [[1.0, 2.0, 5.0]]).tolist() == [2.0]
    assert pyemtr.residuals(np.zeros((0, 3)), [[1.0, 2.0, 5.0]]).shape == (0,)


@pytest.mark.parametrize(
    "arguments, changes, error, text",
    [
        ((np.zeros((3, 9)), np.zeros((9, 3))), {}, ValueError, "source: .*transpose"),
        ((np.zeros((9, 3)), np.zeros((0, 3))), {}, ValueError, "target cloud: no finite point"),
        ((np.zeros((9, 3)), np.zeros((9, 3)), np.ones((4, 4))), {}, ValueError, "transformation"),
        ((np.zeros((9, 3)), np.zeros((9, 3)), np.full((4, 4), np.nan)), {}, ValueError, "NaN"),
        ((np.zeros((9, 3)), np.zeros((9, 3))), {"of": "both"}, ValueError, "of: .*'both'"),
        ((np.zeros((9, 3)), np.zeros((9, 3))), {"threads": -1}, ValueError, "threads"),
        ((np.full((9, 3), 1e9), np.eye(3)), {}, ValueError, "million"),
    ],
)
def test_bad_arguments_are_refused(arguments, changes, error, text):
    with pytest.raises(error, match=text):
        pyemtr.residuals(*arguments, **changes)


def test_preprocessed_clouds_and_results_are_taken(pair, solved):
    wanted = solved.residuals(pair.source, pair.target).tobytes()
    clouds = pyemtr.Cloud(pair.source), pyemtr.Cloud(pair.target)
    assert solved.residuals(*clouds).tobytes() == wanted
    assert pyemtr.residuals(*clouds, solved).tobytes() == wanted


def test_the_overlap_is_that_of_the_residuals(pair, solved):
    # The same points, but against the target as it is and not its fine cloud.
    distances = nearest(solved.apply(pair.source), pair.target)
    leaf = solved.leaf_fine * solved.normalization_scale
    assert solved.overlap_source == pytest.approx((distances < leaf).mean(), abs=0.05)
    assert 0.5 < solved.overlap_source < 1 and 0.5 < solved.overlap_target < 1
    assert solved.inlier_rmse < leaf
    # Noise of 0.002 on either side, and bumps that are no planes.
    assert 0.0015 < solved.inlier_rmse_plane < 0.006
