"""The outcome of a registration."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any, Mapping

import numpy as np
from numpy.typing import NDArray

from .arrays import Floats, as_points


@dataclass(frozen=True, eq=False, repr=False)
class Result:
    """A pose and how far to trust it. Lengths are in the user's unit unless said.

    Attributes:
        transformation: float64 (4, 4), source into target: q = R p + t. The caller's own copy,
            writable. All NaN when the run was stopped before any pose was known.
        registered: True when the pose is held to be right.
        reason: "registered", "low_overlap", "ambiguous", "few_matches" or "interrupted".
        reason_text: the reason in a few words.
        fitness: mean M-estimator over both dense clouds, 0 (best) to 1.
        inlier_ratio_source, inlier_ratio_target: share of dense points with a neighbour in the
            other cloud.
        inlier_rmse: of the source inliers to their nearest target point; NaN without inliers.
        mode_gap: fitness of the best clearly different pose minus this pose's.
        points_source, points_target: finite points; dropped_source, dropped_target: the others.
        sparse_source, sparse_target, dense_source, dense_target: points of the thinned clouds.
        correspondences, tims, tims_pruned: feature matches, their pairs, and how many of these
            can be an inlier of no rotation.
        lookups: nearest neighbour look-ups ("evaluation", "switch", "complement").
        scale, center_source, center_target: the normalised frame, p' = (p - center) / scale.
        leaf_sparse, leaf_dense: edge of the thinning voxels, normalised frame.
        timings: wall seconds by stage, and "total".
        iterations: done.
        history: best fitness so far after each iteration, float64 (iterations,), of the tasks
            "alpha" (its scale changes at the switch from sparse to dense) and "beta".
        seed: as given; threads: used; kernel: the instruction set of the inner loops, see
            :func:`pyemtr.kernel_name`.
        settings: every setting, as keyword arguments that repeat the run:
            ``register(source, target, **result.settings)``.
    """

    transformation: Floats
    registered: bool
    reason: str
    reason_text: str
    fitness: float
    inlier_ratio_source: float
    inlier_ratio_target: float
    inlier_rmse: float
    mode_gap: float
    points_source: int
    points_target: int
    dropped_source: int
    dropped_target: int
    sparse_source: int
    sparse_target: int
    dense_source: int
    dense_target: int
    correspondences: int
    tims: int
    tims_pruned: int
    lookups: dict[str, int]
    scale: float
    center_source: Floats
    center_target: Floats
    leaf_sparse: float
    leaf_dense: float
    timings: dict[str, float]
    iterations: int
    history: dict[str, Floats]
    seed: int
    threads: int
    kernel: str
    settings: dict[str, Any]

    def apply(self, points: Any) -> Floats:
        """Points of the source's frame (N, 3), any dtype, in the target's frame: float64 (N, 3).

        Raises TypeError or ValueError as :func:`pyemtr.register` does for a cloud.
        """
        source = as_points(points, "points").astype(np.float64)
        return np.asarray(source @ self.transformation[:3, :3].T + self.transformation[:3, 3])

    def to_dict(self) -> dict[str, Any]:
        """All fields as JSON knows them: lists for arrays, None for NaN and infinities."""
        return {field.name: _json(getattr(self, field.name)) for field in fields(self)}

    def __repr__(self) -> str:
        verdict = "registered" if self.registered else f"not registered ({self.reason_text})"
        rows = np.array2string(self.transformation, precision=6, suppress_small=True,
                               prefix="    ")
        return (
            f"<pyemtr.Result: {verdict}\n"
            f"  fitness {self.fitness:.4f}, mode gap {self.mode_gap:.4f},"
            f" inlier rmse {self.inlier_rmse:.4g}\n"
            f"  inliers {self.inlier_ratio_source:.1%} of the source,"
            f" {self.inlier_ratio_target:.1%} of the target\n"
            f"  transformation, source into target:\n    {rows}\n"
            f"  {self.iterations} iterations, seed {self.seed}, {self.threads} threads,"
            f" {self.kernel}, {self.timings['total']:.3f} s>")


def make_result(raw: Mapping[str, Any], settings: dict[str, Any]) -> Result:
    """A Result from the extension's fields."""
    values = dict(raw)
    values["transformation"] = _vector(raw["transformation"]).reshape(4, 4)
    values["center_source"] = _vector(raw["center_source"])
    values["center_target"] = _vector(raw["center_target"])
    values["history"] = {task: _vector(best) for task, best in raw["history"].items()}
    return Result(settings=settings, **values)


def _vector(values: Any) -> NDArray[np.float64]:
    return np.array(values, dtype=np.float64)


def _json(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return _json(value.tolist())
    if isinstance(value, dict):
        return {key: _json(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_json(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
