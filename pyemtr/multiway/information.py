"""Information matrices of edges, from one convention to another.

The library has rotations about the target's centroid c, in the target's axes:
q = exp(w) (R p + t - c) + c + v. A pose graph wants a small motion m of the source in its own
frame: pose exp(m).
"""

from __future__ import annotations

import numpy as np

from ..arrays import Floats
from .hypothesis import Hypothesis
from .rigid import adjoint, cross_matrix

#: The library's matrix takes the errors of points for independent. They are not: an edge is off by
#: about ten times as much where scans overlap little, on generated scans with known poses.
CORRELATION = 10.0
#: An error that every edge has besides: standard deviations in degrees and radii.
FLOOR_DEGREES, FLOOR_RADII = 0.02, 0.0005
#: Standard deviations of a pose that comes without a matrix, as alternatives do.
LOOSE_DEGREES, LOOSE_RADII = 1.0, 0.02


def edge_information(edge: Hypothesis, radius: float) -> Floats:
    """Returns the information (6, 6) of a small motion (w, v) of the edge about the target's
    centroid in the target's axes, radians and the scans' unit, with the error that every edge has.
    Directions that the surfaces do not constrain have almost none."""
    units = _diagonal(1.0, radius)
    information = edge.result.information
    if edge.rank or not np.isfinite(information).all():
        loose = _diagonal(np.radians(LOOSE_DEGREES), LOOSE_RADII * radius)
        return np.asarray(np.linalg.inv(loose @ loose))
    values, vectors = np.linalg.eigh(units @ information @ units)
    # A radian and a radius: nothing is known.
    variances = np.minimum(CORRELATION**2 / np.maximum(values, 1.0), 1.0)
    covariance = vectors @ np.diag(variances) @ vectors.T
    covariance += _diagonal(np.radians(FLOOR_DEGREES), FLOOR_RADII) ** 2
    inverted = np.linalg.inv(units @ covariance @ units)
    return np.asarray((inverted + inverted.T) / 2)


def precision(edge: Hypothesis, radius: float) -> float:
    """Returns the smallest information of the edge in any direction, radians and radii."""
    units = _diagonal(1.0, radius)
    return float(np.linalg.eigvalsh(units @ edge_information(edge, radius) @ units)[0])


def about_origin(information: Floats, center: Floats) -> Floats:
    """Returns the information of a motion about the origin for one about the center: the motion
    (w, v) about c is (w, v + c x w) about the origin, in the same axes."""
    change = np.eye(6)
    change[3:, :3] = -cross_matrix(center)
    return np.asarray(change.T @ information @ change)


def at_source(information: Floats, pose: Floats) -> Floats:
    """Returns the information of m in pose exp(m) for that of n in exp(n) pose."""
    carried = adjoint(pose)
    return np.asarray(carried.T @ information @ carried)


def _diagonal(rotation: float, translation: float) -> Floats:
    return np.diag([rotation] * 3 + [translation] * 3)
