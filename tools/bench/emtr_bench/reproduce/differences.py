"""Where ours and the paper's figures differ, and what is known of the reason."""

from __future__ import annotations

import math
from collections.abc import Sequence

from ..paper_tables import short_name
from . import order, plan, precision, published
from .figures_of_runs import chosen, mean_over_pairs, percent, spread
from .published import Published
from .run_log import Record
from .table import Table
from .tables import lower_in


def text(records: Sequence[Record], tables: Sequence[Table]) -> list[str]:
    """Points of a list; what a point says is computed from the runs."""
    found = [*_data(records), *_success(records), *_precision(tables), *_readings(records)]
    found += _methods(records)
    return [f"* {point}" for point in found] or ["Nothing was run that the paper has."]


def _data(records: Sequence[Record]) -> list[str]:
    rows = {r["row"] for r in records if r["row"]}
    known = {row["data"] for row in published.table("errors_alpha_beta")}
    stand_ins = sorted(row for row in rows if short_name(row) != row)
    absent = sorted(known - {short_name(row) for row in rows})
    points = []
    if not rows:
        points.append("None of the pairs is one of the paper's, so that no cell has its figure.")
    elif absent:
        points.append(f"Not run, for want of data: the paper's rows {', '.join(absent)}.")
    if stand_ins:
        points.append(f"Other data in the place of the paper's: {', '.join(stand_ins)}.")
    points.append("The paper's own clouds and motions are not public: the pairs are the nearest "
                  "that can be had, and the motions are drawn anew by its protocol.")  # fmt: skip
    return points


def _success(records: Sequence[Record]) -> list[str]:
    ours = chosen(records, "library", plan.OURS)
    paper = published.value("success_ratio", plan.OURS, "average_success_ratio_percent")
    if not ours or paper is None:
        return []
    value = mean_over_pairs(ours, percent)
    points = [f"EMTR-SSC succeeds in {value:.1f} % of the runs, published {paper.mean:.1f} %. What "
              "the paper leaves open was settled by measurement (docs/METHOD.md): angles "
              "without bounds and the velocity limit of half a range matter most."]  # fmt: skip
    for section, budget in (("evaluations", "With as many evaluations"),
                            ("evolving", "With as many queries")):  # fmt: skip
        compared = []
        for name in dict.fromkeys(r["method"] for r in chosen(records, section)):
            theirs = mean_over_pairs(chosen(records, section, name), percent)
            known = published.value("success_ratio", name, "average_success_ratio_percent")
            if known is not None:
                compared.append((name, theirs, known.mean))
        if compared:
            ahead = sum(value > theirs for _, theirs, _ in compared)
            points.append(
                f"{budget} EMTR-SSC is ahead of {ahead} of {len(compared)} evolving methods, "
                "published: all. Ours, and the published ones in parentheses: "
                + ", ".join(f"{n} {a:.1f} ({b:.1f})" for n, a, b in compared) + " %."
            )  # fmt: skip
    points += _budgets(records)
    if chosen(records, "evolving") and not chosen(records, "evaluations"):
        points.append("The published figures of the evolving methods are most likely of the larger "
                      "budget, which was not run here (section `evaluations`).")  # fmt: skip
    points += order.text(records)
    runs = len(ours)
    points.append(f"The figures of success are of {runs} runs a method, so that one run is "
                  f"{100.0 / runs:.1f} %.")  # fmt: skip
    return points


def _budgets(records: Sequence[Record]) -> list[str]:
    """Which method the larger budget helps most."""
    gains = []
    for name in dict.fromkeys(r["method"] for r in chosen(records, "evaluations")):
        few, many = (mean_over_pairs(chosen(records, section, name), percent)
                     for section in ("evolving", "evaluations"))  # fmt: skip
        if not math.isnan(few):
            gains.append((many - few, name, few, many))
    if not gains:
        return []
    _, name, few, many = max(gains)
    return [f"The budget decides much: {name} succeeds in {few:.1f} % with EMTR-SSC's queries, and "
            f"in {many:.1f} % with its evaluations, which are twice the generations."]  # fmt: skip


def _precision(tables: Sequence[Table]) -> list[str]:
    for table in tables:
        if table.name == "sparse_to_dense":
            lower, of = lower_in(table, 0)
            if of:
                return [
                    f"The mean E_R of EMTR-SSC is below the published one in {lower} of {of} rows."
                    f"{_means_of_rows(table)} Section `precision` tries what the paper leaves open."
                ]
    return []


def _means_of_rows(table: Table) -> str:
    """The mean over the rows, all of them and those of the paper's own data."""
    both = [(row, cells[0].ours, cells[0].paper) for row, cells in table.rows]
    rows = [(row, ours.mean, paper.mean) for row, ours, paper in both
            if isinstance(ours, Published) and isinstance(paper, Published)]  # fmt: skip
    own = [values for values in rows if short_name(values[0]) == values[0]]
    said = ""
    for some, what in ((rows, "Over all rows"), (own, "without other data")):
        if some and (some is rows or len(own) < len(rows)):
            ours, paper = (sum(values[i] for values in some) / len(some) for i in (1, 2))
            said += f"{',' if said else ''} {what} it is {ours:.3f} ({paper:.3f})"
    return f"{said}." if said else ""


def _readings(records: Sequence[Record]) -> list[str]:
    """What the optima and the searches say of the errors."""
    found = {
        name: mean_over_pairs(chosen(records, "precision", name), _mean_rotation)
        for name in ("search: as it is", *precision.OPTIMA)
    }
    known = {name: value for name, value in found.items() if not math.isnan(value)}
    if len(known) < 2 or "search: as it is" not in known:
        return []
    search = known.pop("search: as it is")
    best = min(known, key=lambda name: known[name])
    own = known.get("optimum: as it is", math.nan)
    return [
        f"Precision: the search ends {search:.2f} degrees off on average, while the fitness "
        f"function itself is best {own:.2f} degrees off the true pose. The reading with the best "
        f"optimum is *{best.partition(': ')[2]}*, {known[best]:.2f} degrees."
    ]


def _mean_rotation(runs: list[Record]) -> float:
    found = spread(runs, "E_R")
    return math.nan if found is None else found.mean


def _methods(records: Sequence[Record]) -> list[str]:
    if not chosen(records, "evolving"):
        return []
    return [
        "EMFPCR is not public in all its formulas: its robust fitness is here task alpha on the "
        "sparse clouds, its precise fitness task alpha on the dense clouds, and its transfer moves "
        "the best of each swarm, one way in the first half and both ways in the second.",
        "DEORA is made for tasks whose values can be compared. Those of alpha and beta cannot: a "
        "gain is here a share of the task's own best. MTEA-AD begins with all of the other task's "
        "individuals.",
        "The multi-task methods drive task alpha on the dense clouds and task beta in one unified "
        "space. What the paper let them drive is not said.",
    ]
