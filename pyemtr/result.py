"""The outcome of a registration."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .alternative import Alternative
from .arrays import Floats, as_points
from .distances import residuals


@dataclass(frozen=True, eq=False, repr=False)
class Result:
    """A pose and how far to trust it. Lengths are in the user's unit unless said.

    Attributes:
        transformation: float64 (4, 4), source into target: q = R p + t. The caller's own copy,
            writable. The best so far when the run was stopped, all NaN when none was known yet.
        registered: True when the pose is held to be right.
        reason: "registered", "low_overlap", "ambiguous", "few_matches", "interrupted",
            "degenerate" or "time_limit".
        reason_text: the reason in a few words.
        fitness: mean M-estimator over both dense clouds, 0 (best) to 1.
        inlier_ratio_source, inlier_ratio_target: share of dense points with a neighbor in the
            other cloud.
        fitness_gap: fitness of the best clearly different pose minus this pose's.
        overlap_source, overlap_target: share of the cloud's points that have a partner, the
            nearest point of the other's fine cloud, within ``leaf_fine``; asked are up to 5000
            of them. NaN when interrupted, as the two below.
        inlier_rmse: root mean square distance of the source's points that have one to their
            partners (point to point); NaN when none has.
        inlier_rmse_plane: the same to the partners' tangent planes, which does not grow with the
            spacing of the points.
        points_source, points_target: finite points; dropped_source, dropped_target: the others.
        sparse_source, sparse_target, dense_source, dense_target: points of the thinned clouds.
        correspondences, correspondences_found: feature matches kept, max_correspondences at most,
            and how many there were.
        tims, tims_pruned: pairs of them, max_tims at most, and how many of these can be an inlier
            of no rotation.
        queries: nearest neighbor look-ups ("evaluation", "switch", "complement").
        scale, center_source, center_target: the normalized frame, p' = (p - center) / scale.
        leaf_sparse, leaf_dense, leaf_fine: edge of the thinning voxels, normalized frame.
        timings: wall seconds by stage, 0 for one that did not run, and "total".
        iterations: done.
        history: best fitness so far after each iteration, float64 (iterations,), of the tasks
            "alpha" (its scale changes at the switch from sparse to dense) and "beta".
        seed: as given; threads: used; kernel: the instruction set of the inner loops, see
            :func:`pyemtr.kernel_name`.
        confidence: held probability, 0 to 1, that the pose is right within 5 degrees and 0.06
            radii. NaN without candidates (preset "paper"), as the four below, and when stopped
            before all of them were ranked.
        score: ``fit - 2 violation``, at most 1.
        fit: how well the surfaces lie on each other, 0 to 1 (best).
        violation: share of points in front of what the other scan saw, 0 (best) to 1.
        score_gap: score minus that of the best clearly different candidate.
        seeds: poses that consistent matches gave; candidates: distinct poses ranked.
        used_fallback_search: True when it was searched again with more feature points; refined: True when
            the answer was polished on fine clouds.
        alternatives: of :class:`pyemtr.Alternative`, best first, at most 10.
        information: float64 (6, 6), inverse of the pose's covariance for a small rotation w
            (radians) and then a shift v (the user's unit) about ``center_target`` c:
            q = exp(w) (R p + t - c) + c + v. NaN when not refined, as the two below.
        hessian_eigenvalues: float64 (6,), how firmly the matched surfaces hold the pose, ascending: 0 for a
            motion that slides them along themselves, to about 1.
        hessian_eigenvectors: float64 (6, 6), a unit vector a row, by rows of ``hessian_eigenvalues``: rotation,
            measured as the way at the surfaces' radius, then shift.
        unconstrained_directions: how many are not held; None when not refined.
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
    fitness_gap: float
    overlap_source: float
    overlap_target: float
    inlier_rmse: float
    inlier_rmse_plane: float
    points_source: int
    points_target: int
    dropped_source: int
    dropped_target: int
    sparse_source: int
    sparse_target: int
    dense_source: int
    dense_target: int
    correspondences: int
    correspondences_found: int
    tims: int
    tims_pruned: int
    queries: dict[str, int]
    scale: float
    center_source: Floats
    center_target: Floats
    leaf_sparse: float
    leaf_dense: float
    leaf_fine: float
    timings: dict[str, float]
    iterations: int
    history: dict[str, Floats]
    seed: int
    threads: int
    kernel: str
    confidence: float
    score: float
    fit: float
    violation: float
    score_gap: float
    seeds: int
    candidates: int
    used_fallback_search: bool
    refined: bool
    alternatives: list[Alternative]
    information: Floats
    hessian_eigenvalues: Floats
    hessian_eigenvectors: Floats
    unconstrained_directions: int | None
    settings: dict[str, Any]

    def apply(self, points: Any) -> Floats:
        """Points of the source's frame (N, 3), any dtype, in the target's frame: float64 (N, 3).

        Raises TypeError or ValueError as :func:`pyemtr.register` does for a cloud.
        """
        source = as_points(points, "points").astype(np.float64)
        return np.asarray(source @ self.transformation[:3, :3].T + self.transformation[:3, 3])

    def residuals(
        self, source: Any, target: Any, *, of: str = "source", threads: int = 0
    ) -> Floats:
        """The distance of each moved source point to the nearest target point, float64 (N,), or
        with ``of="target"`` that of each target point to the nearest moved source point, (M,).

        :func:`pyemtr.residuals` at this pose, which says the rest. Raises ValueError when there
        is none.
        """
        return residuals(source, target, self.transformation, of=of, threads=threads)

    def to_dict(self) -> dict[str, Any]:
        """All fields as JSON knows them: lists for arrays, None for NaN and infinities, a dict
        with "transformation" and "score" for each alternative."""
        return {field.name: _json(getattr(self, field.name)) for field in fields(self)}

    def __repr__(self) -> str:
        verdict = "registered" if self.registered else f"not registered ({self.reason_text})"
        rows = np.array2string(self.transformation, precision=6, suppress_small=True, prefix="    ")
        return (
            f"<pyemtr.Result: {verdict}{self._confidence_text()}\n"
            f"  fitness {self.fitness:.4f}, mode gap {self.fitness_gap:.4f}\n"
            f"  overlap {self.overlap_source:.1%} of the source,"
            f" {self.overlap_target:.1%} of the target; rmse {self.inlier_rmse:.4g} to points,"
            f" {self.inlier_rmse_plane:.4g} to planes\n"
            f"  transformation, source into target:\n    {rows}\n"
            f"  {self.iterations} iterations, seed {self.seed}, {self.threads} threads,"
            f" {self.kernel}, {self.timings['total']:.3f} s>"
        )

    def _confidence_text(self) -> str:
        if math.isnan(self.confidence):
            return ""
        return f", confidence {self.confidence:.1%}"


def make_result(raw: Mapping[str, Any], settings: dict[str, Any]) -> Result:
    """A Result from the extension's fields."""
    values = dict(raw)
    values["transformation"] = _matrix(raw["transformation"], 4)
    values["center_source"] = _vector(raw["center_source"])
    values["center_target"] = _vector(raw["center_target"])
    values["alternatives"] = [
        Alternative(_matrix(pose, 4), score) for pose, score in raw["alternatives"]
    ]
    values["information"] = _matrix(raw["information"], 6)
    values["hessian_eigenvalues"] = _vector(raw["hessian_eigenvalues"])
    values["hessian_eigenvectors"] = _matrix(raw["hessian_eigenvectors"], 6)
    values["history"] = {task: _vector(best) for task, best in raw["history"].items()}
    return Result(settings=settings, **values)


def _vector(values: Any) -> NDArray[np.float64]:
    return np.array(values, dtype=np.float64)


def _matrix(values: Any, rows: int) -> NDArray[np.float64]:
    return _vector(values).reshape(rows, rows)


def _json(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return _json(value.tolist())
    if isinstance(value, Alternative):
        return _json(value._asdict())
    if isinstance(value, dict):
        return {key: _json(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_json(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
