"""Edges are chosen by the loops that they close; the pairs here are made up."""

from __future__ import annotations

from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest
from shapes import random_transformation

from pyemtr.multiway.grouping import ENOUGH, Grouping
from pyemtr.multiway.hypothesis import Hypothesis, hypotheses_of
from pyemtr.multiway.loops import loop_probabilities
from pyemtr.multiway.scans import Extent

EXTENT = Extent(np.zeros(3), 1.0)


class Pairs:
    """Pairs of scans whose true poses are known, with the hypotheses that a test gives them."""

    def __init__(self, scans: int, seed: int = 0) -> None:
        self.rng = np.random.default_rng(seed)
        self.truth = [random_transformation(self.rng) for _ in range(scans)]
        self.found: dict[tuple[int, int], list[Hypothesis]] = {
            (j, i): [] for i, j in combinations(range(scans), 2)
        }

    def add(self, pair: tuple[int, int], probability: float, right: bool) -> Hypothesis:
        source, target = pair
        pose = np.linalg.inv(self.truth[target]) @ self.truth[source]
        if not right:
            pose = random_transformation(self.rng)
        rank = len(self.found[pair])
        result = SimpleNamespace(registered=rank == 0 and probability > 0.5)
        one = Hypothesis(source, target, pose, rank, probability, result)
        self.found[pair].append(one)
        return one

    def groups(self) -> tuple[list[list[int]], list[Hypothesis], float]:
        """The scans of each group, the edges, and the largest error of a pose in its group."""
        extents = [EXTENT] * len(self.truth)
        updated = loop_probabilities(self.found, extents, 1.0)
        weighed = [
            (one, float(probability))
            for found, probabilities in zip(self.found.values(), updated)
            for one, probability in zip(found, probabilities)
        ]
        groups = Grouping(weighed, extents, 1.0).merge_all(lambda group: None)
        worst = 0.0
        for group in groups:
            first = min(group.poses)
            for scan, pose in group.poses.items():
                wanted = np.linalg.inv(self.truth[first]) @ self.truth[scan]
                made = np.linalg.inv(group.poses[first]) @ pose
                worst = max(worst, float(np.abs(made - wanted).max()))
        return (
            [sorted(group.poses) for group in groups],
            [e for g in groups for e in g.edges],
            worst,
        )


def test_sure_edges_make_one_group() -> None:
    pairs = Pairs(4)
    for pair in pairs.found:
        pairs.add(pair, 0.97, right=True)
    members, edges, worst = pairs.groups()
    assert members == [[0, 1, 2, 3]] and len(edges) == 6 and worst < 1e-9


@pytest.mark.parametrize("wrong", [(1, 0), (3, 0), (3, 2)])
def test_a_sure_edge_that_is_wrong_is_found_by_the_loops(wrong: tuple[int, int]) -> None:
    pairs = Pairs(4)
    for pair in pairs.found:
        pairs.add(pair, 0.97, right=pair != wrong)
    members, edges, worst = pairs.groups()
    assert members == [[0, 1, 2, 3]] and worst < 1e-9
    assert wrong not in [(one.source, one.target) for one in edges]


def test_an_alternative_wins_over_an_answer_that_closes_no_loop() -> None:
    pairs = Pairs(4)
    for pair in pairs.found:
        pairs.add(pair, 0.6, right=pair != (2, 1))
    right = pairs.add((2, 1), 0.2, right=True)
    members, edges, worst = pairs.groups()
    assert members == [[0, 1, 2, 3]] and right in edges and worst < 1e-9


def test_doubtful_edges_are_taken_where_loops_confirm_them() -> None:
    pairs = Pairs(4)
    for pair in pairs.found:
        pairs.add(pair, 0.3, right=True)
    members, _, worst = pairs.groups()
    assert members == [[0, 1, 2, 3]] and worst < 1e-9


def test_a_scan_with_one_doubtful_edge_is_left_out() -> None:
    pairs = Pairs(4)
    for pair in pairs.found:
        if 3 not in pair:
            pairs.add(pair, 0.97, right=True)
    pairs.add((3, 1), 0.5, right=True)
    assert pairs.groups()[0] == [[0, 1, 2], [3]]


def test_edges_that_contradict_each_other_leave_a_scan_out() -> None:
    """Both say that they are sure, and nothing tells which of them is right."""
    pairs = Pairs(3)
    pairs.add((1, 0), 0.97, right=True)
    pairs.add((2, 0), 0.97, right=True)
    pairs.add((2, 1), 0.97, right=False)
    members, _, _ = pairs.groups()
    assert [0, 1, 2] not in members


def test_two_poses_with_about_the_same_odds_wait_for_another_scan() -> None:
    pairs = Pairs(2)
    pairs.add((1, 0), 0.93, right=True)
    pairs.add((1, 0), 0.5, right=False)  # as much as half as likely
    weighed = [(one, one.probability) for one in pairs.found[1, 0]]
    grouping = Grouping(weighed, [EXTENT] * 2, 1.0)
    assert len(grouping.merge_all(lambda group: None)) == 2
    sure = Grouping(weighed[:1], [EXTENT] * 2, 1.0)
    assert len(sure.merge_all(lambda group: None)) == 1
    assert np.log(0.93 / 0.02) > ENOUGH  # so it is the second pose that has kept them apart


def test_two_things_become_two_groups() -> None:
    pairs = Pairs(6)
    for source, target in pairs.found:
        same = source % 2 == target % 2
        pairs.add((source, target), 0.95 if same else 0.02, right=same)
    assert pairs.groups()[0] == [[0, 2, 4], [1, 3, 5]]


def test_wrong_poses_at_random_make_no_group() -> None:
    for seed in range(5):
        pairs = Pairs(8, seed)
        for pair in pairs.found:
            for probability in (0.3, 0.2, 0.1, 0.05, 0.05):
                pairs.add(pair, probability, right=False)
        assert pairs.groups()[0] == [[i] for i in range(8)]


def test_excluded_poses_predict_nothing() -> None:
    pairs = Pairs(3)
    for pair in pairs.found:
        pairs.add(pair, 1e-4, right=True)
    assert pairs.groups()[0] == [[0], [1], [2]]


def test_the_alternatives_share_what_the_confidence_leaves() -> None:
    pose = np.eye(4)
    alternatives = [
        SimpleNamespace(transformation=pose, score=0.58),
        SimpleNamespace(transformation=pose, score=0.30),
    ]
    result = SimpleNamespace(
        transformation=pose, confidence=0.4, score=0.6, alternatives=alternatives, registered=False
    )
    first, second, third = hypotheses_of(1, 0, result)
    assert first.probability == 0.4 and [one.rank for one in (first, second, third)] == [0, 1, 2]
    assert second.probability > third.probability > 0
    assert first.probability + second.probability + third.probability < 1


def test_no_pose_is_no_hypothesis() -> None:
    result = SimpleNamespace(
        transformation=np.full((4, 4), np.nan), confidence=np.nan, alternatives=[]
    )
    assert hypotheses_of(1, 0, result) == []
