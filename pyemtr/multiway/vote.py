"""Which pairs of many scans are worth a registration: a vote of coarse descriptors.

A descriptor has the histograms of how the normals around a point are tilted against its own, and of
how high the points around it are over its tangent plane, within two radii. Two scans that share a
surface have descriptors that are each other's nearest, and the points of these matches have the
same distances in both scans. The score of a pair is the largest eigenvalue of the matrix that tells
which matches are so consistent: about the number of matches that agree on one pose.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np

from ..arrays import Floats
from ..neighborhood import neighbor_tree
from .surface import Surface

_KEYPOINTS = 300  # of a scan
_RADII = (0.12, 0.3)  # of a descriptor, in radii of the scans
_BINS = 8
_NEIGHBORS = 200  # points that a histogram counts, at most
_MATCHES = 100  # of a pair, the best
_CONSISTENT = 0.04  # difference of two distances, in radii
_STEPS = 12  # of the power iteration


class Described(NamedTuple):
    """Keypoints of a scan, (K, 3), and their descriptors, (K, D)."""

    points: Floats
    descriptors: Floats


def vote(
    surface: Callable[[int], Surface], count: int, radius: float
) -> dict[tuple[int, int], float]:
    """Returns the score of each pair (source, target), source > target, of ``count`` scans."""
    described = [describe(surface(i), radius) for i in range(count)]
    return {(j, i): score(described[j], described[i], radius)
            for i, j in combinations(range(count), 2)}  # fmt: skip


def best_pairs(
    scores: dict[tuple[int, int], float], count: int, each: int
) -> list[tuple[int, int]]:
    """Returns the ``each`` best pairs of each scan."""
    chosen: set[tuple[int, int]] = set()
    for scan in range(count):
        own = [(-score, pair) for pair, score in scores.items() if scan in pair]
        chosen.update(pair for _, pair in sorted(own)[:each])
    return sorted(chosen)


def describe(surface: Surface, radius: float) -> Described:
    """Returns descriptors of points that are evenly spaced over the rows of a surface."""
    points, normals = surface.points, surface.normals
    rows = np.linspace(0, len(points) - 1, min(_KEYPOINTS, len(points))).astype(np.int64)
    tree = neighbor_tree(points)
    parts = []
    for reach in _RADII:
        width = reach * radius
        found = tree.query_ball_point(points[rows], width, return_sorted=True)
        tilts, heights = np.zeros((len(rows), _BINS)), np.zeros((len(rows), _BINS))
        for k, (row, around) in enumerate(zip(rows, found)):
            near = _evenly(around)
            tilt = np.abs(normals[near] @ normals[row])
            height = np.abs((points[near] - points[row]) @ normals[row]) / width
            tilts[k] = _histogram(tilt)
            heights[k] = _histogram(np.sqrt(height))
        parts += [tilts, heights]
    return Described(points[rows], np.sqrt(np.concatenate(parts, axis=1)))


def score(source: Described, target: Described, radius: float) -> float:
    """Returns about how many matches of two scans agree on one pose."""
    products = source.descriptors @ target.descriptors.T  # the more alike, the larger
    best, back = products.argmax(axis=1), products.argmax(axis=0)
    mutual = np.flatnonzero(back[best] == np.arange(len(best)))
    strength = products[mutual, best[mutual]]
    mutual = mutual[np.argsort(-strength, kind="stable")[:_MATCHES]]
    if len(mutual) < 3:
        return 0.0
    lengths = _distances(source.points[mutual]), _distances(target.points[best[mutual]])
    apart = np.minimum(*lengths) > 2 * _CONSISTENT * radius  # near points agree on any pose
    consistent = (np.abs(lengths[0] - lengths[1]) < _CONSISTENT * radius) & apart
    return _largest_eigenvalue(consistent.astype(np.float64))


def _evenly(near: Sequence[int]) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    rows = np.asarray(near, dtype=np.int64)
    return rows if len(rows) <= _NEIGHBORS else rows[:: len(rows) // _NEIGHBORS]


def _histogram(values: Floats) -> Floats:
    bins = np.minimum((values * _BINS).astype(np.int64), _BINS - 1)
    return np.bincount(bins, minlength=_BINS) / max(len(values), 1)


def _distances(points: Floats) -> Floats:
    return np.asarray(np.linalg.norm(points[:, None] - points[None], axis=2))


def _largest_eigenvalue(matrix: Floats) -> float:
    vector = np.ones(len(matrix)) / np.sqrt(len(matrix))
    size = 0.0
    for _ in range(_STEPS):
        vector = matrix @ vector
        size = float(np.linalg.norm(vector))
        if size == 0:
            return 0.0
        vector /= size
    return size
