"""Latency of a stop in each stage of a large registration."""

from __future__ import annotations

import argparse
import time
from typing import Any

from .overshoot import Register, after_limit, after_signal
from .scaling import STAGES

BY = {"limit": after_limit, "signal": after_signal}


class Watcher:
    """A callback that notes the longest silence of each stage, and may stop the run."""

    def __init__(self, stage: str = "", after: float = 0.0) -> None:
        self.silence = dict.fromkeys(STAGES, 0.0)
        self.asked = dict.fromkeys(STAGES, 0)
        self.told = 0.0
        self._stop_in, self._after = stage, after
        self._entered = self._last = 0.0
        self._stage = ""

    def __call__(self, progress: Any) -> bool:
        now = time.perf_counter()
        if self._stage:
            self.silence[self._stage] = max(self.silence[self._stage], now - self._last)
        if progress.stage != self._stage:
            self._stage, self._entered = progress.stage, now
        self.asked[self._stage] += 1
        stop = self._stage == self._stop_in and now - self._entered >= self._after
        self._last = time.perf_counter()
        if stop:
            self.told = self._last
        return stop


def latencies(arguments: argparse.Namespace) -> int:
    import pyemtr

    from .bumpy_ball import ball_pair

    pair = ball_pair(arguments.points, 1)

    def register(watcher: Watcher | None = None, **settings: Any) -> pyemtr.Result:
        return pyemtr.register(
            pair.source,
            pair.target,
            preset="thorough",
            threads=arguments.threads,
            callback=watcher,
            **settings,
        )

    whole = Watcher()
    result = register(whole)
    print(f"{arguments.points} points a cloud, {result.threads} threads, {result.kernel}, ms:\n")
    if arguments.by == "callback":
        worst = by_callback(register, whole, result, arguments.stops)
    else:
        worst = by_clock(register, arguments.by, result, arguments.stops)
    print(f"\nworst: {1e3 * worst:.1f} ms")
    return 0


def by_callback(register: Register, whole: Watcher, result: Any, stops: int) -> float:
    """Prints a row a stage; the worst, in seconds."""
    print(f"{'stage':12} {'lasts':>8} {'asked':>6} {'silence':>8} {'to end':>8} {'in all':>8}")
    worst = 0.0
    for stage in STAGES:
        to_end, silence = 0.0, whole.silence[stage]
        for stop in range(stops):
            watcher = Watcher(stage, result.timings[stage] * stop / stops)
            stopped = register(watcher)
            end = time.perf_counter()
            if not watcher.told:  # the stage was over sooner this time
                continue
            if stopped.reason != "interrupted":
                raise AssertionError(f"{stage}: told to stop, and the reason is {stopped.reason}")
            to_end = max(to_end, end - watcher.told)
            silence = max(silence, watcher.silence[stage])
        worst = max(worst, silence + to_end)
        row = (result.timings[stage], silence, to_end, silence + to_end)
        lasts, *rest = (f"{1e3 * seconds:8.1f}" for seconds in row)
        print(f"{stage:12} {lasts} {whole.asked[stage]:6} {' '.join(rest)}")
    return worst


def by_clock(register: Register, by: str, result: Any, stops: int) -> float:
    """Prints a row a stage, as the undisturbed run went; the worst, in seconds."""
    print(f"{'stage':12} {'lasts':>8} {'ended':>6} {'after':>8}")
    begin = worst = 0.0
    for stage in STAGES:
        lasts = result.timings[stage]
        moments = [begin + lasts * (stop + 0.5) / stops for stop in range(stops)]
        ended = [after for at in moments if (after := BY[by](register, at)) is not None]
        longest = max(ended, default=0.0)
        worst, begin = max(worst, longest), begin + lasts
        print(f"{stage:12} {1e3 * lasts:8.1f} {len(ended):6} {1e3 * longest:8.1f}")
    return worst
