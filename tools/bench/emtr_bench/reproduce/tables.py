"""The paper's tables from the log of runs, with its figures beside ours.

Each function gives a table, or None where its runs are not in the log.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from evolving_methods.methods import CONTROLS, METHODS

from . import plan, published, success_tables, sweep
from .figures_of_runs import chosen, mean, mean_over_pairs, pair_rows, percent, spread
from .run_log import Record
from .table import Cell, Table

Records = Sequence[Record]
TRADITIONAL = ("ICP+", "NDT+", "TrICP+", "FGR")


def first_motions(section: str) -> str:
    """What a table says of a section that does not have all motions."""
    return (
        f"The first {plan.MOST_MOTIONS[section]} motions of each pair, one of each kind, at most."
    )


def alpha_beta(records: Records) -> Table | None:
    """Errors of alpha against those of beta, whose rotation is completed by Algorithm 2."""
    mine = chosen(records, "tasks", plan.PYTHON)
    if not mine:
        return None
    table = Table(
        "errors_alpha_beta", "Errors of task alpha against task beta",
        ["data", "E_R beta", "E_R alpha", "E_t x 100 beta", "E_t x 100 alpha", "runs"],
        notes=["By EMTR-SSC in Python, because the library does not report its best rotation of "
               "beta. Means and standard deviations over the runs in which alpha succeeds."],
    )  # fmt: skip
    for pair, row in pair_rows(mine).items():
        runs = chosen(mine, "tasks", plan.PYTHON, pair)
        cells = [
            Cell(spread(runs, ours, factor), published.value("errors_alpha_beta", row, paper))
            for ours, factor, paper in (
                ("E_R_beta", 1.0, "E_R_beta"), ("E_R", 1.0, "E_R_alpha"),
                ("E_t_beta", 100.0, "E_t_x100_beta"), ("E_t", 100.0, "E_t_x100_alpha"))
        ]  # fmt: skip
        table.rows.append((row, [*cells, Cell(str(len(runs)))]))
    return table


def traditional(records: Records) -> Table | None:
    mine = chosen(records, "traditional")
    if not mine:
        return None
    table = Table(
        "errors_vs_traditional", "Errors against the traditional methods",
        ["data", "metric", *TRADITIONAL, plan.OURS],
        notes=["Means over the successes (E_R below 5 degrees), with the number of successes in "
               "percent in the rows of E_R < 5. A dash: no run succeeded; blank: not run. "
               + first_motions("traditional")],
    )  # fmt: skip
    indices = {r["index"] for r in mine}
    for pair, row in pair_rows(mine).items():
        both = [*mine, *chosen(records, "library", plan.OURS)]
        runs = {name: [r for r in both if r["pair"] == pair and r["method"] == name
                       and r["index"] in indices]
                for name in (*TRADITIONAL, plan.OURS)}  # fmt: skip
        for metric, column, factor in (("E_R_deg", "E_R", 1.0), ("E_t_x100", "E_t", 100.0)):
            cells = [
                Cell((spread(r, column, factor) or "-") if r else None,
                     published.value("errors_vs_traditional", row, name, metric=metric))
                for name, r in runs.items()
            ]  # fmt: skip
            table.rows.append((row, [Cell(metric), *cells]))
        table.rows.append((row, [Cell("E_R < 5, %"), *(Cell(percent(r), digits=1)
                                                      for r in runs.values())]))  # fmt: skip
    return table


def sparse_to_dense(records: Records) -> Table | None:
    with_it, without = (chosen(records, "library", n) for n in (plan.OURS, plan.DENSE_ONLY))
    if not with_it or not without:
        return None
    table = Table(
        "sparse_to_dense", "Sparse-to-dense on and off",
        ["data", "E_R with", "E_R without", "E_t x 100 with", "E_t x 100 without",
         "million queries with", "without", "ratio, %"],
    )  # fmt: skip
    ratios = []
    for pair, row in pair_rows(with_it).items():
        a, b = ([r for r in runs if r["pair"] == pair] for runs in (with_it, without))
        cells = [
            Cell(spread(runs, column, factor),
                 published.value("sparse_to_dense", row, f"{paper}_{suffix}"))
            for column, factor, paper in (("E_R", 1.0, "E_R"), ("E_t", 100.0, "E_t_x100"))
            for runs, suffix in ((a, "with"), (b, "without"))
        ]  # fmt: skip
        counts = mean(a, "queries", 1e-6), mean(b, "queries", 1e-6)
        ratios.append(100.0 * counts[0] / counts[1])
        cells += [
            Cell(value, published.value("sparse_to_dense", row, column), digits)
            for value, column, digits in ((counts[0], "NN_with", 2), (counts[1], "NN_without", 2),
                                          (ratios[-1], "ratio", 1))
        ]  # fmt: skip
        table.rows.append((row, cells))
    return table


def run_time(records: Records) -> Table | None:
    """Seconds of a run; the machine's, so that only the ratios can be compared."""
    ours = chosen(records, "library", plan.OURS)
    if not ours:
        return None
    unit = mean(ours, "cpu_search")
    paper_unit = published.value("run_time", plan.OURS, "average_seconds")
    table = Table(
        "run_time", "Run time",
        ["method", "CPU seconds of the search", "over those of EMTR-SSC"],
        notes=["CPU seconds, without the clouds' preprocessing, which all methods share. The "
               "other methods are Python over batched fitness and have EMTR-SSC's number of "
               "evaluations; their overhead counts. The paper's seconds are of another machine and "
               "of another program: only the ratios can be compared."],
    )  # fmt: skip
    rows: list[tuple[str, Records, str]] = [
        (m.name, chosen(records, "evaluations", m.name), "cpu_search") for m in METHODS
    ]
    rows += [(n, chosen(records, "library", n), "cpu_search")
             for n in (plan.DENSE_ONLY, plan.OURS)]  # fmt: skip
    for name, runs, column in rows:
        if not runs:
            continue
        seconds = mean(runs, column)
        paper = published.value("run_time", name, "average_seconds")
        ratio = None if paper is None or paper_unit is None else paper.mean / paper_unit.mean
        table.rows.append((name, [Cell(seconds, paper), Cell(seconds / unit, ratio, 2)]))
    return table


def presets(records: Records) -> Table | None:
    """Beyond the paper: the library's presets, and the method with parts off."""
    names = [n for n in plan.LIBRARY if chosen(records, "library", n)]
    if not names:
        return None
    table = Table(
        "presets", "Parts off, and the other presets",
        ["what runs", "success %", "E_R of the successes", "E_t x 100", "CPU seconds, all"],
    )  # fmt: skip
    paper = {plan.OURS: published.value("success_ratio", plan.OURS,
                                        "average_success_ratio_percent")}  # fmt: skip
    for name in names:
        runs = chosen(records, "library", name)
        table.rows.append((name, [
            Cell(mean_over_pairs(runs, percent), paper.get(name), 1), Cell(spread(runs, "E_R")),
            Cell(spread(runs, "E_t", 100.0)), Cell(mean(runs, "cpu"))]))  # fmt: skip
    return table


def errors_by_preset(records: Records) -> Table | None:
    """E_R of each pair by preset, beside the paper's."""
    names = [n for n in (plan.OURS, plan.DEFAULT, plan.FAST) if chosen(records, "library", n)]
    if not names:
        return None
    table = Table("errors_by_preset", "E_R of each pair by preset, degrees", ["data", *names])
    for pair, row in pair_rows(chosen(records, "library")).items():
        paper = published.value("sparse_to_dense", row, "E_R_with")
        cells = [Cell(spread(chosen(records, "library", n, pair), "E_R"),
                      paper if n == plan.OURS else None) for n in names]  # fmt: skip
        table.rows.append((row, cells))
    return table


def is_control(name: str) -> bool:
    return any(name == method.name for method in CONTROLS)


ALL: tuple[Callable[[Records], Table | None], ...] = (
    *success_tables.ALL, alpha_beta, traditional, sparse_to_dense, run_time, presets,
    errors_by_preset, sweep.table,
)  # fmt: skip


def made(records: Records) -> list[Table]:
    return [table for make in ALL if (table := make(records)) is not None]


def lower_in(table: Table, column: int) -> tuple[int, int]:
    """In how many rows ours is lower than the paper's, of those that have both."""
    both = [(cells[column].ours, cells[column].paper) for _, cells in table.rows]
    values = [(getattr(a, "mean", a), getattr(b, "mean", b)) for a, b in both if a and b]
    return sum(a < b for a, b in values), sum(not math.isnan(a) for a, _ in values)
