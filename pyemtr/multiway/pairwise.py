"""Registers pairs of scans, several at a time."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from ..registration import register
from ..result import Result
from .scans import CACHED, Scans

Pair = tuple[int, int]  # source, target; source > target
_BLOCK = CACHED // 2

#: Called after each pair with the pairs that are done and those that there are; True stops.
Report = Callable[[int, int], Any]


class Stopped(Exception):
    """The callback has asked to stop."""


def register_pairs(
    scans: Scans,
    pairs: Iterable[Pair],
    threads: int,
    arguments: Mapping[str, Any],
    report: Report | None = None,
) -> dict[Pair, Result]:
    """Returns the results by pair. Each pair has one thread of the engine.

    Raises what :func:`pyemtr.register` raises, with the names of the two scans; and Stopped.
    """
    ordered = sorted(pairs, key=lambda pair: (pair[0] // _BLOCK, pair[1] // _BLOCK, pair))

    def one(pair: Pair) -> Result:
        source, target = pair
        try:
            return register(scans.cloud(source), scans.cloud(target), threads=1, **arguments)
        except ValueError as error:
            names = f"{scans.names[source]} and {scans.names[target]}"
            raise ValueError(f"{names}: {error}") from error

    results: dict[Pair, Result] = {}
    with ThreadPoolExecutor(max_workers=threads) as workers:
        jobs = [workers.submit(one, pair) for pair in ordered]
        try:
            for pair, job in zip(ordered, jobs):
                results[pair] = job.result()
                if report and report(len(results), len(ordered)):
                    raise Stopped
        except BaseException:
            for job in jobs:
                job.cancel()
            raise
    return results
