"""A pair and a motion as the batched problem that the methods drive, and the runs on it."""

from __future__ import annotations

import time
from functools import lru_cache
from typing import Any

import numpy as np
from evolving_methods import emtr_ssc
from evolving_methods.methods import ALPHA, BETA, SPARSE, Method
from evolving_methods.problem import Problem, Task

import pyemtr

from ..pairs import Pair
from ..runner import Array, Moved, moved, pose_errors

PRESET = "paper"
POPULATION, ITERATIONS, SWITCH = 50, 100, 0.6
#: Tasks without nearest-neighbor queries are held to as many evaluations as two tasks have in the
#: paper, twice over.
MOST_EVALUATIONS = 4 * POPULATION * ITERATIONS

EQUAL_QUERIES, EQUAL_EVALUATIONS = "queries", "evaluations"


@lru_cache(maxsize=2)
def moved_pair(pair: Pair, index: int) -> Moved:
    return moved(pair, index)


@lru_cache(maxsize=2)
def clouds(pair: Pair, index: int, threads: int) -> pyemtr.Problem:
    """The pair as preset `paper` sees it."""
    case = moved_pair(pair, index)
    return pyemtr.Problem(case.source, case.target, preset=PRESET, threads=threads)


def tasks(problem: pyemtr.Problem) -> dict[str, Task]:
    """The paper's tasks, each with its nearest-neighbor queries an evaluation as the cost."""
    dense = len(problem.source_dense) + len(problem.target_dense)
    pose, rotation = pyemtr.TaskAlpha(problem).bounds, pyemtr.TaskBeta(problem).bounds
    return {
        ALPHA: Task(ALPHA, *pose.T, problem.evaluate_alpha, dense),
        BETA: Task(BETA, *rotation.T, problem.evaluate_beta, 0),
        SPARSE: Task(SPARSE, *pose.T, lambda x: problem.evaluate_alpha(x, "sparse"),
                     len(problem.source_sparse)),
    }  # fmt: skip


def budget(problem: pyemtr.Problem, kind: str) -> int:
    """Queries of a run: those of EMTR-SSC by the paper's formula, or those of as many evaluations
    on the dense clouds as it makes in all."""
    sparse = len(problem.source_sparse)
    dense = len(problem.source_dense) + len(problem.target_dense)
    evaluations = POPULATION * ITERATIONS
    if kind == EQUAL_EVALUATIONS:
        return evaluations * dense
    return int(evaluations * (SWITCH * sparse + (1.0 - SWITCH) * dense))


def evolve(pair: Pair, index: int, seed: int, threads: int, method: Method, kind: str
           ) -> dict[str, Any]:  # fmt: skip
    """One run of a method, with its errors and costs."""
    case, problem = moved_pair(pair, index), clouds(pair, index, threads)
    own = tasks(problem)
    run = Problem([own[name] for name in method.tasks], budget(problem, kind), MOST_EVALUATIONS)
    optimise = method.load()
    rng = np.random.Generator(np.random.Philox(seed))
    start = time.process_time()
    optimise(run, rng)
    seconds = time.process_time() - start
    alpha = run.tasks[0]
    points = alpha.cost
    best = alpha.best_genes
    found = errors(case, problem, best) if best is not None else {"E_R": np.nan, "E_t": np.nan}
    T = None if best is None else problem.to_transformation(best).tolist()
    return {
        **found, "T": T, "cpu_search": seconds, "queries": run.used, "evaluations": run.evaluations,
        "fitness": alpha.best_fitness / points,
        "history": [[used, value / points] for used, value in alpha.history],
    }  # fmt: skip


def evolve_emtr(
    pair: Pair, index: int, seed: int, threads: int, settings: emtr_ssc.Settings
) -> dict[str, Any]:
    """EMTR-SSC in Python: the errors of its alpha, and of its beta's rotation completed by a
    translation."""
    case, problem = moved_pair(pair, index), clouds(pair, index, threads)
    own = tasks(problem)
    run = Problem(
        [own[ALPHA], own[BETA], own[SPARSE]], 2 * budget(problem, EQUAL_EVALUATIONS),
        MOST_EVALUATIONS, problem.complement,
    )  # fmt: skip
    rng = np.random.Generator(np.random.Philox(seed))
    start = time.process_time()
    emtr_ssc.optimise_with(run, rng, settings)
    seconds = time.process_time() - start
    alpha, rotation = own[ALPHA].best_genes, own[BETA].best_genes
    assert alpha is not None and rotation is not None
    completed = np.concatenate([rotation, problem.complement(rotation)])
    beta = errors(case, problem, completed)
    return {
        **errors(case, problem, alpha), "E_R_beta": beta["E_R"], "E_t_beta": beta["E_t"],
        "cpu_search": seconds, "queries": run.used,
        "fitness": own[ALPHA].best_fitness / own[ALPHA].cost,
        "history": [[used, value / own[ALPHA].cost] for used, value in own[ALPHA].history],
    }  # fmt: skip


def errors(case: Moved, problem: pyemtr.Problem, genes: Array) -> dict[str, float]:
    """E_R in degrees and E_t in the normalized frame of a particle of task alpha."""
    rotation, translation = pose_errors(case, problem.to_transformation(genes))
    return {"E_R": rotation, "E_t": translation}


def register(pair: Pair, index: int, seed: int, threads: int, preset: str, settings: dict[str, Any]
             ) -> dict[str, Any]:  # fmt: skip
    """One run of the library itself."""
    case = moved_pair(pair, index)
    start, before = time.perf_counter(), time.process_time()
    problem = pyemtr.Problem(
        case.source, case.target, preset=preset, seed=seed, threads=threads, **settings
    )
    described = time.process_time()
    found = problem.solve()
    after = time.process_time()
    rotation, translation = pose_errors(case, found.transformation)
    return {
        "E_R": rotation, "E_t": translation, "seconds": time.perf_counter() - start,
        "cpu": after - before, "cpu_search": after - described,
        "queries": found.queries["evaluation"], "registered": found.registered,
        "T": found.transformation.tolist(),
    }  # fmt: skip
