"""The pose graph of a group, solved by GTSAM with a robust kernel."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ..arrays import Floats
from .hypothesis import Hypothesis
from .information import about_origin, at_source, edge_information
from .rigid import inverse
from .scans import Extent

_CAUCHY = 3.0  # standard deviations from which the kernel gives an edge less weight


class Solved(NamedTuple):
    """Poses of scans (scan -> frame of the reference), and their covariances.

    A covariance is that of a small rotation w (radians) about the scan's centroid and then a
    translation v (the scans' unit), both in the frame's axes: float64 (6, 6), 0 for the reference.
    """

    poses: dict[int, Floats]
    covariances: dict[int, Floats]


def require_gtsam() -> Any:
    """Returns the module gtsam.

    Raises ImportError when it is not installed.
    """
    try:
        import gtsam
    except ImportError as error:
        raise ImportError(
            "align_all() solves its pose graph by GTSAM, and the package gtsam is not installed:"
            " pip install 'pyemtr[align]'"
        ) from error
    return gtsam


def solve(
    poses: dict[int, Floats],
    edges: Sequence[Hypothesis],
    extents: Sequence[Extent],
    radius: float,
    reference: int,
    covariances: bool = False,
) -> Solved:
    """Returns the most probable poses of the scans of ``poses``, from those as the start.

    Args:
        poses: by scan, in any one frame.
        edges: between these scans; they connect all of them.
        extents: of all scans.
        radius: the unit of lengths within, so that any unit of the scans is solved alike.
        reference: the scan whose frame the poses are in.
        covariances: whether they are wanted.
    """
    gtsam = require_gtsam()
    frames = {scan: _centered(extents[scan]) for scan in poses}
    start = inverse(poses[reference])
    graph, values = gtsam.NonlinearFactorGraph(), gtsam.Values()
    for scan, pose in poses.items():
        values.insert(scan, gtsam.Pose3(_scaled(start @ pose @ frames[scan], radius)))
    for edge in edges:
        measured = inverse(frames[edge.target]) @ edge.pose @ frames[edge.source]
        noise = gtsam.noiseModel.Gaussian.Information(_edge_matrix(edge, extents, radius))
        kernel = gtsam.noiseModel.mEstimator.Cauchy.Create(_CAUCHY)
        robust = gtsam.noiseModel.Robust.Create(kernel, noise)
        graph.add(
            gtsam.BetweenFactorPose3(
                edge.target, edge.source, gtsam.Pose3(_scaled(measured, radius)), robust
            )
        )
    fixed = gtsam.noiseModel.Isotropic.Sigma(6, 1e-8)
    graph.add(gtsam.PriorFactorPose3(reference, values.atPose3(reference), fixed))
    parameters = gtsam.LevenbergMarquardtParams()
    parameters.setMaxIterations(50)
    solved = gtsam.LevenbergMarquardtOptimizer(graph, values, parameters).optimize()
    first = _scaled(solved.atPose3(reference).matrix(), 1 / radius) @ inverse(frames[reference])
    found = {}
    for scan in poses:
        pose = _scaled(solved.atPose3(scan).matrix(), 1 / radius) @ inverse(frames[scan])
        found[scan] = np.eye(4) if scan == reference else inverse(first) @ pose
    if not covariances:
        return Solved(found, {})
    marginals = gtsam.Marginals(graph, solved)
    factor = _variance_factor(graph, solved, len(edges), len(poses))
    return Solved(
        found,
        {
            scan: np.zeros((6, 6))
            if scan == reference
            else factor * _in_frame(marginals.marginalCovariance(scan), found[scan], radius)
            for scan in poses
        },
    )


def _centered(extent: Extent) -> Floats:
    """Returns the pose of a frame at the scan's centroid: frame -> scan."""
    pose = np.eye(4)
    pose[:3, 3] = extent.center
    return pose


def _scaled(pose: Floats, unit: float) -> Floats:
    scaled = pose.copy()
    scaled[:3, 3] /= unit
    return scaled


def _edge_matrix(edge: Hypothesis, extents: Sequence[Extent], radius: float) -> Floats:
    """Returns the information of m in measured exp(m), between centered frames, in radii."""
    about = edge_information(edge, radius)
    center = edge.result.center_target - extents[edge.target].center
    measured = edge.pose.copy()
    measured[:3, 3] += edge.pose[:3, :3] @ extents[edge.source].center - extents[edge.target].center
    units = np.diag([1.0] * 3 + [radius] * 3)
    matrix = units @ at_source(about_origin(about, center), measured) @ units
    return np.asarray((matrix + matrix.T) / 2)


def _variance_factor(graph: Any, solved: Any, edges: int, scans: int) -> float:
    """Returns how much larger the variances are than the edges say, by how the loops close: 1 or
    more, and 1 where there is no loop."""
    free = 6 * (edges - (scans - 1))
    return max(1.0, 2 * graph.error(solved) / free) if free > 0 else 1.0


def _in_frame(covariance: Floats, pose: Floats, radius: float) -> Floats:
    carried = np.zeros((6, 6))
    carried[:3, :3] = pose[:3, :3]
    carried[3:, 3:] = radius * pose[:3, :3]
    made = carried @ covariance @ carried.T
    return np.asarray((made + made.T) / 2)
