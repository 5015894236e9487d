"""The tables for people, one of each kind a tier."""

from __future__ import annotations

import math

from .runs import PeerRun
from .summary import MethodRow, Quartiles, Ratio, method_rows, ratios

_METHOD = "{:<30}{:>5}{:>6}{:>10}{:>9}{:>9}{:>9}{:>9}{:>9}{:>17}"
_RATIO = "{:<24}{:<32}{:>6}{:>9}{:>17}"
FOOTER = (
    "success: E_R < 5 degrees and E_t < 0.06 in the normalized frame; a run without a pose is a "
    "failure.\nE_R in degrees and E_t x 100 over the successes. Seconds: wall, around the call, of "
    "the runs that gave a pose.\nTime ratio: our seconds / the other's, pair by pair; below 1 "
    "ours is the faster."
)


def tier_tables(title: str, runs: list[PeerRun]) -> str:
    motions = len({(run.pair.name, run.index) for run in runs})
    pairs = len({run.pair.name for run in runs})
    lines = [f"{title}: {pairs} pairs, {motions} runs of each method", _heads()]
    lines += [_method_line(row) for row in method_rows(runs)]
    found = ratios(runs)
    if found:
        lines += ["", _RATIO.format("ours", "the other", "runs", "ratio", "quartiles")]
        lines += [_ratio_line(ratio) for ratio in found]
    return "\n".join(lines)


def lost(runs: list[PeerRun]) -> str:
    """Tells why runs gave no pose; "" when there are no such runs."""
    lines = [f"  {r.method} on {r.pair.name}[{r.index}]: {r.error}" for r in runs if r.error]
    return "\n".join(["runs without a pose:", *lines]) if lines else ""


def _heads() -> str:
    return _METHOD.format(
        "method", "runs", "lost", "success%", "E_R med", "mean", "E_t med", "mean", "seconds",
        "quartiles",
    )  # fmt: skip


def _method_line(row: MethodRow) -> str:
    return _METHOD.format(
        row.method, row.runs, row.lost, f"{row.success:.1f}",
        number(row.median_rotation), number(row.mean_rotation),
        number(100 * row.median_translation), number(100 * row.mean_translation),
        number(row.seconds.median), spread(row.seconds),
    )  # fmt: skip


def _ratio_line(ratio: Ratio) -> str:
    return _RATIO.format(
        ratio.ours, ratio.peer, ratio.runs, number(ratio.times.median, 2), spread(ratio.times, 2)
    )


def number(value: float, digits: int = 3) -> str:
    return "-" if math.isnan(value) else f"{value:.{digits}f}"


def spread(values: Quartiles, digits: int = 3) -> str:
    if math.isnan(values.median):
        return "-"
    return f"{values.low:.{digits}f}-{values.high:.{digits}f}"
