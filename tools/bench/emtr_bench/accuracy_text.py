"""The table for people: one line a pair, ours beside the paper's, at most 160 columns."""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Iterable

from . import paper_tables
from .paper_tables import Spread
from .protocol import CLASSES
from .runner import Run
from .summary import NOTHING, Figures, PairSummary, mean, percent

#: Column widths; texts are left-aligned, figures right-aligned.
_WIDTHS = (27, 10, 6, 7, 6, 8, 12, 12, 12, 12, 7, 7, 7, 7, 7, 6, 6)
#: Title over the columns first to last.
_GROUPS = (
    (5, 7, "E_R, degrees"),
    (8, 9, "E_t x 100"),
    (10, 12, "queries, millions"),
    (14, 16, "verdict"),
)
_HEADS = (
    "pair", "row", "succ%", "joint%", "+alt%", "median", "mean±std", "paper", "mean±std", "paper",
    "eval", "other", "paper", "sec", "prec%", "rec%", "conf%",
)  # fmt: skip


def header() -> str:
    return "\n".join((_group_line(), _line(_HEADS), rule()))


def rule() -> str:
    return "-" * len(_line(_HEADS))


def row(summary: PairSummary) -> str:
    paper = summary.paper
    return _figures_line(
        summary.name,
        paper_tables.short_name(summary.paper_row),
        summary.figures,
        paper.rotation if paper else NOTHING,
        paper.translation if paper else NOTHING,
        paper.queries if paper else math.nan,
    )


def mean_rows(title: str, figures: Figures, rows: list[PairSummary]) -> str:
    """The mean over rows and, where each row has a published one, the paper's mean below it."""
    lines = [_figures_line(title, f"{len(rows)} pairs", figures, NOTHING, NOTHING, math.nan)]
    published = [row.paper for row in rows if row.paper]
    if len(published) == len(rows):
        rotation = Spread(*(mean(p.rotation[i] for p in published) for i in (0, 1)))
        translation = Spread(*(mean(p.translation[i] for p in published) for i in (0, 1)))
        queries = mean(p.queries for p in published)
        cells = ["  the paper's", f"{len(published)} rows", _number(paper_tables.MEAN_SUCCESS, 1)]
        cells += ["", "", "", "", _spread(rotation), "", _spread(translation), "", ""]
        cells += [_number(queries, 2), _number(paper_tables.MEAN_SECONDS, 2), "", "", ""]
        lines.append(_line(cells))
    return "\n".join(lines)


def footer(runs: list[Run], rows: list[PairSummary], average: Figures) -> str:
    lowest = min(rows, key=lambda row: row.figures.success)
    by_class = (f"{kind} {_class_success(runs, kind)}" for kind in CLASSES)
    lines = [
        f"lowest row: {lowest.name} {lowest.figures.success:.1f} % "
        f"(the paper's lowest: {paper_tables.LOWEST_SUCCESS:g} %)",
        "success: E_R < 5 degrees; joint: E_t < 0.06 too. Errors are over successes, E_t in the "
        "normalized frame.",
        "Queries (other: at the switch and of the complement) and seconds: means over runs.",
        f"right, or ambiguous with the truth among the alternatives (+alt%): "
        f"{_number(average.joint_or_among, 1)} %",
        f"verdict over all runs: precision {_number(average.precision, 1)} %, recall "
        f"{_number(average.recall, 1)} %, area under the ROC curve of the confidence "
        f"{_number(average.auc, 3)}",
        "joint success by class of motion: " + ", ".join(by_class),
        _reasons(runs),
    ]
    scales = [run.scale for run in runs if run.scale > 0 and run.success]
    if scales:
        within = [sum(error < most for error in scales) for most in (0.01, 0.03)]
        median = 100 * statistics.median(scales)
        lines.append(
            f"scale where the rotation is right: within 1 % in {within[0]}, within 3 % in "
            f"{within[1]} of {len(scales)} runs; median error {median:.3f} %"
        )
    crashed = [run for run in runs if run.error]
    if crashed:
        lines.append(f"CRASHED: {len(crashed)} runs; the first, {_name(crashed[0])}:")
        lines.append(crashed[0].error)
    return "\n".join(lines)


def marks(rows: list[PairSummary]) -> list[str]:
    """Names what is below the paper's mean and lowest success; empty when nothing is."""
    missed = []
    average = mean(row.figures.success for row in rows)
    if average < paper_tables.MEAN_SUCCESS:
        missed.append(f"mean success {average:.1f} % < {paper_tables.MEAN_SUCCESS} %")
    for row in rows:
        if row.figures.success < paper_tables.LOWEST_SUCCESS:
            missed.append(
                f"{row.name} {row.figures.success:.1f} % < {paper_tables.LOWEST_SUCCESS:g} %"
            )
    return missed


def failures(runs: Iterable[Run], fitness: Callable[[Run], tuple[float, float]]) -> str:
    """A line for each run that is no joint success: who failed, the search or the objective.

    `fitness` gives task alpha's fitness of the true and of the estimated pose, lower is better.
    """
    lines = []
    for run in runs:
        if run.joint or run.outcome is None or math.isnan(run.rotation):
            continue
        true, found = fitness(run)
        blame = "search" if true < found else "objective"
        q = run.outcome.quality
        lines.append(
            f"  {_name(run)} {run.kind}: E_R {run.rotation:.2f}, E_t {run.translation:.3f}, "
            f"{run.outcome.reason}, gap {q['fitness_gap']:.3f}, inliers "
            f"{q['inlier_ratio_source']:.2f}/{q['inlier_ratio_target']:.2f}, "
            f"fitness {found:.4f}, of the true pose {true:.4f}: {blame}"
        )
    return "\n".join(["failures:", *lines]) if lines else "failures: none"


def _figures_line(
    name: str, short: str, f: Figures, rotation: Spread, translation: Spread, queries: float
) -> str:
    cells = [name, short, _number(f.success, 1), _number(f.joint, 1)]
    cells += [_number(f.joint_or_among, 1), _number(f.median_rotation, 3)]
    cells += [_spread(f.rotation), _spread(rotation)]
    cells += [_spread(f.translation), _spread(translation)]
    other = f.switch + f.complement
    cells += [_number(v, 2) for v in (f.evaluation, other, queries, f.seconds)]
    cells += [_number(v, 1) for v in (f.precision, f.recall, 100.0 * f.confidence)]
    return _line(cells)


def _line(cells: Iterable[str]) -> str:
    aligned = [
        f"{cell:<{width}}" if i < 2 else f"{cell:>{width}}"
        for i, (cell, width) in enumerate(zip(cells, _WIDTHS))
    ]
    # No blank between columns: each width holds one, and 160 columns are soon full.
    return "".join(aligned).rstrip()


def _group_line() -> str:
    line = ""
    for first, last, title in _GROUPS:
        line = line.ljust(sum(_WIDTHS[:first]) + 2)  # a figure's own blank, and one to spare
        line += f" {title} ".center(sum(_WIDTHS[first : last + 1]) - 2, "-")
    return line


def _number(value: float, digits: int) -> str:
    return "-" if math.isnan(value) else f"{value:.{digits}f}"


def _spread(value: Spread) -> str:
    if math.isnan(value.mean):
        return "-"
    digits = 3 if max(value) < 10.0 else 2 if max(value) < 100.0 else 0
    return f"{value.mean:.{digits}f}±{value.std:.{digits}f}"


def _class_success(runs: list[Run], kind: str) -> str:
    share = percent(run.joint for run in runs if run.kind == kind)
    return "-" if math.isnan(share) else f"{share:.0f} %"


def _reasons(runs: list[Run]) -> str:
    """Counts the library's reasons, for right and wrong poses apart."""
    counts: dict[str, list[int]] = {}
    for run in runs:
        if run.outcome is not None:
            counts.setdefault(run.outcome.reason, [0, 0])[run.joint] += 1
    parts = (f"{reason} {right} right, {wrong} wrong" for reason, (wrong, right) in counts.items())
    return "the library's verdicts: " + "; ".join(parts)


def _name(run: Run) -> str:
    return f"{run.pair.name}[{run.index}] seed {run.seed}"
