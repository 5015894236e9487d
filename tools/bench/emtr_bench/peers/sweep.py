"""Sums a sweep up: each method at each setting, the fastest that loses nothing, the frontier."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .methods import OURS
from .runs import PeerRun
from .settings import Setting
from .summary import MethodRow, method_rows, names


@dataclass(frozen=True)
class Point:
    """A method at one setting; emtr has none."""

    row: MethodRow
    setting: Setting | None

    @property
    def method(self) -> str:
        return self.row.method

    @property
    def success(self) -> float:
        return self.row.success

    @property
    def seconds(self) -> float:
        """The median; NaN when no run gave a pose."""
        return self.row.seconds.median

    @property
    def label(self) -> str:
        return self.method if self.setting is None else f"{self.method} {self.setting.name}"


def points(runs: Sequence[PeerRun]) -> list[Point]:
    """In the order of the methods, and of the settings of each."""
    found = []
    for method in names(runs):
        mine = [run for run in runs if run.method == method]
        for setting in dict.fromkeys(run.setting for run in mine):
            (row,) = method_rows([run for run in mine if run.setting == setting])
            found.append(Point(row, setting))
    return found


def fastest(mine: Sequence[Point], recommended: Setting) -> Point:
    """Of one method's points the fastest that has no less success than the recommended setting."""
    own = next(point for point in mine if point.setting in (recommended, None))
    good = [p for p in mine if p.success >= own.success and p.seconds == p.seconds]
    return min(good, key=lambda point: point.seconds, default=own)


def frontier(found: Sequence[Point]) -> list[Point]:
    """Those that no other beats in both success and time, the fastest first."""
    best: list[Point] = []
    known = [point for point in found if point.seconds == point.seconds]
    for point in sorted(known, key=lambda point: (point.seconds, -point.success)):
        if not best or point.success > best[-1].success:
            best.append(point)
    return best


def at_their_fastest(runs: Sequence[PeerRun], recommended: Setting) -> list[PeerRun]:
    """The runs of emtr, and of each other method those at its fastest setting."""
    found = points(runs)
    kept = {(p.method, p.setting) for m in names(runs)
            for p in [fastest([q for q in found if q.method == m], recommended)]}  # fmt: skip
    return [run for run in runs if run.method.startswith(OURS) or (run.method, run.setting) in kept]


def at_recommended(runs: Sequence[PeerRun], recommended: Setting) -> list[PeerRun]:
    return [run for run in runs if run.setting in (recommended, None)]
