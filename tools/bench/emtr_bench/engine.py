"""pyemtr as the benchmark sees it."""

from __future__ import annotations

from typing import Any

import pyemtr
from pyemtr.options import make_settings

from . import unknown_scale
from .runner import Array, Options, Outcome, Run, Sensors, moved

QUALITY = (
    "fitness", "inlier_ratio_source", "inlier_ratio_target", "fitness_gap", "overlap_source",
    "overlap_target", "inlier_rmse", "inlier_rmse_plane",
    "confidence", "score", "surface_fit", "surface_near", "violation", "evidence", "score_gap",
    "scale", "scale_constraint",
)  # fmt: skip
COUNTS = (
    "points_source", "points_target", "dropped_source", "dropped_target", "sparse_source",
    "sparse_target", "dense_source", "dense_target", "correspondences",
    "correspondences_found", "tims", "tims_pruned",
    "iterations", "threads", "seeds", "candidates", "used_fallback_search", "refined",
    "unconstrained_directions",
)  # fmt: skip


class PyemtrEngine:
    """Without state, so that worker processes can be sent one."""

    version: str = pyemtr.__version__

    def check(self, options: Options) -> None:
        """Raises ValueError, naming it, when the preset or a setting is unknown or out of range."""
        try:
            make_settings(
                options.preset, options.settings, seed=options.seed, threads=options.threads
            )
        except TypeError as error:
            raise ValueError(str(error)) from error

    def register(
        self, source: Array, target: Array, options: Options, sensors: Sensors | None
    ) -> Outcome:
        more: dict[str, Any] = unknown_scale.settings(options.scale)
        if sensors is not None:
            more |= {"source_viewpoint": sensors.source, "target_viewpoint": sensors.target}
        result = pyemtr.register(source, target, **_keywords(options), **more)
        return Outcome(
            result.transformation,
            result.registered,
            result.reason,
            {name: getattr(result, name) for name in QUALITY},
            {name: getattr(result, name) for name in COUNTS},
            result.queries,
            result.timings,
            result.settings,
            result.alternatives,
        )

    def fitness(self, run: Run, options: Options) -> tuple[float, float]:
        """Task alpha's dense fitness a point, 0 (best) to 1: of the true pose, of the estimate."""
        if run.outcome is None:
            raise ValueError(f"{run.pair.name}[{run.index}] has no outcome to judge")
        case = moved(run.pair, run.index)
        problem = pyemtr.Problem(case.source, case.target, **_keywords(options))
        poses = (run.T_true, run.outcome.transformation)
        sums = pyemtr.TaskAlpha(problem).evaluate([problem.to_particle(T) for T in poses])
        points = run.outcome.counts["dense_source"] + run.outcome.counts["dense_target"]
        return float(sums[0]) / points, float(sums[1]) / points


def _keywords(options: Options) -> dict[str, Any]:
    own = {"preset": options.preset, "seed": options.seed, "threads": options.threads}
    return {**options.settings, **own}
