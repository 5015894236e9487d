"""Task alpha's fitness on the dense clouds in Python, with other points than the library's."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

import pyemtr

from ..protocol import apply
from ..runner import Array

#: Points that are looked at, points that are looked among, and c in dense leaves.
Reading = tuple[str, str, float]
FARTHEST_AMONG = 12000  # points, of which the farthest are taken


def fitness(
    problem: pyemtr.Problem, source: Array, target: Array, reading: Reading
) -> Callable[[Array], Array]:
    """Task alpha's fitness on the dense clouds, as a function of particles (P, 6), with other
    points than the library's. Its own are "centroids" among "whole", by preset `paper`."""
    from scipy.spatial import cKDTree

    points, among, leaves = reading
    c = leaves * problem.leaf_dense
    whole = [(cloud - center) / problem.normalization_scale for cloud, center in
             ((source, problem.center_source), (target, problem.center_target))]  # fmt: skip
    centroids = [np.asarray(cloud, dtype=np.float64)
                 for cloud in (problem.source_dense, problem.target_dense)]  # fmt: skip
    clouds = {"whole": whole, "centroids": centroids}
    if "farthest" in (points, among):
        clouds["farthest"] = [farthest(a, len(b)) for a, b in zip(whole, centroids)]
    queries, trees = clouds[points], [cKDTree(cloud) for cloud in clouds[among]]
    pose = _normalized(problem)

    def found(particles: Array) -> Array:
        poses = [pose(particle) for particle in np.atleast_2d(particles)]
        there = np.array([apply(T, queries[0]) for T in poses])
        back = np.array([apply(np.linalg.inv(T), queries[1]) for T in poses])
        return rho(trees[1], there, c) + rho(trees[0], back, c)

    return found


def rho(tree: Any, points: Array, c: float) -> Array:
    """The sums of Tukey's function over the distances of rows of points (P, n, 3) to the nearest
    ones, (P,)."""
    distances = tree.query(points, distance_upper_bound=c)[0]
    return (1.0 - (1.0 - np.minimum(distances / c, 1.0) ** 2) ** 3).sum(axis=1)


def farthest(points: Array, count: int) -> Array:
    """`count` points, each the farthest from those before it, of FARTHEST_AMONG at most."""
    if len(points) > FARTHEST_AMONG:
        chosen = np.random.default_rng(0).choice(len(points), FARTHEST_AMONG, replace=False)
        points = points[chosen]
    taken = np.zeros(min(count, len(points)), dtype=np.int64)
    nearest = np.full(len(points), np.inf)
    for i in range(1, len(taken)):
        nearest = np.minimum(nearest, ((points - points[taken[i - 1]]) ** 2).sum(axis=1))
        taken[i] = int(np.argmax(nearest))
    return points[taken]


def _normalized(problem: pyemtr.Problem) -> Callable[[Array], Array]:
    """Particles as matrices (4, 4) of the normalized frame."""
    from_source, to_target = np.eye(4), np.eye(4)
    from_source[:3, :3] *= problem.normalization_scale
    from_source[:3, 3] = problem.center_source
    to_target[:3, :3] /= problem.normalization_scale
    to_target[:3, 3] = -problem.center_target / problem.normalization_scale
    return lambda particle: to_target @ problem.to_transformation(particle) @ from_source
