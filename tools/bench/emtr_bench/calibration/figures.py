"""Figures of the confidence, from runs with known poses."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from .. import summary
from .judged import Judged

_NORMAL_95 = 1.959963984540054  # the normal distribution's quantile of 0.975


@dataclass(frozen=True)
class Share:
    """A share with Wilson's 95 % interval; NaN of nothing."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Bin:
    """The runs with low <= confidence < high, the last one with its upper end."""

    low: float
    high: float
    count: int
    confidence: float  # mean; NaN where there is no run
    right: Share


@dataclass(frozen=True)
class Calibration:
    runs: int
    right: int
    unrelated: int  # of the runs
    bins: list[Bin]
    error: float  # expected: mean over runs of |mean confidence - share right| of their bin
    brier: float  # mean of (confidence - 1 or 0)^2; 0 is best
    auc: float  # chance that a right run has more confidence than a wrong one
    precision: Share  # of runs called registered, those that are right
    recall: Share  # of right runs, those called registered


def calibration(runs: Sequence[Judged], bins: int) -> Calibration:
    """Returns the figures of one run or more."""
    rows = [_bin(runs, index, bins) for index in range(bins)]
    gaps = [row.count * abs(row.confidence - row.right.value) for row in rows if row.count]
    registered = [run for run in runs if run.registered]
    right = [run for run in runs if run.joint]
    return Calibration(
        runs=len(runs),
        right=len(right),
        unrelated=sum(not run.related for run in runs),
        bins=rows,
        error=math.fsum(gaps) / len(runs),
        brier=summary.mean((run.confidence - run.joint) ** 2 for run in runs),
        auc=summary.auc(runs),
        precision=share(sum(run.joint for run in registered), len(registered)),
        recall=share(sum(run.registered for run in right), len(right)),
    )


def share(count: int, of: int) -> Share:
    if of == 0:
        return Share(math.nan, math.nan, math.nan)
    p, z = count / of, _NORMAL_95
    middle = (p + z * z / (2 * of)) / (1 + z * z / of)
    half = z * math.sqrt(p * (1 - p) / of + z * z / (4 * of * of)) / (1 + z * z / of)
    # Rounding must not put a share of 0 or 1 out of its own interval.
    return Share(p, min(p, max(0.0, middle - half)), max(p, min(1.0, middle + half)))


def _bin(runs: Sequence[Judged], index: int, bins: int) -> Bin:
    mine = [run for run in runs if min(int(run.confidence * bins), bins - 1) == index]
    return Bin(
        low=index / bins,
        high=(index + 1) / bins,
        count=len(mine),
        confidence=summary.mean(run.confidence for run in mine),
        right=share(sum(run.joint for run in mine), len(mine)),
    )
