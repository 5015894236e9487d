"""The tables of what is no pair of the paper's: ModelNet40, readings, functions."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from . import precision, published
from .figures_of_runs import chosen, mean, mean_over_pairs, percent, spread, success
from .modelnet import CLEAN, MADE_NAME, NOISY
from .run_log import Record
from .table import Cell, Table
from .tables import first_motions

Records = Sequence[Record]


def modelnet(records: Records) -> Table | None:
    mine = chosen(records, "modelnet")
    if not mine:
        return None
    made = any(r["pair"].startswith(MADE_NAME) for r in mine)
    table = Table(
        "modelnet40", "ModelNet40" + (", on made shapes" if made else ""),
        ["method", "clean E_R", "clean E_t", "noisy E_R", "noisy E_t", "success clean, %",
         "success noisy, %", "shapes"],
        notes=["The learning methods' figures are cited from the paper and were not run. Success: "
               "E_R below 5 degrees. "
               + ("The shapes are made and not ModelNet40's: ours cannot be compared with the "
                  "paper's figures, and show the protocol. " if made else "")
               + "A shape that looks the same after a rotation has no one right pose."],
    )  # fmt: skip
    for row in published.table("modelnet40"):
        cited = [published.read(text) for text in list(row.values())[1:]]
        digits = (3, 4, 3, 4, 2, 2)
        table.rows.append((f"{row['method']} (cited)", [
            *(Cell(None, value, d) for value, d in zip(cited, digits)), Cell(None)]))  # fmt: skip
    for preset in dict.fromkeys(r["method"].partition(", ")[0] for r in mine):
        kinds = [chosen(mine, "modelnet", f"{preset}, {kind}") for kind in (CLEAN, NOISY)]
        rates = [Cell(percent(runs), digits=2) for runs in kinds]
        for name, kept in (("all", list), ("successful", lambda r: [x for x in r if success(x)])):
            parts = [kept(runs) for runs in kinds]
            cells = [Cell(mean(p, column), digits=d) for p in parts
                     for column, d in (("E_R", 3), ("E_t", 5))]  # fmt: skip
            table.rows.append((f"emtr {preset}, {name}", [
                *cells, *(rates if name == "all" else [Cell(None), Cell(None)]),
                Cell(str(len(kinds[0])))]))  # fmt: skip
    return table


def readings(records: Records) -> Table | None:
    mine = chosen(records, "precision")
    if not mine:
        return None
    paper = [published.value("sparse_to_dense", row, "E_R_with")
             for row in dict.fromkeys(r["row"] for r in mine)]  # fmt: skip
    known = [value.mean for value in paper if value is not None]
    table = Table(
        "precision", "Readings of what the paper leaves open",
        ["reading", "success %", "mean E_R", "mean E_t x 100", "million queries", "runs"],
        notes=["Each pair has the same weight. A search is a run of preset `paper` with this "
               "change. An optimum is where the fitness function itself is best near the true "
               "pose: where a search ends that converges. The published mean is that of the same "
               "rows. " + first_motions("precision")],
    )  # fmt: skip
    for name in precision.METHODS:
        runs = chosen(mine, "precision", name)
        if runs:
            errors = [mean_over_pairs(runs, lambda r, c=c, f=f: _mean(r, c, f))
                      for c, f in (("E_R", 1.0), ("E_t", 100.0))]  # fmt: skip
            first = name == "search: as it is" and known
            table.rows.append((name, [
                Cell(mean_over_pairs(runs, percent), digits=1),
                Cell(errors[0], float(np.mean(known)) if first else None), Cell(errors[1]),
                Cell(mean(runs, "queries", 1e-6) if name.startswith("search") else None, digits=2),
                Cell(str(len(runs)))]))  # fmt: skip
    return table


def functions(records: Records) -> Table | None:
    mine = chosen(records, "functions")
    if not mine:
        return None
    names = list(dict.fromkeys(r["pair"] for r in mine))
    table = Table(
        "functions", "The methods on functions with known optima",
        ["method", *names],
        notes=["The median of the best value after 10 000 evaluations a task; every optimum is 0. "
               "Sphere and Rastrigin have 10 dimensions; the pairs are Ackley, which counts, with "
               "Griewank beside it, and say where the second optimum is. Single-task methods have "
               "Ackley alone, and those of a public library one pair of tasks."],
    )  # fmt: skip
    for method in dict.fromkeys(r["method"] for r in mine):
        cells = []
        for name in names:
            values = [r["value"] for r in chosen(mine, "functions", method, name)]
            cells.append(Cell(f"{np.median(values):.2g}" if values else None))
        table.rows.append((method, cells))
    return table


def _mean(runs: Records, column: str, factor: float) -> float:
    found = spread(runs, column, factor)
    return float("nan") if found is None else found.mean


ALL = (modelnet, readings, functions)
