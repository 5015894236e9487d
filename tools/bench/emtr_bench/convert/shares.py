"""How much two clouds share under a pose, and the tier that this puts them in."""

from __future__ import annotations

import sys

from ..locations import TOOLS
from ..pairs import Array
from ..protocol import apply

sys.path.insert(0, str(TOOLS))  # where the measure is
from virtual_scan.overlap import overlap, resolution

#: Larger clouds are thinned to about so many points; the share is of points within twice the
#: distance of neighbors, which grows with the thinning.
MOST_POINTS = 20000


def overlaps(source: Array, target: Array, T: Array) -> tuple[float, float]:
    """The share of each cloud that has the other within twice the mean resolution."""
    a, b = apply(T, _thinned(source)), _thinned(target)
    radius = 2 * max(resolution(a), resolution(b))
    return overlap(a, b, radius, sample=1000), overlap(b, a, radius, sample=1000)


def tier_of(shares: tuple[float, float]) -> str:
    """By the smaller share."""
    least = min(shares)
    return "standard" if least >= 0.45 else "low-overlap" if least >= 0.2 else "extreme"


def _thinned(points: Array) -> Array:
    return points[:: max(1, -(-len(points) // MOST_POINTS))]
