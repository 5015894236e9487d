"""When two poses of a pair are the same pose."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats
from .rigid import angle

#: Two poses agree within this rotation, degrees, and this distance of the source's centroid, in
#: radii. A registered pose is meant to be right within 5 degrees and 0.06 radii; the alternatives
#: are more than 10 degrees or 0.15 radii from each other.
DEGREES, RADII = 5.0, 0.075


def differences(poses: Floats, others: Floats, center: Floats) -> tuple[Floats, Floats]:
    """Returns how far poses (..., 4, 4) are from others (..., 4, 4): the angle in degrees, and the
    distance of where they put the center, in its unit. The shapes are broadcast."""
    rotation = np.einsum("...ji,...jk->...ik", poses[..., :3, :3], others[..., :3, :3])
    apart = (poses[..., :3, :3] - others[..., :3, :3]) @ center
    apart = apart + poses[..., :3, 3] - others[..., :3, 3]
    return angle(rotation), np.asarray(np.linalg.norm(apart, axis=-1))


def agree(
    poses: Floats, others: Floats, center: Floats, radius: float, slack: float = 1.0
) -> NDArray[np.bool_]:
    """Tells which poses agree within `slack` times the tolerance."""
    degrees, distance = differences(poses, others, center)
    return np.asarray((degrees <= slack * DEGREES) & (distance <= slack * RADII * radius))
