"""Readings of what the paper leaves open, and what they do to the errors.

There are two kinds of rows. A *search* is a whole run with other settings. An *optimum* is where
the fitness function itself is best near the true pose, found by Nelder and Mead: its error is the
function's and not the search's. The readings of optima are those that the library has no setting
for: queries into the whole clouds, and farthest points in the place of voxel centroids. The count
of queries is that of preset `paper` unless the name says otherwise. No reading is chosen by pair.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from evolving_methods import emtr_ssc

import pyemtr

from ..pairs import Pair
from ..protocol import apply
from ..runner import Array
from . import cases

#: Settings on top of preset `paper`.
SEARCHES: dict[str, dict[str, Any]] = {
    "search: as it is": {},
    "search: c of 0.8 dense leaves": {"scale_dense": 0.8},
    "search: c of 0.5 dense leaves": {"scale_dense": 0.5},
    "search: velocity limit 0.25": {"velocity_limit": 0.25},
    "search: 8000 dense points, twice the queries": {"dense_points": 8000},
}
PYTHON_SEARCHES = {
    "search in Python: as it is": None,
    "search in Python: velocity limit falls to 0.02": 0.02,
}
#: Points that are looked at, points that are looked among, and c in dense leaves.
OPTIMA = {
    "optimum: as it is": ("centroids", "centroids", 1.2),
    "optimum: c of 0.5 dense leaves": ("centroids", "centroids", 0.5),
    "optimum: queries into the whole clouds": ("centroids", "whole", 1.2),
    "optimum: queries into the whole clouds, c of 0.5 leaves": ("centroids", "whole", 0.5),
    "optimum: farthest points": ("farthest", "farthest", 1.2),
    "optimum: farthest points into the whole clouds, c of 0.5 leaves": ("farthest", "whole", 0.5),
}
METHODS = (*SEARCHES, *PYTHON_SEARCHES, *OPTIMA)

FIRST_STEP = 0.02  # of Nelder and Mead: radians, and radii
MOST_EVALUATIONS = 600
FARTHEST_AMONG = 12000  # points, of which the farthest are taken


def run(method: str, pair: Pair, index: int, seed: int, threads: int) -> dict[str, Any]:
    if method in SEARCHES:
        return cases.register(pair, index, seed, threads, cases.PRESET, SEARCHES[method])
    if method in PYTHON_SEARCHES:
        settings = emtr_ssc.Settings(last_velocity_limit=PYTHON_SEARCHES[method])
        found = cases.evolve_emtr(pair, index, seed, threads, settings)
        return {key: value for key, value in found.items() if key != "history"}
    return _optimum(pair, index, threads, *OPTIMA[method])


def _optimum(pair: Pair, index: int, threads: int, points: str, among: str, c: float
             ) -> dict[str, Any]:  # fmt: skip
    from scipy.optimize import minimize

    case, problem = cases.moved_pair(pair, index), cases.clouds(pair, index, threads)
    fitness = chamfer(problem, case.source, case.target, points, among, c * problem.leaf_dense)
    start = problem.to_particle(case.motion.T_true)
    simplex = np.vstack([start, start + FIRST_STEP * np.eye(6)])
    found = minimize(lambda row: fitness(row)[0], start, method="Nelder-Mead",
                     options={"initial_simplex": simplex, "maxfev": MOST_EVALUATIONS,
                              "xatol": 1e-6, "fatol": 1e-6})  # fmt: skip
    dense = len(problem.source_dense) + len(problem.target_dense)
    return {**cases.errors(case, problem, found.x), "queries": int(found.nfev) * dense}


def chamfer(
    problem: pyemtr.Problem, source: Array, target: Array, points: str, among: str, c: float
) -> Callable[[Array], Array]:
    """Task alpha's fitness on the dense clouds, as a function of particles (P, 6), with other
    points than the library's. With "centroids" twice it is the library's."""
    from scipy.spatial import cKDTree

    whole = [(cloud - center) / problem.normalization_scale for cloud, center in
             ((source, problem.center_source), (target, problem.center_target))]  # fmt: skip
    centroids = [np.asarray(cloud, dtype=np.float64)
                 for cloud in (problem.source_dense, problem.target_dense)]  # fmt: skip
    clouds = {"whole": whole, "centroids": centroids}
    if "farthest" in (points, among):
        clouds["farthest"] = [farthest(a, len(b)) for a, b in zip(whole, centroids)]
    queries, trees = clouds[points], [cKDTree(cloud) for cloud in clouds[among]]
    pose = _normalized(problem)

    def fitness(particles: Array) -> Array:
        poses = [pose(particle) for particle in np.atleast_2d(particles)]
        there = np.array([apply(T, queries[0]) for T in poses])
        back = np.array([apply(np.linalg.inv(T), queries[1]) for T in poses])
        return rho(trees[1], there, c) + rho(trees[0], back, c)

    return fitness


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
