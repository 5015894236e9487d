"""Open3D: RANSAC on FPFH, and point-to-plane ICP.

Radii, checkers and criteria are those that its tutorial on global registration recommends,
in multiples of the voxel.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import open3d

from .methods import Array, Task

_registration = open3d.pipelines.registration
open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Error)

NORMAL_RADIUS, NORMAL_NEIGHBORS = 2.0, 30
FEATURE_RADIUS, FEATURE_NEIGHBORS = 5.0, 100
RANSAC_DISTANCE, ICP_DISTANCE = 1.5, 1.0
EDGE_LENGTH_SIMILARITY = 0.9
RANSAC_POINTS, RANSAC_ITERATIONS, RANSAC_CONFIDENCE = 3, 100000, 0.999


def ransac(source: Array, target: Array, task: Task) -> Array:
    open3d.utility.random.seed(task.seed)
    (a, a_features), (b, b_features) = (with_features(cloud, task) for cloud in (source, target))
    distance = RANSAC_DISTANCE * task.voxel
    result = _registration.registration_ransac_based_on_feature_matching(
        a, b, a_features, b_features, True, distance,
        _registration.TransformationEstimationPointToPoint(False), RANSAC_POINTS,
        [_registration.CorrespondenceCheckerBasedOnEdgeLength(EDGE_LENGTH_SIMILARITY),
         _registration.CorrespondenceCheckerBasedOnDistance(distance)],
        _registration.RANSACConvergenceCriteria(RANSAC_ITERATIONS, RANSAC_CONFIDENCE),
    )  # fmt: skip
    return np.array(result.transformation)


def point_to_plane_icp(source: Array, target: Array, start: Array, task: Task) -> Array:
    """On the full clouds, or downsampled by task.refine_voxel; the target's normals are made here
    and count."""
    a, b = _cloud(source), _cloud(target)
    if task.refine_voxel is not None:
        a, b = (cloud.voxel_down_sample(task.refine_voxel) for cloud in (a, b))
    radius = NORMAL_RADIUS * (task.refine_voxel or task.voxel)
    b.estimate_normals(_neighborhood(radius, NORMAL_NEIGHBORS))
    result = _registration.registration_icp(
        a, b, ICP_DISTANCE * task.voxel, start,
        _registration.TransformationEstimationPointToPlane(),
    )  # fmt: skip
    return np.array(result.transformation)


def with_features(points: Array, task: Task, oriented: bool = False) -> tuple[Any, Any]:
    """The downsampled cloud and its FPFH; ``oriented``: with normals towards the centroid."""
    cloud = _cloud(points).voxel_down_sample(task.voxel)
    cloud.estimate_normals(_neighborhood(NORMAL_RADIUS * task.voxel, NORMAL_NEIGHBORS))
    if oriented:
        cloud.orient_normals_towards_camera_location(cloud.get_center())
    radius = FEATURE_RADIUS * task.voxel
    return cloud, _registration.compute_fpfh_feature(
        cloud, _neighborhood(radius, FEATURE_NEIGHBORS)
    )


def _cloud(points: Array) -> Any:
    return open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))


def _neighborhood(radius: float, most: int) -> Any:
    return open3d.geometry.KDTreeSearchParamHybrid(radius, most)
