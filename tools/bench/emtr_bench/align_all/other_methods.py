"""Other ways to align many scans. Needs open3d or kiss_matcher."""

from __future__ import annotations

import importlib
from time import perf_counter, process_time
from types import SimpleNamespace
from typing import Any

import numpy as np

from pyemtr.multiway.scans import Scans
from pyemtr.multiway.stages import Stages

from ..pairs import Array
from .methods import Answer, Method, all_pairs
from .scenes import Scene

_VOXEL = 0.02  # of the scans' median radius, as its tutorial's 2 cm in a room of some meters
_FITNESS = 0.3  # share of a scan's points that are near the other one, for an edge to be taken


def open3d(scene: Scene, threads: int, seed: int) -> Answer:
    """Open3D's multiway registration, with a global registration of each pair for the guess that
    its tutorial has from a sequence. It has no verdict: pairs of little fitness are left out."""
    o3d = importlib.import_module("open3d")
    registration = o3d.pipelines.registration
    o3d.utility.random.seed(seed)
    begin, cpu = perf_counter(), process_time()
    voxel = _VOXEL * radius_of(scene)
    clouds, features = [], []
    for points in scene.clouds:
        cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points)).voxel_down_sample(voxel)
        cloud.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(2 * voxel, 30))
        clouds.append(cloud)
        features.append(registration.compute_fpfh_feature(
            cloud, o3d.geometry.KDTreeSearchParamHybrid(5 * voxel, 100)))  # fmt: skip
    graph = registration.PoseGraph()
    pairs: dict[tuple[int, int], tuple[Array, Any]] = {}
    for source, target in all_pairs(len(clouds)):
        rough = registration.registration_ransac_based_on_feature_matching(
            clouds[source], clouds[target], features[source], features[target], True, 1.5 * voxel,
            registration.TransformationEstimationPointToPoint(False), 3,
            [registration.CorrespondenceCheckerBasedOnEdgeLength(0.9),
             registration.CorrespondenceCheckerBasedOnDistance(1.5 * voxel)],
            registration.RANSACConvergenceCriteria(100000, 0.999))  # fmt: skip
        fine = registration.registration_icp(
            clouds[source], clouds[target], 1.5 * voxel, rough.transformation,
            registration.TransformationEstimationPointToPlane())  # fmt: skip
        if fine.fitness >= _FITNESS:
            information = registration.get_information_matrix_from_point_clouds(
                clouds[source], clouds[target], 1.5 * voxel, fine.transformation)  # fmt: skip
            pairs[source, target] = fine.transformation, information
    start = _spanned(len(clouds), {pair: T for pair, (T, _) in pairs.items()})
    for pose in start:
        graph.nodes.append(registration.PoseGraphNode(np.eye(4) if pose is None else pose))
    for (source, target), (T, information) in pairs.items():
        graph.edges.append(registration.PoseGraphEdge(source, target, T, information, True))
    registration.global_optimization(
        graph,
        registration.GlobalOptimizationLevenbergMarquardt(),
        registration.GlobalOptimizationConvergenceCriteria(),
        registration.GlobalOptimizationOption(1.5 * voxel, 0.25, 1.0, 0),
    )
    seconds, cpu = perf_counter() - begin, process_time() - cpu
    poses = [None if pose is None else np.asarray(node.pose)
             for pose, node in zip(start, graph.nodes)]  # fmt: skip
    return Answer(poses, [None if pose is None else 0 for pose in poses], seconds, cpu)


def kiss(scene: Scene, threads: int, seed: int) -> Answer:
    """The pairs of KISS-Matcher with emtr's loops and graph. It gives no confidence: a pair has the
    probability 0.9 with 20 final inliers or more, else 0.1."""
    matcher_module = importlib.import_module("kiss_matcher")
    begin, cpu = perf_counter(), process_time()
    scans = Scans(scene.clouds, None, 1000)
    unit = 1.0 / (_VOXEL * radius_of(scene)) * 0.3  # its default voxel is 0.3
    clouds = [np.asarray(unit * (cloud - cloud.mean(axis=0)), dtype=np.float32)
              for cloud in scene.clouds]  # fmt: skip
    stages = Stages(scans, radius_of(scene), threads)
    results = {}
    for source, target in all_pairs(len(clouds)):
        matcher = matcher_module.KISSMatcher(matcher_module.KISSMatcherConfig(0.3))
        found = matcher.estimate(clouds[source], clouds[target])
        T = np.eye(4)
        T[:3, :3] = found.rotation
        centers = [scene.clouds[i].mean(axis=0) for i in (source, target)]
        T[:3, 3] = np.ravel(found.translation) / unit + centers[1] - T[:3, :3] @ centers[0]
        sure = matcher.get_num_final_inliers() >= 20
        results[source, target] = SimpleNamespace(
            transformation=T, confidence=0.9 if sure else 0.1, registered=sure, alternatives=[],
            score=0.0, reason="", information=np.full((6, 6), np.nan), center_target=centers[1],
        )  # fmt: skip
    stages.add(results)
    stages.group()
    stages.finish(True)
    result = stages.result(perf_counter() - begin)
    poses = [scan.pose if scan.placed else None for scan in result.scans]
    models = [scan.model for scan in result.scans]
    return Answer(poses, models, result.seconds, process_time() - cpu)


def radius_of(scene: Scene) -> float:
    """The median radius of the scans."""
    return float(np.median([np.linalg.norm(c - c.mean(axis=0), axis=1).max()
                            for c in scene.clouds]))  # fmt: skip


def _spanned(count: int, pairs: dict[tuple[int, int], Array]) -> list[Array | None]:
    """Poses along the edges from the scan that has most of them; None where none leads."""
    first = max(range(count), key=lambda scan: sum(scan in pair for pair in pairs))
    poses: list[Array | None] = [None] * count
    poses[first] = np.eye(4)
    for _ in range(count):
        for (source, target), T in pairs.items():
            at_source, at_target = poses[source], poses[target]
            if at_source is None and at_target is not None:
                poses[source] = at_target @ T
            elif at_target is None and at_source is not None:
                poses[target] = at_source @ np.linalg.inv(T)
    return poses


METHODS: dict[str, Method] = {"open3d": open3d, "kiss": kiss}
