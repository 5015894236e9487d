"""Loop consistency: what the loops over three scans say about each hypothesis.

Of three scans i, j and k, poses of (i, k) and (k, j) predict a pose of (i, j). A right pose is
predicted again and again, and a wrong one only by chance. So each loop multiplies the odds of a
hypothesis: by what a prediction of probability p would make of them where it agrees, and by 1 - p
where no prediction does.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import numpy as np

from ..arrays import Floats
from .comparison import agree
from .hypothesis import LEAST, MOST, Hypothesis
from .scans import Extent

#: Probability that a wrong pose agrees with a wrong prediction.
CHANCE = 0.02
_LOOP = 3.0  # the most that one loop adds to the logarithm of the odds, or takes from it
_ALL = 8.0  # the most that all loops of a hypothesis do
_IGNORED = 0.003  # hypotheses that are less probable predict nothing

Pairs = Mapping[tuple[int, int], Sequence[Hypothesis]]


def loop_probabilities(pairs: Pairs, extents: Sequence[Extent], radius: float) -> list[Floats]:
    """Returns the probability of each hypothesis, with the evidence of all loops over three scans.

    Args:
        pairs: the hypotheses of each pair (source, target), source > target.
        extents: of the scans.
        radius: the unit of the tolerance.

    Returns:
        For each pair, in the order of ``pairs``, float64 (hypotheses,).
    """
    votes = {pair: np.zeros(len(found)) for pair, found in pairs.items()}
    sides = {pair: side for pair, found in pairs.items() if len((side := _Side(found)).rows)}
    scans = sorted({scan for pair in sides for scan in pair})
    for low, middle, high in combinations(scans, 3):
        edges = ((middle, low), (high, middle), (high, low))
        if not all(edge in sides for edge in edges):
            continue
        first, second, third = (sides[edge] for edge in edges)
        # [a, b, c]: whether a of (middle, low) after b of (high, middle) is c of (high, low)
        composed = first.poses[:, None] @ second.poses[None, :]
        closed = agree(composed[:, :, None], third.poses[None, None], extents[high].center, radius)
        p, q, r = (side.probabilities for side in (first, second, third))
        for side, edge, together, axes in (
            (first, edges[0], q[None, :, None] * r[None, None, :], (1, 2)),
            (second, edges[1], p[:, None, None] * r[None, None, :], (0, 2)),
            (third, edges[2], p[:, None, None] * q[None, :, None], (0, 1)),
        ):
            predicted = np.max(closed * together, axis=axes)
            excluded = np.max(together)
            vote = np.where(
                predicted > 0,
                np.log(predicted / CHANCE + 1 - predicted),
                np.log1p(-min(excluded, MOST)),
            )
            votes[edge][side.rows] += np.clip(vote, -_LOOP, _LOOP)
    return [
        _updated(np.array([one.probability for one in found]), votes[pair])
        for pair, found in pairs.items()
    ]


class _Side:
    """The hypotheses of a pair that are probable enough, as arrays."""

    def __init__(self, found: Sequence[Hypothesis]) -> None:
        probabilities = np.array([one.probability for one in found])
        self.rows = np.flatnonzero(probabilities >= _IGNORED)
        self.probabilities = probabilities[self.rows]
        self.poses = np.array([found[int(i)].pose for i in self.rows]).reshape(-1, 4, 4)


def _updated(probabilities: Floats, votes: Floats) -> Floats:
    odds = np.log(probabilities / (1 - probabilities)) + np.clip(votes, -_ALL, _ALL)
    return np.asarray(np.clip(1 / (1 + np.exp(-odds)), LEAST, MOST))
