"""Registers again and again, and keeps the library's own timings."""

from __future__ import annotations

import statistics
from typing import Any

import numpy as np
from numpy.typing import NDArray

import pyemtr

from ..peers.summary import Quartiles, quartiles
from .arguments import STRUCTURES

Array = NDArray[np.float64]


def profile(
    source: Array, target: Array, preset: str, threads: int, repetitions: int
) -> dict[str, Any]:
    """Quartiles of the wall seconds of each stage, after a run that warms up."""
    timings: list[dict[str, float]] = []
    for _ in range(repetitions + 1):
        result = pyemtr.register(source, target, preset=preset, threads=threads)
        timings.append(dict(result.timings))
    stages = {name: quartiles([run[name] for run in timings[1:]]) for name in timings[0]}
    return {
        "preset": preset,
        "threads": threads,
        "seconds": {name: found._asdict() for name, found in stages.items()},
    }


def compare_structures(
    source: Array, target: Array, preset: str, threads: int, repetitions: int
) -> dict[str, Any]:
    """The evolution by each structure in turns; the ratio is the median of those of each turn."""
    seconds: dict[str, list[float]] = {name: [] for name in STRUCTURES}
    poses: set[bytes] = set()
    for _ in range(repetitions):
        for name in STRUCTURES:
            result = pyemtr.register(source, target, preset=preset, threads=threads, neighbors=name)
            seconds[name].append(result.timings["evolution"])
            poses.add(np.asarray(result.transformation).tobytes())
    turns = [slow / fast for fast, slow in zip(*(seconds[name] for name in STRUCTURES))]
    found: dict[str, Quartiles] = {name: quartiles(values) for name, values in seconds.items()}
    return {
        "preset": preset,
        "threads": threads,
        "evolution": {name: q._asdict() for name, q in found.items()},
        "ratio": statistics.median(turns),
        "same_bits": len(poses) == 1,
    }
