"""Sums runs up: a row a method, and each of our presets against each peer pair by pair."""

from __future__ import annotations

import math
import statistics
from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple

from ..summary import percent
from .methods import OURS
from .runs import PeerRun


class Quartiles(NamedTuple):
    """NaN where there is nothing to sum up."""

    low: float
    median: float
    high: float


@dataclass(frozen=True)
class MethodRow:
    method: str
    runs: int
    lost: int  # runs that gave no pose: crashed, timed out, raised
    success: float  # percent of runs, lost ones among the failures
    mean_rotation: float  # degrees, over successes, as all errors
    median_rotation: float
    mean_translation: float  # normalized frame
    median_translation: float
    seconds: Quartiles  # wall, of runs that gave a pose


@dataclass(frozen=True)
class Ratio:
    """Our seconds divided by the peer's, over the runs in which both gave a pose."""

    ours: str
    peer: str
    runs: int
    times: Quartiles


def method_rows(runs: list[PeerRun]) -> list[MethodRow]:
    return [_row(method, [r for r in runs if r.method == method]) for method in names(runs)]


def ratios(runs: list[PeerRun]) -> list[Ratio]:
    seconds = {(r.method, r.pair.name, r.index): r.seconds for r in runs if not r.error}
    cases = list(dict.fromkeys((r.pair.name, r.index) for r in runs))
    found = []
    for ours in (name for name in names(runs) if name.startswith(OURS)):
        for peer in (name for name in names(runs) if not name.startswith(OURS)):
            pairs = [(seconds.get((ours, *c)), seconds.get((peer, *c))) for c in cases]
            both = [a / b for a, b in pairs if a is not None and b is not None]
            found.append(Ratio(ours, peer, len(both), quartiles(both)))
    return found


def names(runs: Iterable[PeerRun]) -> list[str]:
    return list(dict.fromkeys(run.method for run in runs))


def quartiles(values: list[float]) -> Quartiles:
    if not values:
        return Quartiles(math.nan, math.nan, math.nan)
    if len(values) == 1:
        return Quartiles(values[0], values[0], values[0])
    return Quartiles(*statistics.quantiles(values, n=4, method="inclusive"))


def _row(method: str, runs: list[PeerRun]) -> MethodRow:
    good = [run for run in runs if run.success]
    rotations, translations = [r.rotation for r in good], [r.translation for r in good]
    return MethodRow(
        method,
        len(runs),
        sum(1 for run in runs if run.error),
        percent(run.success for run in runs),
        statistics.fmean(rotations) if good else math.nan,
        statistics.median(rotations) if good else math.nan,
        statistics.fmean(translations) if good else math.nan,
        statistics.median(translations) if good else math.nan,
        quartiles([run.seconds for run in runs if not run.error]),
    )
