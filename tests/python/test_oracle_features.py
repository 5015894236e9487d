"""Normals and correspondences against brute force; the descriptors themselves are PCL's."""

import numpy as np
import pytest

import pyemtr


def feature_distances(problem):
    a, b = problem.source_features.astype(float), problem.target_features.astype(float)
    squared = (a**2).sum(1)[:, None] + (b**2).sum(1)[None] - 2 * a @ b.T
    squared[~np.isfinite(squared)] = np.inf
    return np.sqrt(np.maximum(squared, 0))


def mutual(distances):
    """Rows of (source, target, distance, margin): how clearly they are each other's nearest."""
    found = []
    by_row, by_column = np.sort(distances, axis=1), np.sort(distances, axis=0)
    for i, j in enumerate(distances.argmin(axis=1)):
        if np.isfinite(distances[i, j]) and distances[:, j].argmin() == i:
            d = distances[i, j]
            found.append((i, j, d, min(by_row[i, 1], by_column[1, j]) - d))
    return found


@pytest.mark.parametrize("preset, most", [("paper", 5000), ("paper", 45), ("default", 500)])
def test_correspondences_are_mutual_nearest(pair, preset, most):
    problem = pyemtr.Problem(
        pair.source, pair.target, preset=preset, max_correspondences=most, threads=2
    )
    distances = feature_distances(problem)
    rows = problem.correspondences
    count = len(rows)
    assert len(np.unique(rows, axis=0)) == count <= most

    eps = 1e-3  # FPFH entries reach 100 in float32
    given = distances[rows[:, 0], rows[:, 1]]
    assert np.all(np.diff(given) >= -eps)  # the best come first
    assert np.all(given <= distances[rows[:, 0]].min(axis=1) + eps)
    assert np.all(given <= distances[:, rows[:, 1]].min(axis=0) + eps)

    pairs = {tuple(row) for row in rows.tolist()}
    clear = [(i, j, d) for i, j, d, margin in mutual(distances) if margin > eps]
    if len(clear) > most:  # capped: the best by feature distance
        assert count == most
        clear = [entry for entry in clear if entry[2] < given.max() - eps]
    missing = [entry for entry in clear if (entry[0], entry[1]) not in pairs]
    assert not missing
    assert len(clear) > 0.9 * count - 1


def test_most_descriptors_are_there_and_sum_up(problem):
    for name in ("source_features", "target_features"):
        features = getattr(problem, name)
        whole = features[np.isfinite(features).all(axis=1)]
        assert len(whole) > 0.99 * len(features)
        # Three histograms of 11 bins, each in per cent.
        np.testing.assert_allclose(whole.reshape(-1, 3, 11).sum(axis=2), 100, atol=0.05)


@pytest.mark.parametrize("side", ["source", "target"])
def test_normals_are_the_least_principal_direction(paper_problem, side):
    problem = paper_problem
    cloud = getattr(problem, f"{side}_dense").astype(float)
    normals = getattr(problem, f"{side}_normals").astype(float)
    radius = problem.settings["normal_radius"] * problem.leaf_dense
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-4)
    worst = []
    for i in range(0, len(cloud), 17):
        distance = np.linalg.norm(cloud - cloud[i], axis=1)
        if np.any(np.abs(distance - radius) < 1e-6):
            continue  # float32 decides whether that point is a neighbor
        around = cloud[distance < radius]
        values, vectors = np.linalg.eigh(np.cov(around.T, bias=True))
        if len(around) > 4 and values[1] > 3 * values[0]:  # else there is no clear normal
            worst.append(abs(vectors[:, 0] @ normals[i]))
    assert len(worst) > 30 and min(worst) > 0.9999


@pytest.mark.parametrize("side", ["source", "target"])
def test_normals_are_oriented_to_the_centroid_consistently(paper_problem, side):
    problem = paper_problem
    cloud = getattr(problem, f"{side}_dense").astype(float)
    normals = getattr(problem, f"{side}_normals").astype(float)
    side_of = np.sign((normals * -cloud).sum(axis=1))
    assert abs(side_of.mean()) > 0.999
