"""Readings of what the paper leaves open, and what they do to the errors.

There are two kinds of rows. A *search* is a whole run with other settings. An *optimum* is where
the fitness function itself is best near the true pose, found by Nelder and Mead: its error is the
function's and not the search's. The library has no setting for farthest points in the place of
voxel centroids, nor for a velocity limit that falls: those are tried in Python. The count of
queries is that of preset `paper` unless the name says otherwise. No reading is chosen by pair.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from evolving_methods import emtr_ssc

from ..pairs import Pair
from . import cases, chamfer
from .chamfer import Reading

#: Settings on top of preset `paper`.
SEARCHES: dict[str, dict[str, Any]] = {
    "search: as it is": {},
    "search: neighbors in the dense clouds, c of 1.2 leaves": {
        "dense_reference": "dense",
        "scale_dense": 1.2,
    },
    "search: neighbors in the dense clouds": {"dense_reference": "dense"},
    "search: c of 0.4 dense leaves": {"scale_dense": 0.4},
    "search: c of 0.8 dense leaves": {"scale_dense": 0.8},
    "search: c of 1.2 dense leaves": {"scale_dense": 1.2},
    "search: velocity limit 0.25": {"velocity_limit": 0.25},
    "search: 8000 dense points, twice the queries": {"dense_points": 8000},
}
#: What the last velocity limit is; None: the same as the first.
PYTHON_SEARCHES: dict[str, float | None] = {
    "search in Python: as it is": None,
    "search in Python: velocity limit falls to 0.02": 0.02,
}
OPTIMA: dict[str, Reading] = {
    "optimum: as it is": ("centroids", "whole", 0.5),
    "optimum: c of 1.2 dense leaves": ("centroids", "whole", 1.2),
    "optimum: neighbors in the dense clouds, c of 1.2 leaves": ("centroids", "centroids", 1.2),
    "optimum: neighbors in the dense clouds": ("centroids", "centroids", 0.5),
    "optimum: farthest points": ("farthest", "whole", 0.5),
    "optimum: farthest points among themselves, c of 1.2 leaves": ("farthest", "farthest", 1.2),
}
METHODS = (*SEARCHES, *PYTHON_SEARCHES, *OPTIMA)

FIRST_STEP = 0.02  # of Nelder and Mead: radians, and radii
MOST_EVALUATIONS = 600


def run(method: str, pair: Pair, index: int, seed: int, threads: int) -> dict[str, Any]:
    if method in SEARCHES:
        return cases.register(pair, index, seed, threads, cases.PRESET, SEARCHES[method])
    if method in PYTHON_SEARCHES:
        settings = emtr_ssc.Settings(last_velocity_limit=PYTHON_SEARCHES[method])
        found = cases.evolve_emtr(pair, index, seed, threads, settings)
        return {key: value for key, value in found.items() if key != "history"}
    return _optimum(pair, index, threads, OPTIMA[method])


def _optimum(pair: Pair, index: int, threads: int, reading: Reading) -> dict[str, Any]:
    from scipy.optimize import minimize

    case, problem = cases.moved_pair(pair, index), cases.clouds(pair, index, threads)
    fitness = chamfer.fitness(problem, case.source, case.target, reading)
    start = problem.to_particle(case.motion.T_true)
    simplex = np.vstack([start, start + FIRST_STEP * np.eye(6)])
    found = minimize(lambda row: fitness(row)[0], start, method="Nelder-Mead",
                     options={"initial_simplex": simplex, "maxfev": MOST_EVALUATIONS,
                              "xatol": 1e-6, "fatol": 1e-6})  # fmt: skip
    dense = len(problem.source_dense) + len(problem.target_dense)
    return {**cases.errors(case, problem, found.x), "queries": int(found.nfev) * dense}
