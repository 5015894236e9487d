"""The joint refinement: all scans of a model at once, each point to the planes of the others."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from ..arrays import Floats
from ..neighborhood import neighbor_tree, subsampled
from .rigid import exponential, inverse, moved, orthonormal
from .scans import Extent
from .surface import Surface

_SAMPLE = 2000  # points of a scan that look for the planes of the others
_ROUNDS = 14
_FARTHEST, _NEAREST = 0.03, 0.006  # how far a plane may be in the first and the last rounds, radii
_PARALLEL = 0.7  # least cosine between the normals of a point and its plane
_SPACINGS = 1.5  # of the other scan, within which a nearest point is a neighbor
_FEWEST = 50  # points of a pair of scans that are near each other
_DONE = 1e-6  # radians and radii


def refine_jointly(
    poses: Mapping[int, Floats],
    surfaces: Mapping[int, Surface],
    radius: float,
    reference: int,
    threads: int,
    weights: Mapping[tuple[int, int], float],
) -> dict[int, Floats]:
    """Returns poses of which the surfaces of all scans lie on each other best.

    Gauss-Newton steps over all poses at once minimize the distances between each scan's points and
    their nearest points of all other scans, along the mean of the normals there (the symmetric
    objective of Rusinkiewicz, 2019), by the estimator of Geman and McClure, whose width shrinks.

    Args:
        poses: by scan, scan -> frame of the reference, which stays where it is.
        surfaces: of these scans.
        radius: the unit of how far a plane may be.
        reference: a scan of ``poses``.
        threads: pairs of scans that are matched at a time; the poses do not depend on it.
        weights: of pairs of scans, in either order. Scans that overlap little pull each other to a
            wrong place, so others should weigh more; pairs that are not there are left out.
    """
    scans = sorted(poses)
    found = {scan: pose.copy() for scan, pose in poses.items()}
    trees = {scan: neighbor_tree(surfaces[scan].points) for scan in scans}
    samples = {scan: _sample(surfaces[scan]) for scan in scans}
    centers = [moved(poses[scan], surfaces[scan].points).mean(axis=0) for scan in scans]
    middle = Extent(np.mean(centers, axis=0), radius)
    with ThreadPoolExecutor(max_workers=threads) as workers:
        for passed in range(_ROUNDS):
            reach = radius * max(_FARTHEST * (_NEAREST / _FARTHEST) ** (passed / 8), _NEAREST)
            jobs = [
                workers.submit(_equations, a, b, found, samples, surfaces, trees, reach, middle)
                for pair in sorted(weights)
                for a, b in (pair, pair[::-1])
            ]
            step = _step(scans, reference, [_weighed(job.result(), weights) for job in jobs])
            for scan, motion in step.items():
                found[scan] = orthonormal(_applied(motion, middle) @ found[scan])
            largest = max((float(np.abs(motion).max()) for motion in step.values()), default=0.0)
            if largest < _DONE and passed >= 8:
                break
    return found


_Equations = tuple[int, int, Floats, Floats]  # a, b, and the normal equations


def _weighed(
    equations: _Equations | None, weights: Mapping[tuple[int, int], float]
) -> _Equations | None:
    if equations is None:
        return None
    a, b, block, right = equations
    weight = weights[a, b] if (a, b) in weights else weights[b, a]
    return a, b, weight * block, weight * right


def _sample(surface: Surface) -> tuple[Floats, Floats]:
    rows = subsampled(np.arange(len(surface.points), dtype=np.float64), _SAMPLE).astype(np.int64)
    return surface.points[rows], surface.normals[rows]


def _equations(
    a: int,
    b: int,
    poses: Mapping[int, Floats],
    samples: Mapping[int, tuple[Floats, Floats]],
    surfaces: Mapping[int, Surface],
    trees: Mapping[int, Any],
    reach: float,
    middle: Extent,
) -> _Equations | None:
    """Returns the normal equations of the points of a on the planes of b, (6, 6) and (6,), of the
    motion of a against b; None where the scans are not near each other."""
    points, normals = samples[a]
    between = inverse(poses[b]) @ poses[a]
    there = moved(between, points)
    farthest = max(reach, _SPACINGS * surfaces[b].spacing)
    distances, nearest = trees[b].query(there, distance_upper_bound=farthest)
    near = np.flatnonzero(np.isfinite(distances))
    own, planes = normals[near] @ between[:3, :3].T, surfaces[b].normals[nearest[near]]
    cosines = np.einsum("ij,ij->i", own, planes)
    facing = np.abs(cosines) > _PARALLEL
    near, own, planes = near[facing], own[facing], planes[facing]
    if len(near) < _FEWEST:
        return None
    # The mean of both normals: on a curved surface, the plane of one of them is off by the
    # distance along the surface squared.
    planes = planes + np.sign(cosines[facing])[:, None] * own
    planes /= np.linalg.norm(planes, axis=1, keepdims=True)
    offsets = there[near] - surfaces[b].points[nearest[near]]
    residuals = np.einsum("ij,ij->i", offsets, planes) / middle.radius
    width = 0.3 * reach / middle.radius
    weights = (width**2 / (width**2 + residuals**2)) ** 2
    planes = planes @ poses[b][:3, :3].T
    arms = (moved(poses[a], points[near]) - middle.center) / middle.radius
    rows = np.concatenate([np.cross(arms, planes), planes], axis=1)
    weighted = rows * weights[:, None]
    return a, b, weighted.T @ rows, weighted.T @ residuals


def _step(
    scans: list[int], reference: int, equations: list[_Equations | None]
) -> dict[int, Floats]:
    """Returns the motion (6,) of each scan but the reference: rotation, translation in radii."""
    place = {scan: 6 * i for i, scan in enumerate(scans)}
    size = 6 * len(scans)
    matrix, vector = np.zeros((size, size)), np.zeros(size)
    for one in equations:
        if one is None:
            continue
        a, b, block, right = one
        i, j = slice(place[a], place[a] + 6), slice(place[b], place[b] + 6)
        matrix[i, i] += block
        matrix[j, j] += block
        matrix[i, j] -= block
        matrix[j, i] -= block
        vector[i] -= right
        vector[j] += right
    kept = [k for scan in scans if scan != reference for k in range(place[scan], place[scan] + 6)]
    reduced = matrix[np.ix_(kept, kept)]
    # What the surfaces do not constrain stays where the pose graph has put it.
    damping = 1e-4 * np.trace(reduced) / max(len(kept), 1) + 1e-12
    solved = np.linalg.solve(reduced + damping * np.eye(len(kept)), vector[kept])
    moving = [scan for scan in scans if scan != reference]
    return {scan: solved[6 * i : 6 * i + 6] for i, scan in enumerate(moving)}


def _applied(motion: Floats, middle: Extent) -> Floats:
    """Returns the matrix of a motion about the center whose translation is in radii."""
    scaled = np.concatenate([motion[:3], middle.radius * motion[3:]])
    matrix = exponential(scaled)
    matrix[:3, 3] += middle.center - matrix[:3, :3] @ middle.center
    return matrix
