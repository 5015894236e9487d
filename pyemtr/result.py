"""The result of a registration."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _emtr
from .alternative import Alternative
from .arrays import Floats
from .distances import residuals
from .mesh import MESH_POINTS, mesh_of
from .points import as_points
from .result_html import html_of
from .result_json import from_json, to_json

# The dict of a group whose fields are named after it, where it has another name than the group.
ATTRIBUTES = {"seconds": "timings"}


@dataclass(frozen=True, eq=False, repr=False)
class Result:
    """A pose, and how far to trust it. Lengths are in the user's unit unless said otherwise.

    Attributes:
        transformation: float64 (4, 4), source into target: q = R p + t, or q = s R p + t where the
            scale was searched. Writable, and the caller's own. The best pose so far when the run
            was stopped, all NaN when none was known yet.
        scale: factor s of the source's lengths; 1 unless it was searched, NaN when no pose is
            known.
        registered: True when the pose is taken to be right.
        reason: "registered", "low_overlap", "ambiguous", "few_matches", "interrupted",
            "degenerate", "time_limit", "mirrored", "scale" or "free_scale".
        reason_text: the reason in a few words.
        fitness: mean M-estimator over both dense clouds, 0 (best) to 1.
        inlier_ratio_source, inlier_ratio_target: share of dense points with a neighbor in the
            other cloud.
        fitness_gap: fitness of the best clearly different pose minus the fitness of this pose.
        overlap_source, overlap_target: share of up to 5000 of the cloud's points that have a
            correspondence: the nearest point of the other fine cloud, within ``leaf_fine``. NaN
            when interrupted, like the next two.
        inlier_rmse: root mean square distance of the source's points to their correspondences,
            point to point; NaN when there are none.
        inlier_rmse_plane: the same to the tangent planes of the correspondences; it does not grow
            with the spacing of the points.
        points_source, points_target: the number of finite points.
        dropped_source, dropped_target: the number of points with a NaN or an infinity.
        strays_source, strays_target: the number of finite points that were left out: far outside
            of all the others or, in a cloud of at most 3000 points, scattered off its surface.
        sparse_source, sparse_target, dense_source, dense_target: points of the downsampled clouds.
        correspondences, correspondences_found: feature matches used, at most
            ``max_correspondences``, and feature matches found.
        tims, tims_pruned: pairs of correspondences, at most ``max_tims``, and how many of them no
            rotation can make an inlier.
        queries: nearest-neighbor queries by purpose: "evaluation", "switch", "complement".
        normalization_scale, center_source, center_target: the normalized frame,
            p' = (p - center) / normalization_scale; centers are float64 (3,).
        leaf_sparse, leaf_dense, leaf_fine: voxel edge of each downsampling, normalized frame.
        timings: wall seconds by stage, 0 for a stage that did not run, and "total".
        iterations: how many were done.
        history: best fitness so far after each iteration, float64 (iterations,), of the tasks
            "alpha" (its scale changes at the switch from sparse to dense) and "beta".
        seed: the argument.
        threads: the number of threads used.
        kernel: the instruction set of the inner loops, see :func:`pyemtr.kernel_name`.
        confidence: estimated probability, 0 to 1, that the pose is right within 5 degrees and 0.06
            radii. NaN without candidates (preset "paper"), like the next seven, and when the run
            was stopped before all of them were ranked.
        score: ``surface_fit - 0.1 (surface_near - surface_fit) - violation``, at most 1; where
            given matches decide, the share of them that are inliers.
        surface_fit: how well the surfaces agree, 0 to 1 (best); distinctive points count more.
        surface_near: share of points near the other surface, on it or not, weighted alike.
        violation: share of points in front of what the other scan saw, 0 (best) to 1, times the
            trust in the place of its sensor.
        evidence: how many dense points of the poorer cloud lie on the other.
        scale_factor: factor of the source's lengths at which it fits better, with the reason
            "scale"; 1 where none does.
        score_gap: score minus that of the best clearly different candidate.
        seeds: the number of poses that consistent matches gave.
        candidates: the number of distinct poses ranked.
        used_fallback_search: True when the search was repeated with more feature points.
        refined: True when the pose was refined on fine clouds.
        alternatives: list of :class:`pyemtr.Alternative`, best first, at most 10.
        symmetry: a motion after which the clouds fit about as well: "none", "rotational" (by
            360 / n degrees), "continuous" (by any angle), "translational"; "unknown" without
            candidates.
        symmetry_order: n of a rotational symmetry, else 0.
        symmetry_axis: float64 (3,), of unit length in the target's axes: the axis of the rotations
            or the direction of the translations; NaN where there is no symmetry.
        symmetry_period: length of the shortest translation, the user's unit; 0 where any length is
            one, NaN unless translational.
        used_colors: True when colors decided about the pose, or took part in its refinement.
        color_correlation: of the colors of both clouds where they overlap, -1 to 1; NaN where they
            were not looked at, or tell nothing.
        color_evidence: logarithm of the likelihood of these colors under the pose by that of
            unrelated ones; NaN as above.
        information: float64 (6, 6), inverse covariance of the pose for a small rotation w
            (radians) followed by a translation v (the user's unit) about ``center_target`` c:
            q = exp(w) (R p + t - c) + c + v. NaN when not refined, like the next two.
        information_similarity: float64 (7, 7): as ``information`` for the first six, then the
            logarithm l of the scale about c: q = e^l exp(w) (s R p + t - c) + c + v. NaN unless
            the scale was searched and the pose refined, like the next.
        scale_constraint: how strongly the surfaces constrain the scale, 0 (not at all, as planes
            and cones) to about 1 (a sphere).
        hessian_eigenvalues: float64 (6,), ascending: how strongly the matched surfaces constrain
            the pose, from 0 for a motion along the surfaces to about 1.
        hessian_eigenvectors: float64 (6, 6), row i a unit vector for eigenvalue i: rotation, as
            arc length at the surfaces' radius, then translation.
        unconstrained_directions: how many of the six are not constrained; None when not refined.
        settings: every setting, as keyword arguments that repeat the run:
            ``register(source, target, **result.settings)``.
    """

    transformation: Floats
    scale: float
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
    strays_source: int
    strays_target: int
    sparse_source: int
    sparse_target: int
    dense_source: int
    dense_target: int
    correspondences: int
    correspondences_found: int
    tims: int
    tims_pruned: int
    queries: dict[str, int]
    normalization_scale: float
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
    surface_fit: float
    surface_near: float
    violation: float
    evidence: float
    scale_factor: float
    score_gap: float
    seeds: int
    candidates: int
    used_fallback_search: bool
    refined: bool
    alternatives: list[Alternative]
    symmetry: str
    symmetry_order: int
    symmetry_axis: Floats
    symmetry_period: float
    used_colors: bool
    color_correlation: float
    color_evidence: float
    information: Floats
    information_similarity: Floats
    scale_constraint: float
    hessian_eigenvalues: Floats
    hessian_eigenvectors: Floats
    unconstrained_directions: int | None
    settings: dict[str, Any]

    @property
    def rotation(self) -> Floats:
        """R, float64 (3, 3)."""
        return np.asarray(self.transformation[:3, :3] / self.scale)

    @property
    def translation(self) -> Floats:
        """t, float64 (3,), the user's unit."""
        return np.array(self.transformation[:3, 3])

    def apply(self, points: Any) -> Floats:
        """Moves points from the source's into the target's frame.

        Args:
            points: a cloud as :func:`pyemtr.register` takes it; of a :class:`pyemtr.Cloud` all
                points, if it keeps them.

        Returns:
            float64 (N, 3), a row for each point that was given.

        Raises:
            TypeError, ValueError: as :func:`pyemtr.register` for a cloud, and for a mesh, which
                moves by its own method.
        """
        if mesh_of(points, "points") is not None:
            raise TypeError(
                "points: a mesh moves by its own method: give result.transformation to"
                " apply_transform() of trimesh or transform() of Open3D and PyVista"
            )
        source = as_points(points, "points").astype(np.float64)
        return np.asarray(source @ self.transformation[:3, :3].T + self.transformation[:3, 3])

    def inverse(self) -> Floats:
        """Returns the transformation of the target into the source, p = R^T (q - t) / s: float64
        (4, 4). All NaN where no pose was known."""
        inverse = np.eye(4)
        inverse[:3, :3] = self.rotation.T / self.scale
        inverse[:3, 3] = -inverse[:3, :3] @ self.transformation[:3, 3]
        return inverse

    @property
    def covariance(self) -> Floats | None:
        """The covariance of the pose: float64 (6, 6), the inverse of ``information``; None when the
        pose was not refined, or the surfaces leave a direction unconstrained.

        Rows and columns are w_x, w_y, w_z, v_x, v_y, v_z in the target's axes: a small rotation w
        about ``center_target`` (radians), and then a translation v (the user's unit). So the blocks
        are in radians squared, radians times the unit, and the unit squared. It tells of the noise
        of single points, not of a wrong pose, which ``confidence`` does.
        """
        scale = np.sqrt(np.diag(self.information))  # rows of one size, whatever the unit
        if self.unconstrained_directions or not (np.isfinite(scale).all() and scale.all()):
            return None
        try:
            inverse = np.linalg.inv(self.information / np.outer(scale, scale))
        except np.linalg.LinAlgError:
            return None
        return np.asarray((inverse + inverse.T) / 2 / np.outer(scale, scale))

    def residuals(
        self,
        source: Any,
        target: Any,
        *,
        of: str = "source",
        threads: int = 0,
        mesh_points: int = MESH_POINTS,
    ) -> Floats:
        """Returns the distance of each moved source point to the nearest target point: float64
        (N,), or with ``of="target"`` of each target point to the nearest moved source point, (M,).

        Arguments and errors are those of :func:`pyemtr.residuals`, which this calls with the
        result's transformation. Raises ValueError when that is NaN.
        """
        return residuals(
            source, target, self.transformation, of=of, threads=threads, mesh_points=mesh_points
        )

    def to_html(
        self,
        path: str | os.PathLike[str],
        source: Any,
        target: Any,
        *,
        title: str = "",
        names: Sequence[str] | None = None,
        unit: str = "",
        up: Sequence[float] | None = None,
        max_points: int = 30_000,
        threads: int = 0,
        mesh_points: int = MESH_POINTS,
    ) -> None:
        """Writes a page to look at: both clouds in three dimensions before and after, the error
        map, the verdict with what to try, the alternatives, residuals, convergence, times and
        settings. One file for any browser with WebGL; it loads nothing. ``pcl_emtr --html`` writes
        the same.

        Args:
            path: file to write, whole or not at all.
            source, target: the clouds that were registered, as :func:`pyemtr.register` takes them.
                Points with a NaN or an infinity, and strays, are not shown.
            title: above the page; empty for the names of the clouds.
            names: of the source and the target; None for the names of their files.
            unit: name of the clouds' unit, for the scale bar and the distances.
            up: direction (3,) in the target's frame that is up on the screen; None: the ``axis``
                that the registration was given, or z.
            max_points: of each cloud that are shown, 1 to 100000, evenly spread in space. Their
                distances are measured to all points of the target.
            threads: 0 for as many as OpenMP would use; the page does not depend on it.
            mesh_points: as in :func:`pyemtr.register`.

        Raises:
            TypeError, ValueError: not a cloud, no finite point, or an argument out of range.
            OSError: a file cannot be read or written.
        """
        from .html import page_payload, write_page

        payload = page_payload(
            self, source, target, title=title, names=names, unit=unit, up=up,
            max_points=max_points, threads=threads, mesh_points=mesh_points,
        )  # fmt: skip
        write_page(payload, path)

    def to_dict(self) -> dict[str, Any]:
        """Returns all fields as JSON values: lists for arrays, None for NaN and infinities, a dict
        with the attributes for each alternative."""
        return to_json(vars(self))

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Result:
        """Returns the result that :meth:`to_dict` wrote, also by way of a JSON file. An infinity
        comes back as NaN; all else has the same bits.

        Raises:
            TypeError: not a dict.
            ValueError: a field is missing, or is not of its type and shape.
        """
        return _result(from_json(values, {field.name: str(field.type) for field in fields(cls)}))

    def _repr_html_(self) -> str:
        """The verdict, with the confidence and the overlap as bars, as notebooks show it."""
        return html_of(self)

    def __repr__(self) -> str:
        verdict = "registered" if self.registered else f"not registered ({self.reason_text})"
        rows = np.array2string(self.transformation, precision=6, suppress_small=True, prefix="    ")
        return (
            f"<pyemtr.Result: {verdict}{self._confidence_text()}\n"
            f"  fitness {self.fitness:.4f}, fitness gap {self.fitness_gap:.4f}\n"
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
    """Returns a Result made of the extension's values, by the library's table of the fields."""
    values: dict[str, Any] = {}
    for name, group, key, kind, rows, columns in _emtr.describe_result():
        value = _field(raw[name], kind, rows, columns)
        if key != name:
            values.setdefault(ATTRIBUTES.get(group, group), {})[key] = value
        elif kind == "reason":
            values[name], values[f"{name}_text"] = value
        else:
            values[name] = value
    return _result({"settings": settings, **values})


def _result(values: dict[str, Any]) -> Result:
    """Returns a Result with these attributes, those too that the class does not declare: a library
    that is newer may have more."""
    declared = {field.name: values[field.name] for field in fields(Result)}
    result = Result(**declared)
    vars(result).update(values)
    return result


def as_alternative(values: Sequence[Any]) -> Alternative:
    """Returns an alternative made of the extension's values."""
    pose, *numbers = values
    return Alternative(_matrix(pose, 4), *numbers)


def _field(value: Any, kind: str, rows: int, columns: int) -> Any:
    if kind == "alternative":
        return [as_alternative(values) for values in value]
    if not isinstance(value, list):
        return value
    return _matrix(value, rows) if rows > 1 else _vector(value)


def _vector(values: Any) -> NDArray[np.float64]:
    return np.array(values, dtype=np.float64)


def _matrix(values: Any, rows: int) -> NDArray[np.float64]:
    return _vector(values).reshape(rows, -1)
