"""Who aligns the scans: emtr, Open3D's multiway registration, KISS-Matcher with emtr's graph."""

from __future__ import annotations

import importlib.util
import os
from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations
from time import perf_counter, process_time

import pyemtr

from ..pairs import Array
from .scenes import Scene


@dataclass(frozen=True)
class Answer:
    poses: list[Array | None]  # scan -> model
    models: list[int | None]
    seconds: float
    cpu: float  # seconds of all threads, which other programs do not change much


Method = Callable[[Scene, int, int], Answer]  # with the threads and the seed


def emtr(scene: Scene, threads: int, seed: int) -> Answer:
    begin, cpu = perf_counter(), process_time()
    result = pyemtr.align_all(scene.clouds, threads=threads, seed=seed)
    seconds, cpu = perf_counter() - begin, process_time() - cpu
    return Answer(
        [scan.pose if scan.placed else None for scan in result.scans],
        [scan.model for scan in result.scans],
        seconds,
        cpu,
    )


def method(name: str) -> Method | None:
    """The method, or None where its package is not installed."""
    if name == "emtr":
        return emtr
    package = {"open3d": "open3d", "kiss": "kiss_matcher"}[name]
    if importlib.util.find_spec(package) is None:
        return None
    from . import other_methods

    return other_methods.METHODS[name]


def all_pairs(count: int) -> list[tuple[int, int]]:
    """(source, target) of all pairs, source > target."""
    return [(j, i) for i, j in combinations(range(count), 2)]


def threads_or_all(threads: int | None) -> int:
    return threads or os.cpu_count() or 1
