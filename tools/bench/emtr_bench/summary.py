"""Sums runs up: one row a pair, and the mean over rows."""

from __future__ import annotations

import math
import statistics
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from .paper_tables import PaperRow, Spread, row_of
from .runner import Run

NOTHING = Spread(math.nan, math.nan)


@dataclass(frozen=True)
class Figures:
    """The figures of a table row; NaN for a mean of nothing."""

    success: float  # percent, E_R < 5 degrees: the paper's
    joint: float  # percent, E_t < 0.06 too
    median_rotation: float  # degrees, of successes, as all errors
    rotation: Spread  # degrees
    translation: Spread  # x 100, normalized frame
    evaluation: float  # queries in millions, mean over runs
    switch: float
    complement: float
    seconds: float  # wall, mean over runs
    precision: float  # percent of runs called registered that are joint successes
    recall: float  # percent of joint successes that were called registered
    joint_or_among: float  # percent, joint, or ambiguous with the truth among the alternatives
    confidence: float  # mean over runs that have one
    auc: float  # chance that a joint success has more confidence than another run


@dataclass(frozen=True)
class PairSummary:
    name: str
    tier: str
    paper_row: str
    runs: int
    crashed: int
    figures: Figures
    paper: PaperRow | None


def summarise(runs: list[Run]) -> PairSummary:
    """The row of one pair; all its runs, at least one."""
    pair = runs[0].pair
    return PairSummary(
        pair.name,
        pair.tier,
        pair.paper_row,
        len(runs),
        sum(1 for run in runs if run.error),
        figures(runs),
        row_of(pair.paper_row),
    )


def figures(runs: list[Run]) -> Figures:
    good = [run for run in runs if run.success]
    done = [run.outcome for run in runs if run.outcome is not None]
    precision, recall = verdict(runs)
    return Figures(
        success=percent(run.success for run in runs),
        joint=percent(run.joint for run in runs),
        median_rotation=statistics.median(r.rotation for r in good) if good else math.nan,
        rotation=spread([run.rotation for run in good]),
        translation=spread([100.0 * run.translation for run in good]),
        evaluation=mean(o.queries["evaluation"] / 1e6 for o in done),
        switch=mean(o.queries["switch"] / 1e6 for o in done),
        complement=mean(o.queries["complement"] / 1e6 for o in done),
        seconds=mean(run.wall for run in runs if not run.error),
        precision=precision,
        recall=recall,
        joint_or_among=percent(run.joint_or_among for run in runs),
        confidence=mean(c for run in runs if not math.isnan(c := run.confidence)),
        auc=auc(runs),
    )


class Judged(Protocol):
    """The parts of a run that are used here; NaN is no confidence."""

    @property
    def confidence(self) -> float: ...
    @property
    def joint(self) -> bool: ...
    @property
    def registered(self) -> bool: ...


def verdict(runs: Iterable[Judged]) -> tuple[float, float]:
    """Precision and recall of `registered` against joint success, in percent."""
    runs = list(runs)
    precision = percent(run.joint for run in runs if run.registered)
    recall = percent(run.registered for run in runs if run.joint)
    return precision, recall


def auc(runs: Iterable[Judged]) -> float:
    """Area under the ROC curve of the confidence, 0.5 for one that knows nothing: the chance that
    a right run has more of it than a wrong one, ties half. NaN without both kinds."""
    known = [run for run in runs if not math.isnan(run.confidence)]
    right = np.array([run.confidence for run in known if run.joint])
    wrong = np.sort([run.confidence for run in known if not run.joint])
    if not len(right) or not len(wrong):
        return math.nan
    below = [np.searchsorted(wrong, right, side) for side in ("left", "right")]
    return float(np.mean(below)) / len(wrong)


def mean_figures(rows: list[PairSummary], runs: Iterable[Run]) -> Figures:
    """The mean over rows, each pair with the same weight, leaving out what is NaN; the
    verdict is counted over all runs, for a pair alone may have none to judge it by."""
    runs = list(runs)

    def single(name: str) -> float:
        return mean(v for r in rows if not math.isnan(v := getattr(r.figures, name)))

    def double(name: str) -> Spread:
        known = [s for r in rows if not math.isnan((s := getattr(r.figures, name)).mean)]
        return Spread(mean(s.mean for s in known), mean(s.std for s in known))

    precision, recall = verdict(runs)
    return Figures(
        success=single("success"),
        joint=single("joint"),
        median_rotation=single("median_rotation"),
        rotation=double("rotation"),
        translation=double("translation"),
        evaluation=single("evaluation"),
        switch=single("switch"),
        complement=single("complement"),
        seconds=single("seconds"),
        precision=precision,
        recall=recall,
        joint_or_among=single("joint_or_among"),
        confidence=single("confidence"),
        auc=auc(runs),
    )


def mean(values: Iterable[float]) -> float:
    values = list(values)
    return statistics.fmean(values) if values else math.nan


def percent(flags: Iterable[bool]) -> float:
    return 100.0 * mean(float(flag) for flag in flags)


def spread(values: list[float]) -> Spread:
    """Mean and standard deviation (of the sample; 0 for one value)."""
    if not values:
        return NOTHING
    return Spread(statistics.fmean(values), statistics.stdev(values) if len(values) > 1 else 0.0)
