"""Every method on every pair and motion, one after the other so that all meet the same machine."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from pyemtr.metrics import MAX_ROTATION_ERROR, MAX_TRANSLATION_ERROR

from ..pairs import Pair, load
from ..runner import Moved, moved, pose_errors
from .methods import Array, Method, Task
from .settings import Setting
from .voxel import voxel_size
from .worker import Answer, Worker


@dataclass(frozen=True)
class Options:
    transforms: int
    threads: int
    limit: float  # seconds a run
    seed: int  # run i of a pair has seed + i
    recommended: Setting


@dataclass(frozen=True)
class PeerRun:
    """One registration. `error` says what happened to a run that gave no pose."""

    method: str
    pair: Pair
    index: int
    kind: str
    voxel: float  # user's unit
    T_true: Array
    T_est: Array | None
    seconds: float  # NaN without a pose
    rotation: float  # degrees, NaN without a pose
    translation: float  # normalized frame, NaN without a pose
    error: str = ""
    setting: Setting | None = None  # None for emtr, which has no such setting

    @property
    def success(self) -> bool:
        return self.rotation < MAX_ROTATION_ERROR and self.translation < MAX_TRANSLATION_ERROR


def measure(
    pairs: list[Pair],
    methods: list[Method],
    options: Options,
    settings: Sequence[Setting] = (),
) -> Iterator[list[PeerRun]]:
    """The runs of one pair and motion at a time, in the order of the methods, and of the settings
    (the recommended one alone by default) for each method but ours."""
    settings = settings or (options.recommended,)
    workers = [Worker(method, options.threads) for method in methods]
    turn = 0
    try:
        for pair in pairs:
            clouds = load(pair)
            sizes = _voxels(clouds.source, clouds.target, settings)
            for index in range(options.transforms):
                # Each method is the first of its round in turn: none always has the cold cache.
                first = turn % len(workers)
                turn += 1
                done = {
                    worker.method.name: [
                        _run(worker, pair, index, sizes, setting, options)
                        for setting in (settings[:1] if worker.method.ours else settings)
                    ]
                    for worker in workers[first:] + workers[:first]
                }
                yield [run for method in methods for run in done[method.name]]
    finally:
        for worker in workers:
            worker.close()


def _voxels(source: Array, target: Array, settings: Iterable[Setting]) -> dict[int | None, float]:
    """The voxel of each count of points."""
    counts = {count for s in settings for count in (s.search_points, s.refine_points) if count}
    return {count: voxel_size(source, target, count) for count in counts}


def _run(
    worker: Worker,
    pair: Pair,
    index: int,
    sizes: dict[int | None, float],
    setting: Setting,
    options: Options,
) -> PeerRun:
    case = moved(pair, index)
    voxel = sizes[setting.search_points]
    refine_voxel = sizes.get(setting.refine_points)
    task = Task(voxel, options.threads, options.seed + index, refine_voxel)
    answer = worker.ask(case.source, case.target, task, options.limit)
    rotation, translation, error = _judge(case, answer)
    return PeerRun(
        worker.method.name, pair, index, case.motion.kind, voxel, case.motion.T_true,
        None if error else answer.T, math.nan if error else answer.seconds,
        rotation, translation, error, None if worker.method.ours else setting,
    )  # fmt: skip


def _judge(case: Moved, answer: Answer) -> tuple[float, float, str]:
    if answer.T is None:
        return math.nan, math.nan, answer.error
    try:
        return *pose_errors(case, answer.T), ""
    except ValueError as failure:  # not finite, or not rigid
        return math.nan, math.nan, f"gave no pose: {failure}"
