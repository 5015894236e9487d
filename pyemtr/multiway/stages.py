"""The stages of an alignment, from the results of pairs to poses, and what they have found."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..arrays import Floats
from ..result import Result
from .comparison import agree
from .edges import all_edges
from .grouping import LIKELY, Group, Grouping
from .hypothesis import Hypothesis, hypotheses_of
from .information import precision
from .joint import refine_jointly
from .loops import loop_probabilities
from .pairwise import Pair
from .pose_graph import solve
from .result import MultiwayResult
from .rigid import inverse
from .scans import Scans
from .verdicts import scan_verdicts

_SECOND_TRIES = 3  # pairs of two groups that are searched again
_MORE_PAIRS = 2  # times the number of scans: the most pairs that are
_PASSES = 2  # of choosing a model's edges by its poses, and its poses by the edges


_Valued = tuple[tuple[float, float], Pair]


def _largest_first(pairs: list[_Valued]) -> list[_Valued]:
    return sorted(pairs, key=lambda one: (-one[0][0], -one[0][1], one[1]))


class Stages:
    """Knows the hypotheses of all pairs, and the groups that they make."""

    def __init__(self, scans: Scans, radius: float, workers: int) -> None:
        self._scans, self._radius, self._workers = scans, radius, workers
        self._extents = [scans.extent(i) for i in range(len(scans))]
        self._results: dict[Pair, Result] = {}
        self._found: dict[Pair, list[Hypothesis]] = {}
        self._probabilities: dict[Hypothesis, float] = {}
        self._groups: list[Group] = []
        self._grouping: Grouping

    def add(self, results: Mapping[Pair, Result]) -> None:
        """Takes the results of pairs, in place of earlier ones of the same pairs."""
        self._results.update(results)
        self._found.update({pair: hypotheses_of(*pair, result) for pair, result in results.items()})
        self._found = dict(sorted(self._found.items()))

    def group(self) -> None:
        """Merges the scans into groups."""
        updated = loop_probabilities(self._found, self._extents, self._radius)
        self._probabilities = {
            one: float(probability)
            for found, probabilities in zip(self._found.values(), updated)
            for one, probability in zip(found, probabilities)
        }
        self._grouping = Grouping(list(self._probabilities.items()), self._extents, self._radius)
        self._groups = self._grouping.merge_all(self._improve)

    def second_tries(self, scores: Mapping[Pair, float] | None) -> list[Pair]:
        """Returns pairs of scans of different groups that deserve a longer search: those of which
        most is known, or the vote's next ones, which were not tried yet.

        Args:
            scores: of all pairs by the vote; None where all pairs have been tried.
        """
        where = {scan: i for i, group in enumerate(self._groups) for scan in group.poses}
        between: dict[tuple[int, int], list[_Valued]] = {}
        for pair in scores or self._found:
            if scores and pair in self._found:
                continue
            groups = where[pair[0]], where[pair[1]]
            if groups[0] != groups[1]:
                value = (scores[pair], 0.0) if scores else self._promise(pair)
                between.setdefault((min(groups), max(groups)), []).append((value, pair))
        chosen = [
            one for pairs in between.values() for one in _largest_first(pairs)[:_SECOND_TRIES]
        ]
        most = _MORE_PAIRS * len(self._scans)
        return sorted(pair for _, pair in _largest_first(chosen)[:most])

    def finish(self, refine: bool) -> None:
        """Chooses the edges of each model, solves its pose graph and refines its poses."""
        self.models = [group for group in self._groups if len(group.poses) > 1]
        self.covariances: dict[int, Floats] = {}
        for model in self.models:
            reference = min(model.poses)
            for _ in range(_PASSES):
                model.edges = self._consistent(model)
                solved = solve(
                    model.poses, model.edges, self._extents, self._radius, reference, True
                )
                model.poses = solved.poses
            self.covariances.update(solved.covariances)
            if refine:
                surfaces = {scan: self._scans.surface(scan) for scan in model.poses}
                weights = {
                    (one.source, one.target): precision(one, self._radius) for one in model.edges
                }
                model.poses = refine_jointly(
                    model.poses, surfaces, self._radius, reference, self._workers, weights
                )

    def result(self, seconds: float) -> MultiwayResult:
        """Returns what has been found."""
        edges = all_edges(
            self._results, self._found, self._probabilities, self.models, self._extents,
            self._radius,
        )  # fmt: skip
        verdicts = scan_verdicts(
            self._scans, self.models, self._groups, self._grouping, edges, self.covariances,
            self._radius,
        )  # fmt: skip
        return MultiwayResult(
            verdicts,
            edges,
            [sorted(model.poses) for model in self.models],
            self._radius,
            seconds,
            self._scans,
            dict(self._results),
        )

    def _promise(self, pair: Pair) -> tuple[float, float]:
        """Returns what speaks for another search: the best probability, and the score."""
        probable = max((self._probabilities[one] for one in self._found[pair]), default=0.0)
        score = self._results[pair].score
        return round(probable, 2), score if np.isfinite(score) else -1.0

    def _improve(self, group: Group) -> None:
        edges = self._consistent(group)
        group.poses = solve(group.poses, edges, self._extents, self._radius, min(group.poses)).poses

    def _consistent(self, group: Group) -> list[Hypothesis]:
        """Returns the most probable hypothesis of each pair that agrees with the poses, and the
        edges that the group has been merged by."""
        chosen: dict[Pair, Hypothesis] = {(one.source, one.target): one for one in group.edges}
        for pair, found in self._found.items():
            source, target = pair
            if not found or source not in group.poses or target not in group.poses:
                continue
            implied = inverse(group.poses[target]) @ group.poses[source]
            same = agree(
                np.array([one.pose for one in found]),
                implied,
                self._extents[source].center,
                self._radius,
            )
            same &= np.array([self._probabilities[one] >= LIKELY for one in found])
            if same.any():
                chosen[pair] = max(
                    (one for one, near in zip(found, same) if near),
                    key=lambda one: self._probabilities[one],
                )
        return [chosen[pair] for pair in sorted(chosen)]
