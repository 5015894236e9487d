"""A typed program that uses the package; checked by mypy --strict, never run."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import pyemtr


def watch(progress: pyemtr.Progress) -> bool:
    stage: str = progress.stage
    print(progress.fraction / 2)
    return stage == "evolution" and progress.best_alpha < 10 and progress.iteration > 3


def one_call(source: NDArray[np.float32], target: NDArray[np.float64]) -> NDArray[np.float64]:
    result: pyemtr.Result = pyemtr.register(
        source,
        target,
        seed=1,
        threads=2,
        callback=watch,
        iterations=20,
        transfer=False,
        neighbors="grid",
    )
    cost: int = result.queries["evaluation"] + result.queries["switch"]
    seconds: float = result.timings["total"]
    best: NDArray[np.float64] = result.history["alpha"]
    print(result.registered, result.reason.upper(), cost, seconds, best.min(), result.to_dict())
    return result.apply(source) if result.registered else result.transformation


def how_sure(source: NDArray[np.float32], target: NDArray[np.float32]) -> list[float]:
    result = pyemtr.register(
        source,
        target,
        preset="thorough",
        source_viewpoint=(0, 0, 1.5),
        target_viewpoint=np.zeros(3),
        axis=(0, 0, 1),
        axis_tilt=2,
        translation_bounds=(np.zeros(3), (1, 1, 0.5)),
    )
    deviation: NDArray[np.float64] = np.sqrt(np.diag(np.linalg.inv(result.information)))
    free: int = result.unconstrained_directions or 0
    print(
        result.confidence > 0.9,
        result.seeds + result.candidates,
        result.used_fallback_search,
        free,
        deviation.max(),
        result.hessian_eigenvalues.min(),
        result.hessian_eigenvectors[:free],
    )
    others: list[pyemtr.Alternative] = result.alternatives
    for transformation, score, fit, violation, evidence in others:
        print(transformation.shape, result.score - score, result.score_gap)
        print(fit, violation, evidence)
    return [other.score for other in others]


def distances(source: NDArray[np.float32], result: pyemtr.Result) -> NDArray[np.float64]:
    back: NDArray[np.float64] = result.residuals(source, source, of="target", threads=1)
    print(back.max(), result.overlap_source + result.inlier_rmse_plane)
    return pyemtr.residuals(source, source, result.transformation)


def stage_by_stage(source: list[list[float]], target: NDArray[np.int16]) -> pyemtr.Result:
    problem = pyemtr.Problem(source, target, dense_points=1000)
    alpha = pyemtr.TaskAlpha(problem, resolution="sparse")
    beta = pyemtr.TaskBeta(problem)
    low, high = alpha.bounds.T
    particles: NDArray[np.float64] = np.random.default_rng(0).uniform(low, high, (9, 6))
    fitness: NDArray[np.float64] = alpha.evaluate(particles)
    best = particles[fitness.argmin()]
    print(beta.evaluate(particles[:, :3]), problem.complement(best[:3]), problem.tau / 2)
    rows: NDArray[np.int32] = problem.correspondences
    matched: NDArray[np.float32] = problem.source_dense[rows[:, 0]]
    print(problem.to_particle(problem.to_transformation(best)), matched, problem.queries + 1)
    return problem.solve(callback=watch)


def one_against_many(model: NDArray[np.float32], scans: list[NDArray[np.float32]]) -> list[float]:
    cloud = pyemtr.Cloud(model, threads=2)
    print(len(cloud), cloud.dropped + 1, cloud.radius / 2, cloud.center.sum())
    return [pyemtr.register(scan, cloud).fitness for scan in scans]


def in_and_out(path: str, scan: Path, mesh: object) -> pyemtr.Result:
    model = pyemtr.Cloud(mesh, mesh_points=20_000)
    result = pyemtr.register(scan, path, transfer="off", fallback_search="always", refine_leaf=1)
    again = pyemtr.register(model, path, guess=result, **result.settings)
    covariance = again.covariance
    if covariance is not None:
        print(np.sqrt(np.diag(covariance)), again.inverse() @ again.transformation)
    print(pyemtr.residuals(model, path, again).max(), again.apply(model), model.points.dtype)
    return pyemtr.Result.from_dict(result.to_dict())


def one_particle(problem: pyemtr.Problem) -> float:
    return float(problem.evaluate_alpha(np.zeros(6))) + float(problem.evaluate_beta([0, 0, 0]))


def describe() -> str:
    lines = [
        f"{name}: {setting.text} [{setting.minimum}, {setting.maximum}] {setting.default}"
        for name, setting in pyemtr.settings().items()
    ]
    return "\n".join([pyemtr.__version__, *pyemtr.presets(), *lines])


def brought_along(
    source: NDArray[np.float32], target: NDArray[np.float32], codes: NDArray[np.float32]
) -> NDArray[np.int32]:
    model = pyemtr.Cloud(target, normals=target, features=codes, keep_points=True)
    print(model.has_normals, model.keypoints + 1)
    result = pyemtr.register(source, model, source_normals=source, source_features=codes)
    again = pyemtr.register(source, target, correspondences=[[0, 1], [2, 3], [4, 5]])
    print(result.confidence + again.confidence)
    problem = pyemtr.Problem(source, target, source_features=codes, target_features=codes)
    rows: NDArray[np.int32] = problem.source_feature_rows[problem.correspondences[:, 0]]
    return rows
