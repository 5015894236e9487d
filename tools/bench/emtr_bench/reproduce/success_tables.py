"""The tables of how often the evolving methods succeed."""

from __future__ import annotations

from collections.abc import Sequence

from evolving_methods.methods import METHODS

from . import plan, published
from .figures_of_runs import chosen, mean, mean_over_pairs, pair_rows, percent
from .run_log import Record
from .table import Cell, Table

Records = Sequence[Record]


def success_ratio(records: Records) -> Table | None:
    """The average success ratio of each method over the pairs, with both budgets."""
    mine = chosen(records, "evolving")
    if not mine:
        return None
    dense = chosen(records, "evaluations")
    table = Table(
        "success_ratio", "Average success ratio of the evolving methods",
        ["method", "EMTR-SSC's queries, %", "its evaluations, %", "mean of rho found",
         "million queries", "runs"],
        notes=["Success: E_R below 5 degrees; each pair has the same weight. The first column "
               "stops a method after the nearest-neighbor queries that EMTR-SSC needs by the "
               "paper's formula. The second after as many evaluations of task alpha as EMTR-SSC "
               "makes, all on the dense clouds, which is about twice the queries and, by the "
               "paper's run times, what the paper gave them."],
    )  # fmt: skip
    ours = chosen(records, "library", plan.OURS)
    names = [method.name for method in METHODS]
    names += [r["method"] for r in mine if r["method"] not in names]
    for name in dict.fromkeys(names):
        first, second = chosen(mine, "evolving", name), chosen(dense, "evaluations", name)
        paper = published.value("success_ratio", name, "average_success_ratio_percent")
        if first or second:
            # The paper's figure stands at the budget that the paper most likely had.
            at_second = paper if second else None
            table.rows.append((name, [
                Cell(mean_over_pairs(first, percent), None if second else paper, 1),
                Cell(mean_over_pairs(second, percent), at_second, 1),
                Cell(mean(first, "fitness")), Cell(mean(first, "queries", 1e-6), digits=2),
                Cell(str(len(first) + len(second)))]))  # fmt: skip
    for name in (plan.PYTHON, plan.ADAPTIVE):
        runs = chosen(records, "tasks", name)
        if runs:
            table.rows.append((name, [Cell(mean_over_pairs(runs, percent), None, 1), Cell(None),
                                      Cell(None), Cell(mean(runs, "queries", 1e-6), digits=2),
                                      Cell(str(len(runs)))]))  # fmt: skip
    if ours:
        paper = published.value("success_ratio", plan.OURS, "average_success_ratio_percent")
        table.rows.append((f"**{plan.OURS}**", [
            Cell(mean_over_pairs(ours, percent), paper, 1), Cell(None), Cell(None),
            Cell(mean(ours, "queries", 1e-6), digits=2), Cell(str(len(ours)))]))  # fmt: skip
    return table


def success_by_pair(records: Records) -> Table | None:
    """What the bars show: success of each method on each pair, with EMTR-SSC's queries."""
    return _by_pair(
        records, "evolving", "success_by_pair", "Success by pair, EMTR-SSC's queries, %"
    )


def success_by_pair_dense(records: Records) -> Table | None:
    return _by_pair(records, "evaluations", "success_by_pair_evaluations",
                    "Success by pair, with EMTR-SSC's evaluations, %")  # fmt: skip


def _by_pair(records: Records, section: str, file: str, title: str) -> Table | None:
    mine = chosen(records, section)
    if not mine:
        return None
    ours = chosen(records, "library", plan.OURS)
    names = list(dict.fromkeys(r["method"] for r in mine))
    table = Table(file, title, ["data", *names, plan.OURS])
    for pair, row in pair_rows(mine).items():
        table.rows.append((row, [
            *(Cell(percent(chosen(mine, section, name, pair)), digits=0) for name in names),
            Cell(percent([r for r in ours if r["pair"] == pair]), digits=0)]))  # fmt: skip
    return table


ALL = (success_ratio, success_by_pair, success_by_pair_dense)
