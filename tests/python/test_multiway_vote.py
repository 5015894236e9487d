"""The vote knows which pairs of many scans are worth a registration, without registering any."""

from __future__ import annotations

import numpy as np
from many_scans import scene

from pyemtr.multiway.surface import make_surface, thin
from pyemtr.multiway.vote import best_pairs, vote


def test_the_next_views_of_a_thing_are_among_the_best_pairs() -> None:
    made = scene({1: 8, 2: 8}, seed=3, count=4000, half_angle=80.0)
    surfaces = [make_surface(cloud, 1.0) for cloud in made.clouds]
    scores = vote(surfaces.__getitem__, len(surfaces), 1.0)
    assert len(scores) == 16 * 15 / 2
    chosen = best_pairs(scores, len(surfaces), 4)
    assert chosen == sorted(set(chosen)) and len(chosen) < 16 * 4
    # Views of one thing that look from less than 50 degrees apart, by the true poses.
    views = [pose[:3, :3] @ cloud.mean(axis=0) + pose[:3, 3]
             for pose, cloud in zip(made.truth, made.clouds)]  # fmt: skip
    wanted = []
    for j in range(16):
        for i in range(j):
            cosine = views[i] @ views[j] / np.linalg.norm(views[i]) / np.linalg.norm(views[j])
            if made.things[i] == made.things[j] and cosine > np.cos(np.radians(50)):
                wanted.append((j, i))
    assert len(wanted) >= 8
    missed = [pair for pair in wanted if pair not in chosen]
    assert len(missed) <= len(wanted) // 8, missed
    same = [made.things[j] == made.things[i] for j, i in chosen]
    assert np.mean(same) > 0.7  # where chance would give 0.47


def test_thinning_averages_each_voxel() -> None:
    points = np.array([[0.1, 0.1, 0.1], [0.3, 0.1, 0.1], [5.0, 0, 0]])
    np.testing.assert_allclose(thin(points, 1.0), [[0.2, 0.1, 0.1], [5.0, 0, 0]])


def test_a_surface_has_a_bounded_number_of_points() -> None:
    rng = np.random.default_rng(0)
    at = rng.normal(size=(60_000, 3))
    sphere = at / np.linalg.norm(at, axis=1, keepdims=True)
    surface = make_surface(sphere, 1.0)
    assert 5000 < len(surface.points) <= 9600
    assert np.abs(np.einsum("ij,ij->i", surface.points, surface.normals)).min() > 0.95
