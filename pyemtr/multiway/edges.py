"""The edges of the pose graph: one for each pair that was tried, and why it was taken or not."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Floats
from ..result import Result
from .comparison import differences
from .grouping import Group
from .hypothesis import Hypothesis
from .information import edge_information
from .pairwise import Pair
from .rigid import inverse
from .scans import Extent


@dataclass(frozen=True, eq=False)
class Edge:
    """A pair of scans that was registered.

    Attributes:
        source, target: indices of the scans.
        transformation: float64 (4, 4), source into target, q = R p + t, in the scans' unit: of an
            edge that was taken the one that was, else the pair's most probable one. All NaN when
            there is none.
        taken: whether the pose graph has it.
        why: why it was taken, or why not.
        alternative: 0 for the registration's answer, i for its i-th alternative.
        confidence: of the registration, of the pair alone.
        probability: of ``transformation``, with the evidence of the loops.
        loops: how many scans close a loop over taken edges with this pair.
        degrees, distance: from ``transformation`` to the final poses: the angle, and the distance
            of the source's centroid, in the scans' unit; NaN where the scans are not in one model.
        information: float64 (6, 6), of a small rotation w (radians) about the target's centroid
            ``center_target`` and then a translation v, in the target's axes, as
            :attr:`pyemtr.Result.information`, with the error that each edge has besides.
        center_target: float64 (3,).
        registered, reason: of the registration.
    """

    source: int
    target: int
    transformation: Floats
    taken: bool
    why: str
    alternative: int
    confidence: float
    probability: float
    loops: int
    degrees: float
    distance: float
    information: Floats
    center_target: Floats
    registered: bool
    reason: str


def all_edges(
    results: Mapping[Pair, Result],
    found: Mapping[Pair, Sequence[Hypothesis]],
    probabilities: Mapping[Hypothesis, float],
    models: Sequence[Group],
    extents: Sequence[Extent],
    radius: float,
) -> list[Edge]:
    """Returns an edge for each pair, in the order of the pairs."""
    taken = {(one.source, one.target): one for model in models for one in model.edges}
    model_of = {scan: i for i, model in enumerate(models) for scan in model.poses}
    edges = []
    for pair in sorted(results):
        result, one = results[pair], taken.get(pair)
        shown = one or max(found[pair], key=lambda h: probabilities[h], default=None)
        where = [model_of.get(scan) for scan in pair]
        degrees = distance = float("nan")
        if shown and where[0] is not None and where[0] == where[1]:
            poses = models[where[0]].poses
            implied = inverse(poses[pair[1]]) @ poses[pair[0]]
            apart = differences(shown.pose, implied, extents[pair[0]].center)
            degrees, distance = float(apart[0]), float(apart[1])
        loops = _loops(pair, taken) if one else 0
        edges.append(
            Edge(
                *pair,
                shown.pose if shown else np.full((4, 4), np.nan),
                one is not None,
                _why(one, shown, where, loops, degrees, distance / radius),
                shown.rank if shown else 0,
                result.confidence,
                probabilities[shown] if shown else 0.0,
                loops,
                degrees,
                distance,
                edge_information(shown, radius) if shown else np.full((6, 6), np.nan),
                result.center_target,
                result.registered,
                result.reason,
            )
        )
    return edges


def _loops(pair: Pair, taken: Mapping[Pair, Hypothesis]) -> int:
    neighbors = [
        {scan for edge in taken if end in edge for scan in edge if scan != end} for end in pair
    ]
    return len(neighbors[0] & neighbors[1])


def _why(
    taken: Hypothesis | None,
    shown: Hypothesis | None,
    where: Sequence[int | None],
    loops: int,
    degrees: float,
    radii: float,
) -> str:
    if taken:
        confirmed = f"{loops} loops confirm it" if loops > 1 else "1 loop confirms it"
        confirmed = confirmed if loops else "no loop over three scans confirms it"
        if taken.rank:
            return f"alternative {taken.rank} agrees with the other edges; {confirmed}"
        kind = "registered" if taken.registered else "not sure by itself"
        return f"{kind}; {confirmed}"
    if shown is None:
        return "no pose was found"
    if where[0] is None or where[1] is None:
        return "doubtful, and one of the scans is left out"
    if where[0] != where[1]:
        return "the scans are of different models"
    return f"{degrees:.1f} degrees and {radii:.2f} radii from the poses that the other edges give"
