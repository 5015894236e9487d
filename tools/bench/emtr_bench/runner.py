"""Runs a register function over pairs and motions, and scores each pose it gives."""

from __future__ import annotations

import functools
import math
import time
import traceback
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from pyemtr.alternative import Alternative
from pyemtr.metrics import (
    MAX_ROTATION_ERROR,
    MAX_TRANSLATION_ERROR,
    rotation_error,
    translation_error,
)

from . import priors, protocol, unknown_scale
from .jobs import side_by_side
from .pairs import Clouds, Pair, load
from .sensors import sensor_positions

Array = NDArray[np.float64]
Setting = Union[int, float, str, Array]


@dataclass(frozen=True)
class Options:
    """Options of a registration; the seed of run i is the base seed plus i."""

    preset: str = "default"
    seed: int = 0
    threads: int = 0
    settings: dict[str, Setting] = field(default_factory=dict)
    viewpoints: bool = False  # tell where the sensors stood, of the pairs where it is known
    prior: str = ""  # one of priors.PRIORS: tell something true of the pose
    scale: str = ""  # one of searched_scales.SEARCHED: give the source another scale


@dataclass(frozen=True)
class Outcome:
    """The outcome of one registration, as a register function returns it."""

    transformation: Array  # (4, 4), source into target; NaN when it has none
    registered: bool  # its own verdict
    reason: str
    quality: dict[str, float]  # fitness, inlier ratios, fitness_gap...
    counts: dict[str, int]  # points, matches, threads...
    queries: dict[str, int]  # evaluation, switch, complement
    seconds: dict[str, float]  # by stage, as the library measured
    settings: dict[str, Any]  # all of them, as the library held them
    alternatives: list[Alternative] = field(default_factory=list)  # best first


@dataclass(frozen=True)
class Sensors:
    """Where those of a run stood, each (3,) in its cloud's own frame and unit."""

    source: Array
    target: Array


#: (source (n, 3), target (m, 3), options with the run's own seed, sensors if known) -> outcome
Register = Callable[[Array, Array, Options, Union[Sensors, None]], Outcome]


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
    translation: float  # normalized frame, NaN without a pose
    error: str = ""
    others_right: tuple[bool, ...] = ()  # for each of the alternatives
    scale: float = 0.0  # relative error of the scale, 0 where it was known

    @property
    def success(self) -> bool:
        """The paper's: the rotation alone."""
        return self.rotation < MAX_ROTATION_ERROR

    @property
    def joint(self) -> bool:
        return right((self.rotation, self.translation, self.scale))

    @property
    def among(self) -> bool:
        """One of the alternatives is right."""
        return any(self.others_right)

    @property
    def joint_or_among(self) -> bool:
        """Right, or called ambiguous with the right pose among the alternatives."""
        ambiguous = self.outcome is not None and self.outcome.reason == "ambiguous"
        return self.joint or (ambiguous and self.among)

    @property
    def confidence(self) -> float:
        """The library's; NaN when it gave none."""
        return math.nan if self.outcome is None else self.outcome.quality["confidence"]

    @property
    def registered(self) -> bool:
        return self.outcome is not None and self.outcome.registered


@dataclass(frozen=True)
class Moved:
    """A pair with its source moved by one motion of the protocol."""

    source: Array
    target: Array
    motion: protocol.Motion
    scale: float  # of the normalized frame, user's unit
    sensors: Sensors | None = None  # when it is known where they stood
    factor: float = 1.0  # by which the source was divided after its motion


def moved(pair: Pair, index: int, scale: str = "") -> Moved:
    """A pair and one motion; ``scale`` as in the options."""
    clouds, aligned, radius = _preprocessed(pair)
    factor = unknown_scale.factor(scale, pair.name, index)
    motion = protocol.motion(pair.name, index, aligned)
    sensors = None
    places = sensor_positions(pair)
    if places is not None:  # the source's moves with the source
        place = protocol.apply(motion.matrix @ clouds.T_gt, places[:1])[0]
        sensors = Sensors(place / factor, places[1])
    source = protocol.apply(motion.matrix, aligned) / factor
    return Moved(source, clouds.target, motion, radius, sensors, factor)


def pose_errors(case: Moved, T: Array) -> tuple[float, float]:
    """E_R in degrees and E_t in the normalized frame of a pose (4, 4), source into target.
    Raises ValueError when it is not rigid."""
    T_true = case.motion.T_true
    center = case.source.mean(axis=0)
    return rotation_error(T, T_true), translation_error(T, T_true, center, case.scale)


def similarity_errors(case: Moved, T: Array) -> tuple[float, float, float]:
    """The same, and the relative error of the scale, of a pose of a source of another scale."""
    if case.factor == 1.0 and unknown_scale.is_rigid(T):
        return *pose_errors(case, T), 0.0
    center = case.factor * case.source.mean(axis=0)
    rigid, scale = unknown_scale.rigid_at(T, center, case.factor)
    T_true = case.motion.T_true
    return (
        rotation_error(rigid, T_true),
        translation_error(rigid, T_true, center, case.scale),
        scale,
    )


def right(errors: tuple[float, float, float]) -> bool:
    """Tells whether all errors of a pose are small enough; they never are for NaN."""
    rotation, translation, scale = errors
    return (
        rotation < MAX_ROTATION_ERROR
        and translation < MAX_TRANSLATION_ERROR
        and scale < unknown_scale.MAX_SCALE_ERROR
    )


def run(pair: Pair, index: int, register: Register, options: Options) -> Run:
    """One registration. An exception of the register function becomes a run with `error`,
    so that one crash does not lose the others; it is reported and fails the benchmark."""
    case = moved(pair, index, options.scale)
    seed = options.seed + index
    settings = dict(options.settings)
    if options.prior:
        center = case.source.mean(axis=0)
        settings |= priors.prior(
            options.prior, pair.name, index, case.motion.T_true, center, case.scale
        )
    own = replace(options, seed=seed, settings=settings)
    sensors = case.sensors if options.viewpoints else None
    outcome, error, wall = attempt(register, case.source, case.target, own, sensors)
    errors, others = (math.nan, math.nan, 0.0), ()
    if outcome is not None and np.isfinite(outcome.transformation).all():
        errors = similarity_errors(case, outcome.transformation)
        others = tuple(right(similarity_errors(case, other.transformation))
                       for other in outcome.alternatives)  # fmt: skip
    T_true, kind = case.motion.T_true, case.motion.kind
    rotation, translation, scale = errors
    return Run(pair, index, kind, seed, T_true, wall, outcome, rotation, translation, error, others,
               scale)  # fmt: skip


def attempt(
    register: Register, source: Array, target: Array, options: Options, sensors: Sensors | None
) -> tuple[Outcome | None, str, float]:
    """The outcome or else the traceback, and the wall seconds."""
    outcome, error = None, ""
    start = time.perf_counter()
    try:
        outcome = register(source, target, options, sensors)
    except Exception:  # noqa: BLE001 (one failed run is a line of the report, whatever it was)
        error = traceback.format_exc()
    return outcome, error, time.perf_counter() - start


def run_all(
    pairs: list[Pair], transforms: int, register: Register, options: Options, jobs: int = 1
) -> Iterator[Run]:
    """Every pair x motion, in that order, as they are done."""
    tasks = [(pair, index) for pair in pairs for index in range(transforms)]
    work = functools.partial(_run_task, register=register, options=options)
    yield from side_by_side(work, tasks, jobs)


def _run_task(task: tuple[Pair, int], register: Register, options: Options) -> Run:
    return run(*task, register, options)


@functools.lru_cache(maxsize=2)
def _preprocessed(pair: Pair) -> tuple[Clouds, Array, float]:
    clouds = load(pair)
    aligned = protocol.apply(clouds.T_gt, clouds.source)
    return clouds, aligned, protocol.frame_scale(clouds.source, clouds.target)
