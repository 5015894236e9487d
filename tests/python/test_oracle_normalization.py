"""The normalized frame, the scales that follow from it, and the TIMs."""

import numpy as np
import oracles
import pytest
import shapes

import pyemtr


def test_centers_and_one_scale(problem, pair):
    centers = pair.source.mean(axis=0), pair.target.mean(axis=0)
    np.testing.assert_allclose(problem.center_source, centers[0], atol=1e-12)
    np.testing.assert_allclose(problem.center_target, centers[1], atol=1e-12)
    radii = [
        np.linalg.norm(cloud - center, axis=1).max()
        for cloud, center in zip((pair.source, pair.target), centers)
    ]
    rung = 2 ** (np.ceil(8 * np.log2(max(radii))) / 8)
    assert problem.normalization_scale == pytest.approx(rung, rel=1e-12)


def test_without_the_ladder_the_scale_is_the_larger_radius(pair):
    exact = pyemtr.Problem(pair.source, pair.target, leaf_ladder=False)
    radius = np.linalg.norm(pair.source - pair.source.mean(axis=0), axis=1).max()
    other = np.linalg.norm(pair.target - pair.target.mean(axis=0), axis=1).max()
    assert exact.normalization_scale == pytest.approx(max(radius, other), rel=1e-12)
    dense = len(exact.source_dense) + len(exact.target_dense)
    assert dense == pytest.approx(exact.settings["dense_points"], rel=0.01)


@pytest.mark.parametrize("level", ["dense", "sparse"])
@pytest.mark.parametrize("side", ["source", "target"])
def test_downsampled_clouds_lie_on_the_normalized_ones(problem, pair, side, level):
    downsampled = getattr(problem, f"{side}_{level}").astype(float)
    whole = (getattr(pair, side) - getattr(problem, f"center_{side}")) / problem.normalization_scale
    leaf = getattr(problem, f"leaf_{level}")
    assert np.linalg.norm(downsampled, axis=1).max() <= 1 + 1e-6
    assert oracles.nearest(downsampled, whole)[0].max() < leaf
    # One point a voxel: every point of the cloud has its voxel's centroid within a diagonal.
    assert oracles.nearest(whole, downsampled)[0].max() <= leaf * np.sqrt(3) * (1 + 1e-5)


@pytest.mark.parametrize("level", ["dense", "sparse"])
def test_downsampled_points_are_centroids_of_voxels(problem, pair, level):
    whole = (pair.source - problem.center_source) / problem.normalization_scale
    cells = np.floor(whole / getattr(problem, f"leaf_{level}")).astype(int)
    _, cell, size = np.unique(cells, axis=0, return_inverse=True, return_counts=True)
    sums = np.stack([np.bincount(cell.ravel(), whole[:, axis]) for axis in range(3)], axis=1)
    downsampled = getattr(problem, f"source_{level}").astype(float)
    # float32 may put a point on a voxel's face to the other side.
    assert len(downsampled) == pytest.approx(len(size), rel=0.002)
    gaps = oracles.nearest(downsampled, sums / size[:, None])[0]
    assert np.mean(gaps < 2e-6) > 0.99


def test_counts_are_met(problem):
    dense = len(problem.source_dense) + len(problem.target_dense)
    rung = 0.1  # of the count of points, half a rung of the leaf
    assert dense == pytest.approx(problem.settings["dense_points"], rel=rung)
    assert len(problem.source_sparse) == pytest.approx(problem.settings["sparse_points"], rel=rung)


def test_tau_is_from_the_mean_resolution(problem):
    clouds = problem.source_dense.astype(float), problem.target_dense.astype(float)
    resolution = np.mean([oracles.mean_resolution(cloud) for cloud in clouds])
    assert problem.tau == pytest.approx(problem.settings["tau_factor"] * resolution, rel=1e-5)


def test_scales_of_the_m_estimator(problem):
    used = problem.settings
    assert problem.c_sparse == pytest.approx(used["scale_sparse"] * problem.leaf_sparse, rel=1e-6)
    assert problem.c_dense == pytest.approx(used["scale_dense"] * problem.leaf_dense, rel=1e-6)


@pytest.mark.parametrize("preset", ["paper", "default"])
def test_tims_are_all_pairs_of_the_best_but_the_hopeless(request, preset):
    problem = request.getfixturevalue("paper_problem" if preset == "paper" else "problem")
    most = int((1 + np.sqrt(1 + 8 * problem.settings["max_tims"])) / 2)
    rows = problem.correspondences[:most]
    assert len(problem.correspondences) > most  # the cap is put to the test
    p, q = problem.source_dense[rows[:, 0]], problem.target_dense[rows[:, 1]]
    j, k = np.triu_indices(len(rows), 1)
    assert problem.tims == len(j)
    assert problem.tims_pruned + len(problem.tim_source) == problem.tims

    every = np.hstack([p[k] - p[j], q[k] - q[j]])  # float32, as the arrays are
    gap = np.abs(
        np.linalg.norm(every[:, :3].astype(float), axis=1)
        - np.linalg.norm(every[:, 3:].astype(float), axis=1)
    )
    threshold = problem.settings["inlier_threshold"] * problem.tau
    kept = {row.tobytes() for row in np.hstack([problem.tim_source, problem.tim_target])}
    for row, distance in zip(every, gap):
        # Kept a little beyond the threshold, so that rounding can drop none that would count.
        if abs(distance - threshold) > 2e-5 * threshold + 2e-6:
            assert (row.tobytes() in kept) == (distance < threshold)
    assert 0 < problem.tims_pruned < problem.tims


def test_far_from_the_origin_nothing_changes(problem):
    import pyemtr

    far = shapes.make_pair(seed=1, offset=2.0**22)
    other = pyemtr.Problem(far.source, far.target, threads=2)
    assert other.normalization_scale == pytest.approx(problem.normalization_scale, rel=1e-8)
    assert len(other.target_dense) == pytest.approx(len(problem.target_dense), rel=0.01)
