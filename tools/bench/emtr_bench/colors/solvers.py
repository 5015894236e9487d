"""What registers a case: emtr with and without colors, and Open3D."""

from __future__ import annotations

import importlib
import importlib.util
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

import pyemtr

from .paint import Array
from .scenes import Case


@dataclass(frozen=True)
class Answer:
    pose: Array  # (4, 4)
    registered: bool
    reason: str
    seconds: float
    evidence: float = float("nan")  # of the colors


Solver = Callable[[Case], Answer]


def emtr_solver(preset: str, threads: int, use_colors: str) -> Solver:
    def solve(case: Case) -> Answer:
        start = time.perf_counter()
        result = pyemtr.register(
            case.source,
            case.target,
            source_colors=case.source_colors,
            target_colors=case.target_colors,
            source_intensity=case.source_intensity,
            target_intensity=case.target_intensity,
            preset=preset,
            threads=threads,
            use_colors=use_colors,  # type: ignore[arg-type]
        )
        seconds = time.perf_counter() - start
        return Answer(result.transformation, result.registered, result.reason, seconds,
                      result.color_evidence)  # fmt: skip

    return solve


def open3d_solver(starts_true: bool = False) -> Solver | None:
    """RANSAC on FPFH, then colored ICP at three scales, as Open3D's tutorials do; or colored ICP
    from the true pose, which tells how precise it can be. None where it is not installed."""
    if importlib.util.find_spec("open3d") is None:
        return None
    open3d: Any = importlib.import_module("open3d")
    methods: Any = importlib.import_module("emtr_bench.peers.open3d_methods")
    registration = open3d.pipelines.registration

    def cloud(points: Array, colors: Array | None, intensity: Array | None) -> Any:
        made = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
        if intensity is not None:
            shade = np.clip(intensity / np.percentile(intensity, 95), 0, 1)
            colors = np.repeat(shade[:, None], 3, axis=1)
        made.colors = open3d.utility.Vector3dVector(colors)
        return made

    def solve(case: Case) -> Answer:
        start = time.perf_counter()
        extent = float(np.linalg.norm(np.ptp(case.target, axis=0)))
        task = methods.Task(voxel=extent / 50, threads=1, seed=0)
        pose = case.truth if starts_true else methods.ransac(case.source, case.target, task)
        a = cloud(case.source, case.source_colors, case.source_intensity)
        b = cloud(case.target, case.target_colors, case.target_intensity)
        for voxel in (extent / 50, extent / 100, extent / 200):
            pair = [one.voxel_down_sample(voxel) for one in (a, b)]
            for one in pair:
                one.estimate_normals(open3d.geometry.KDTreeSearchParamHybrid(2 * voxel, 30))
            try:
                result = registration.registration_colored_icp(
                    *pair, voxel, pose, registration.TransformationEstimationForColoredICP()
                )
            except RuntimeError:  # no correspondences
                break
            pose = np.array(result.transformation)
        return Answer(pose, False, "", time.perf_counter() - start)

    return solve
