"""Many scans of one thing: all of them into one frame, without an order and without a guess."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from itertools import combinations
from time import perf_counter
from typing import TYPE_CHECKING, Any

import numpy as np

from ..mesh import MESH_POINTS, as_mesh_points
from ..options import make_settings, require_rigid, thread_setting
from .pairwise import register_pairs
from .pose_graph import require_gtsam
from .result import MultiwayResult
from .scans import Scans
from .stages import Stages
from .vote import best_pairs, vote

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ..setting_types import MethodSettings

#: Up to so many scans, all pairs are tried.
ALL_PAIRS = 20
#: Of more scans, this many pairs of each, by the vote.
VOTED_PAIRS = 8


def align_all(
    clouds: Any,
    *,
    names: Sequence[str] | None = None,
    seed: int = 0,
    threads: int = 0,
    preset: str = "default",
    pairs: Sequence[tuple[int, int]] | None = None,
    joint_refinement: bool = True,
    mesh_points: int = MESH_POINTS,
    callback: Callable[[str, int, int], Any] | None = None,
    **settings: Unpack[MethodSettings],
) -> MultiwayResult:
    """Aligns many scans of one thing, in any order and from any pose.

    Pairs of scans are registered by EMTR-SSC. Loops over three scans tell right poses from wrong
    ones, and a pose that is one of a pair's alternatives competes with its answer. Scans are merged
    where the odds are high enough; GTSAM solves the pose graph of each model with a robust kernel.
    Scans of which nothing is sure are left out, and scans of different things become different
    models. docs/MANY_SCANS.md says how.

    The same scans and seed give the same poses, for any number of threads.

    Args:
        clouds: the scans: a list of clouds as :func:`pyemtr.register` takes them (arrays (N, 3),
            files, :class:`pyemtr.Cloud`, objects with points), in one unit, or a folder of files.
            Files are read when they are needed; no more than 32 preprocessed clouds are in memory.
        names: of the scans, all different. None: the names of the files, or numbers.
        seed: 0 <= seed < 2**64.
        threads: pairs that are registered at a time, each by one thread; 0: one for each
            processor.
        preset: one of :func:`pyemtr.presets` but "paper", which has no confidence.
        pairs: (i, j) that are tried, indices of the scans. None: all pairs of up to 20 scans; of
            more, those that a vote of coarse descriptors finds likely.
        joint_refinement: refine all poses of a model at once, each point to the planes of the
            other scans.
        mesh_points: as in :func:`pyemtr.register`.
        callback: called with a stage, and how many of its steps are done and to be done. Return
            True to stop: RuntimeError is then raised.
        **settings: any of :func:`pyemtr.settings` by name, for every pair.

    Returns:
        A :class:`pyemtr.MultiwayResult`: a pose for each scan, scan -> frame of its model.

    Raises:
        ImportError: GTSAM or scipy is not installed: ``pip install 'pyemtr[align]'``.
        RuntimeError: the callback has stopped the run.
        TypeError, ValueError, OSError, MemoryError: as :func:`pyemtr.register`, with the name of
            the scan; fewer than two scans, names that are not different, pairs that do not exist.
    """
    begin = perf_counter()
    require_gtsam()
    _require_scipy()
    if preset == "paper":
        raise ValueError('preset: "paper" has no confidence, which the choice of edges needs')
    make_settings(preset, {**settings}, seed=seed)  # type: ignore[dict-item]
    require_rigid(settings)
    workers = thread_setting(threads) or os.cpu_count() or 1
    scans = Scans(clouds, names, as_mesh_points(mesh_points))
    report = _reporter(callback)
    report("reading", 0, len(scans))
    radius = float(np.median([scans.extent(i).radius for i in range(len(scans))]))
    scores = None
    if pairs is None and len(scans) > ALL_PAIRS:
        report("choosing pairs", 0, 1)
        scores = vote(scans.surface, len(scans), radius)
        chosen = best_pairs(scores, len(scans), VOTED_PAIRS)
    elif pairs is None:
        chosen = [(j, i) for i, j in combinations(range(len(scans)), 2)]
    else:
        chosen = _checked(pairs, len(scans))
    arguments = {"seed": seed, "preset": preset, **settings}
    first = {"fallback_search": "off", **arguments}
    stages = Stages(scans, radius, workers)
    stages.add(
        register_pairs(
            scans, chosen, workers, first, lambda done, count: report("pairs", done, count)
        )
    )
    stages.group()
    again = stages.second_tries(scores if pairs is None else None)
    if again and (scores is not None or first != arguments):
        stages.add(
            register_pairs(
                scans,
                again,
                workers,
                arguments,
                lambda done, count: report("pairs again", done, count),
            )
        )
        stages.group()
    report("pose graph", 0, 1)
    stages.finish(joint_refinement)
    return stages.result(perf_counter() - begin)


def _reporter(callback: Callable[[str, int, int], Any] | None) -> Callable[[str, int, int], None]:
    def report(stage: str, done: int, count: int) -> None:
        if callback is not None and callback(stage, done, count):
            raise RuntimeError(f"align_all: stopped by the callback in the stage: {stage}")

    return report


def _checked(pairs: Sequence[tuple[int, int]], count: int) -> list[tuple[int, int]]:
    """Returns pairs as (source, target), source > target, each once."""
    found = set()
    for pair in pairs:
        i, j = (int(index) for index in pair)
        if i == j or not (0 <= i < count and 0 <= j < count):
            raise ValueError(
                f"pairs: expected two different scans from 0 to {count - 1}, got {pair}"
            )
        found.add((max(i, j), min(i, j)))
    if not found:
        raise ValueError("pairs: expected at least one, got none")
    return sorted(found)


def _require_scipy() -> None:
    try:
        import scipy.spatial  # noqa: F401
    except ImportError as error:
        raise ImportError(
            "align_all() needs scipy, which is not installed: pip install 'pyemtr[align]'"
        ) from error
