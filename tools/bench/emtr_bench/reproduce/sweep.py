"""Success and errors over rmp and delta, at the end of both stages."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import pyemtr

from ..pairs import Pair
from ..runner import pose_errors
from . import cases
from .figures_of_runs import chosen, mean, percent, spread
from .run_log import Record
from .table import Cell, Table

SETTINGS = {"rmp": "transfer_probability", "delta": "switch_fraction"}


def run(method: str, pair: Pair, index: int, seed: int, threads: int) -> dict[str, Any]:
    """A run of preset `paper` with "rmp 0.3", or "delta 0.3", and the errors of gbest at the end of
    its sparse stage: the same run, stopped there."""
    name, value = method.split()
    case = cases.moved_pair(pair, index)
    problem = pyemtr.Problem(
        case.source, case.target, preset=cases.PRESET, seed=seed, threads=threads,
        **{SETTINGS[name]: float(value)},
    )  # fmt: skip
    whole = problem.solve()
    E_R, E_t = pose_errors(case, whole.transformation)
    found = {"E_R": E_R, "E_t": E_t, "queries": whole.queries["evaluation"]}
    switch = math.ceil(problem.settings["switch_fraction"] * problem.settings["iterations"] - 1e-9)
    E_R = E_t = None
    if switch > 0:
        sparse = problem.solve(lambda progress: progress.iteration == switch)
        E_R, E_t = pose_errors(case, sparse.transformation)
    return {**found, "E_R_sparse": E_R, "E_t_sparse": E_t}


def table(records: Sequence[Record]) -> Table | None:
    mine = chosen(records, "sweep")
    if not mine:
        return None
    made = Table(
        "sweep", f"Success and errors over rmp and delta, {mine[0]['row'] or mine[0]['pair']}",
        ["setting", "success %", "E_R, sparse stage", "E_R", "E_t x 100, sparse stage",
         "E_t x 100", "million queries", "runs"],
        notes=["Errors of gbest at the end of each stage, over the runs that succeed in the end."],
    )  # fmt: skip
    for name in dict.fromkeys(r["method"] for r in mine):
        runs = chosen(mine, "sweep", name)
        made.rows.append((name, [
            Cell(percent(runs), digits=1),
            Cell(spread(runs, "E_R_sparse")), Cell(spread(runs, "E_R")),
            Cell(spread(runs, "E_t_sparse", 100.0)), Cell(spread(runs, "E_t", 100.0)),
            Cell(mean(runs, "queries", 1e-6), digits=2), Cell(str(len(runs)))]))  # fmt: skip
    return made
