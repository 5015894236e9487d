"""Groups of scans: pairs of groups are merged where the hypotheses between them agree.

Every scan begins as a group of its own. The pose of one group in another follows from any
hypothesis between a scan of one and a scan of the other. It is judged by all hypotheses between the
two: each pair of scans multiplies the odds. The pair of groups with the best odds is merged first.
Where two poses have about the same odds, the pair waits: another scan may decide.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats
from .comparison import agree
from .hypothesis import Hypothesis
from .loops import CHANCE
from .rigid import inverse
from .scans import Extent

#: Logarithm of the odds that merges two groups: one hypothesis of probability 0.9, or two
#: of 0.13 each from different pairs of scans.
ENOUGH = float(np.log(0.9 / CHANCE))
#: By how much the best pose must be better than every other pose of the two groups.
MARGIN = 1.5
_WORST = -3.0  # the most that one pair of scans takes from the odds
_TRIED = 60  # poses of two groups that are judged, the most probable
_IGNORED = 0.003
#: Probability from which a hypothesis that agrees with the others is an edge of the graph.
LIKELY = 0.05


@dataclass(eq=False)
class Group:
    """Scans with poses in one frame.

    Attributes:
        poses: float64 (4, 4) by scan, scan -> group.
        edges: the hypotheses that merged them.
    """

    poses: dict[int, Floats]
    edges: list[Hypothesis] = field(default_factory=list)


@dataclass(frozen=True, eq=False)
class Merge:
    """The best pose of a group in another one, and the logarithm of its odds.

    Attributes:
        pose: float64 (4, 4), second group -> first group.
        odds, margin: of the pose, and by how much it is better than the next one.
        edges: the hypotheses that agree with it.
    """

    pose: Floats
    odds: float
    margin: float
    edges: list[Hypothesis]


Improve = Callable[[Group], None]


class Grouping:
    """Merges groups until no two of them have the odds."""

    def __init__(
        self,
        hypotheses: Sequence[tuple[Hypothesis, float]],
        extents: Sequence[Extent],
        radius: float,
    ) -> None:
        """Takes the hypotheses of all pairs, each with its probability."""
        self._between: dict[tuple[int, int], list[tuple[Hypothesis, float]]] = {}
        for one, probability in hypotheses:
            self._between.setdefault((one.target, one.source), []).append((one, probability))
        self._extents = extents
        self._radius = radius

    def merge_all(self, improve: Improve) -> list[Group]:
        """Returns the groups, in the order of their first scans. ``improve`` is called with each
        merged group and may change its poses."""
        groups = {i: Group({i: np.eye(4)}) for i in range(len(self._extents))}
        merges = {(i, j): self._best(groups[i], groups[j]) for i in groups for j in groups if i < j}
        while True:
            ready = [
                (-merge.odds, pair)
                for pair, merge in merges.items()
                if merge is not None and merge.odds >= ENOUGH and merge.margin >= MARGIN
            ]
            if not ready:
                return list(groups.values())
            first, second = min(ready)[1]
            merge = merges[first, second]
            assert merge is not None
            group = _merged(groups[first], groups.pop(second), merge)
            improve(group)
            groups[first] = group
            merges = {pair: old for pair, old in merges.items() if second not in pair}
            for other in groups:
                pair = min(first, other), max(first, other)
                if other != first and (first in pair):
                    merges[pair] = self._best(groups[pair[0]], groups[pair[1]])

    def best(self, first: Group, second: Group) -> Merge | None:
        """Returns the best pose of the second group in the first; None where there is none."""
        return self._best(first, second)

    def _best(self, first: Group, second: Group) -> Merge | None:
        pairs = self._pairs(first, second)
        if not pairs:
            return None
        proposals = sorted(
            (
                (-probability, i, j, pose)
                for i, pair in enumerate(pairs)
                for j, (pose, probability) in enumerate(zip(pair.poses, pair.probabilities))
            ),
            key=lambda proposal: proposal[:3],
        )[:_TRIED]
        poses = np.array(
            [
                first.poses[pairs[i].target] @ pose @ inverse(second.poses[pairs[i].source])
                for _, i, _, pose in proposals
            ]
        )
        odds = np.zeros(len(poses))
        chosen: list[tuple[_Pair, NDArray[np.intp], Floats]] = []
        for pair in pairs:
            implied = inverse(first.poses[pair.target]) @ poses @ second.poses[pair.source]
            same = agree(implied[:, None], pair.poses[None], pair.center, self._radius)
            best = np.where(same, pair.probabilities, 0.0)
            which = best.argmax(axis=1)
            likely = best.max(axis=1)
            odds += np.where(
                likely > 0,
                np.log(likely / CHANCE + 1 - likely),
                max(np.log1p(-pair.registered), _WORST),
            )
            chosen.append((pair, which, likely))
        top = int(odds.argmax())
        pair = pairs[proposals[top][1]]
        implied = inverse(first.poses[pair.target]) @ poses @ second.poses[pair.source]
        other = ~agree(implied, implied[top], pair.center, self._radius, slack=2.0)
        margin = float(odds[top] - odds[other].max(initial=-np.inf))
        edges = [(pair.found[which[top]], likely[top]) for pair, which, likely in chosen]
        sure = [one for one, likely in edges if likely >= LIKELY]
        return Merge(
            poses[top], float(odds[top]), margin, sure or [one for one, p in edges if p > 0]
        )

    def _pairs(self, first: Group, second: Group) -> list[_Pair]:
        found = []
        for a in first.poses:
            for b in second.poses:
                between = self._between.get((min(a, b), max(a, b)))
                if between:
                    found.append(_Pair(between, a, b, self._extents[b].center))
        return [pair for pair in found if len(pair.found)]


class _Pair:
    """The hypotheses of two scans as poses of one of them, the source, in the other."""

    def __init__(
        self, between: list[tuple[Hypothesis, float]], target: int, source: int, center: Floats
    ) -> None:
        kept = [(one, p) for one, p in between if p >= _IGNORED]
        self.found = [one for one, _ in kept]
        self.probabilities = np.array([p for _, p in kept])
        self.target, self.source, self.center = target, source, center
        poses = np.array([one.pose for one in self.found]).reshape(-1, 4, 4)
        self.poses = poses if source > target else inverse(poses)
        self.registered = max((p for one, p in kept if one.registered), default=0.0)


def _merged(first: Group, second: Group, merge: Merge) -> Group:
    poses = dict(first.poses)
    poses.update({scan: merge.pose @ pose for scan, pose in second.poses.items()})
    return Group(poses, first.edges + second.edges + merge.edges)
