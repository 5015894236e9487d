"""Pairs per second, and what a pair takes beside its registration."""

from __future__ import annotations

import csv
import pickle
import shutil
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pyemtr
from pyemtr.batch import work
from pyemtr.batch.pair_files import read_pairs

from ..bumpy_ball import ball_pair
from .executors import executor, nothing

SETTINGS: dict[str, Any] = {"preset": "fast"}


def loop(path: Path, threads: int) -> float:
    """Seconds of a plain loop over the pairs, by what a user writes first."""
    begin = time.perf_counter()
    with path.open(newline="") as file:
        for row in csv.DictReader(file):
            pyemtr.register(
                path.parent / row["source"],
                path.parent / row["target"],
                seed=int(row["seed"]),
                threads=threads,
                **SETTINGS,
            )
    return time.perf_counter() - begin


def many(path: Path, pool: Any, out: Path, chunksize: int = 1) -> float:
    """Seconds of one call of register_many() with a folder of its own."""
    shutil.rmtree(out, ignore_errors=True)
    begin = time.perf_counter()
    records = pyemtr.register_many(
        path, pool, out=out, chunksize=chunksize, progress=False, **SETTINGS
    )
    seconds = time.perf_counter() - begin
    if records.counts["error"]:
        raise AssertionError(f"{records}: no pair should have an error")
    return seconds


def compare(path: Path, pairs: int, kinds: list[str], workers: list[int], rounds: int) -> Any:
    """Prints a row for each executor, and returns the rows. Rounds are taken in turns, so that
    another program on the machine disturbs all alike."""
    calls: dict[str, Callable[[], float]] = {
        "loop, 1 thread": lambda: loop(path, 1),
        "loop, all threads": lambda: loop(path, 0),
    }
    out = path.parent / "out"
    for kind in kinds:
        for count in workers:
            calls[f"{kind}, {count}"] = _timed(kind, count, nothing, path, out)
    best = dict.fromkeys(calls, float("inf"))
    for _ in range(rounds):
        for name, call in calls.items():
            best[name] = min(best[name], call())
    print(f"{'':20} {'pairs/s':>8} {'to loop':>8}")
    for name, seconds in best.items():
        print(f"{name:20} {pairs / seconds:8.1f} {best['loop, 1 thread'] / seconds:8.2f}")
    return {name: pairs / seconds for name, seconds in best.items()}


def overhead(path: Path, pairs: int, kinds: list[str], rounds: int) -> Any:
    """Prints what a pair takes when its registration takes nothing: one worker, each kind. The CPU
    time is that of the calling process, which has Dask's scheduler too."""
    print(f"\n{'overhead a pair, ms':22} {'wall':>8} {'CPU':>8}")
    found: dict[str, Any] = {}
    for kind in kinds:
        for size in (1, 20) if kind != "threads" else (1,):
            name = f"{kind}, {size} an item"
            wall = processor = float("inf")
            for _ in range(rounds):
                with executor(kind, 1, registered_at_once) as pool:
                    before = time.process_time()
                    wall = min(wall, many(path, pool, path.parent / "out", size))
                    processor = min(processor, time.process_time() - before)
            work.register = pyemtr.register
            found[name] = {"wall_ms": 1e3 * wall / pairs, "cpu_ms": 1e3 * processor / pairs}
            print(f"{name:22} {1e3 * wall / pairs:8.2f} {1e3 * processor / pairs:8.2f}")
    found["record_bytes"] = _record_bytes(path.parent / "out")
    found["item_bytes"] = _item_bytes(path)
    print(f"\na record has {found['record_bytes']:.0f} bytes, an item of work without clouds"
          f" {found['item_bytes']}")  # fmt: skip
    return found


def registered_at_once() -> None:
    """Makes this process give one result to all registrations."""
    pair = ball_pair(1000, 0)
    result = pyemtr.register(pair.source, pair.target, threads=1, **SETTINGS)
    work.register = lambda *clouds, **settings: result  # type: ignore[assignment]


def _timed(
    kind: str, count: int, begin: Callable[[], None], path: Path, out: Path
) -> Callable[[], float]:
    def call() -> float:
        with executor(kind, count, begin) as pool:
            return many(path, pool, out)

    return call


def _record_bytes(out: Path) -> float:
    lines = (out / "results.jsonl").read_text().splitlines()
    return sum(map(len, lines)) / len(lines)


def _item_bytes(path: Path) -> int:
    return len(pickle.dumps(([read_pairs(str(path))[0]], SETTINGS, 1 << 30)))
