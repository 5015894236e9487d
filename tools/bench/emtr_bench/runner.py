"""Runs a register function over pairs and motions, and scores each pose it gives."""

from __future__ import annotations

import functools
import math
import multiprocessing
import time
import traceback
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field, replace
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray
from pyemtr.metrics import (
    MAX_ROTATION_ERROR,
    MAX_TRANSLATION_ERROR,
    rotation_error,
    translation_error,
)

from . import protocol
from .pairs import Clouds, Pair, load

Array = NDArray[np.float64]
Setting = Union[int, float, str]


@dataclass(frozen=True)
class Options:
    """How to register; the same for every run but the seed, which is base seed + index."""

    preset: str = "paper"
    seed: int = 0
    threads: int = 0
    settings: dict[str, Setting] = field(default_factory=dict)


@dataclass(frozen=True)
class Outcome:
    """What a register function says of one registration."""

    transformation: Array  # (4, 4), source into target; NaN when it has none
    registered: bool  # its own verdict
    reason: str
    quality: dict[str, float]  # fitness, inlier ratios, mode_gap...
    counts: dict[str, int]  # points, matches, threads...
    lookups: dict[str, int]  # evaluation, switch, complement
    seconds: dict[str, float]  # by stage, as the library measured
    settings: dict[str, Any]  # all of them, as the library held them


#: (source (n, 3), target (m, 3), options with the run's own seed) -> outcome
Register = Callable[[Array, Array, Options], Outcome]


@dataclass(frozen=True)
class Run:
    """One registration and its errors. `error` holds the traceback of a run that crashed."""

    pair: Pair
    index: int
    kind: str
    seed: int
    T_true: Array
    wall: float  # seconds around the call
    outcome: Outcome | None
    rotation: float  # degrees, NaN without a pose
    translation: float  # normalised frame, NaN without a pose
    error: str = ""

    @property
    def success(self) -> bool:
        """The paper's: the rotation alone."""
        return self.rotation < MAX_ROTATION_ERROR

    @property
    def joint(self) -> bool:
        return self.success and self.translation < MAX_TRANSLATION_ERROR

    @property
    def registered(self) -> bool:
        return self.outcome is not None and self.outcome.registered


@dataclass(frozen=True)
class Moved:
    """A pair with its source moved by one motion of the protocol."""

    source: Array
    target: Array
    motion: protocol.Motion
    scale: float  # of the normalised frame, user's unit


def moved(pair: Pair, index: int) -> Moved:
    clouds, aligned, scale = _prepared(pair)
    motion = protocol.motion(pair.name, index, aligned)
    return Moved(protocol.apply(motion.matrix, aligned), clouds.target, motion, scale)


def pose_errors(case: Moved, T: Array) -> tuple[float, float]:
    """E_R in degrees and E_t in the normalised frame of a pose (4, 4), source into target.
    Raises ValueError when it is not rigid."""
    T_true = case.motion.T_true
    center = case.source.mean(axis=0)
    return rotation_error(T, T_true), translation_error(T, T_true, center, case.scale)


def run(pair: Pair, index: int, register: Register, options: Options) -> Run:
    """One registration. An exception of the register function becomes a run with `error`,
    so that one crash does not lose the others; it is reported and fails the benchmark."""
    case = moved(pair, index)
    seed = options.seed + index
    own = replace(options, seed=seed)
    outcome, error, rotation, translation = None, "", math.nan, math.nan
    start = time.perf_counter()
    try:
        outcome = register(case.source, case.target, own)
    except Exception:
        error = traceback.format_exc()
    wall = time.perf_counter() - start
    if outcome is not None and np.isfinite(outcome.transformation).all():
        rotation, translation = pose_errors(case, outcome.transformation)
    T_true = case.motion.T_true
    return Run(
        pair, index, case.motion.kind, seed, T_true, wall, outcome, rotation, translation, error
    )


def run_all(
    pairs: list[Pair], transforms: int, register: Register, options: Options, jobs: int = 1
) -> Iterator[Run]:
    """Every pair x motion, in that order, as they are done. With several jobs each has a
    process of its own, started afresh: no thread pool is inherited half alive."""
    tasks = [(pair, index) for pair in pairs for index in range(transforms)]
    work = functools.partial(_run_task, register=register, options=options)
    if jobs == 1:
        yield from map(work, tasks)
        return
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(jobs, mp_context=context) as pool:
        yield from pool.map(work, tasks)


def _run_task(task: tuple[Pair, int], register: Register, options: Options) -> Run:
    return run(*task, register, options)


@functools.lru_cache(maxsize=2)
def _prepared(pair: Pair) -> tuple[Clouds, Array, float]:
    clouds = load(pair)
    aligned = protocol.apply(clouds.T_gt, clouds.source)
    return clouds, aligned, protocol.frame_scale(clouds.source, clouds.target)
