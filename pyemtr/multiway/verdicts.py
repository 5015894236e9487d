"""The verdict of each scan: placed or left out, and why."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Floats
from ..neighborhood import neighbor_tree
from .edges import Edge
from .grouping import ENOUGH, Group, Grouping
from .rigid import moved
from .scans import Scans

_NEAR = 0.02  # of what another scan shows too, radii


@dataclass(frozen=True, eq=False)
class ScanVerdict:
    """What became of one scan.

    Attributes:
        name: as given, or of its file.
        placed: whether it is part of a model.
        verdict: "placed"; or why it was left out: "doubtful" (poses were found, and none of them is
            sure enough), "ambiguous" (two poses fit about as well) or "apart" (it fits nowhere).
        text: the verdict in a few words.
        model: index of its model; None when left out.
        pose: float64 (4, 4), scan -> frame of its model, q = R p + t, in the scans' unit: the frame
            of the model's first scan. All NaN when left out.
        covariance: float64 (6, 6) of the pose against the model's first scan: a small rotation w
            (radians) about the scan's centroid and then a translation v (the scans' unit), both in
            the model's axes. 0 for the first scan, all NaN when left out. It is that of the pose
            graph, scaled by how well its loops close; the joint refinement leaves it.
        edges: how many edges of the pose graph it has.
        overlap: share of its surface that another scan of the model shows too; NaN when left out.
    """

    name: str
    placed: bool
    verdict: str
    text: str
    model: int | None
    pose: Floats
    covariance: Floats
    edges: int
    overlap: float


def scan_verdicts(
    scans: Scans,
    models: Sequence[Group],
    groups: Sequence[Group],
    grouping: Grouping,
    edges: Sequence[Edge],
    covariances: Mapping[int, Floats],
    radius: float,
) -> list[ScanVerdict]:
    """Returns the verdict of each scan, in their order."""
    found: dict[int, ScanVerdict] = {}
    for number, model in enumerate(models):
        overlaps = _overlaps(scans, model, radius)
        for scan, pose in model.poses.items():
            own = sum(edge.taken and scan in (edge.source, edge.target) for edge in edges)
            text = f"placed by {own} edge{'s' if own > 1 else ''}"
            found[scan] = ScanVerdict(
                scans.names[scan], True, "placed", text, number, pose, covariances[scan], own,
                overlaps[scan],
            )  # fmt: skip
    for group in groups:
        if len(group.poses) == 1:
            (scan,) = group.poses
            verdict, text = _left_out(group, groups, grouping, scans)
            nowhere = np.full((4, 4), np.nan), np.full((6, 6), np.nan)
            found[scan] = ScanVerdict(
                scans.names[scan], False, verdict, text, None, *nowhere, 0, float("nan")
            )
    return [found[scan] for scan in range(len(scans))]


def _left_out(
    own: Group, groups: Sequence[Group], grouping: Grouping, scans: Scans
) -> tuple[str, str]:
    (scan,) = own.poses
    merges = []
    for group in groups:
        if group is not own:
            first, second = (own, group) if scan < min(group.poses) else (group, own)
            merge = grouping.best(first, second)
            if merge:
                merges.append((merge, min(group.poses)))
    best, nearest = max(merges, key=lambda one: one[0].odds, default=(None, 0))
    name = scans.names[nearest]
    if best is None or best.odds <= 0:
        return "apart", "it fits on no other scan"
    if best.odds >= ENOUGH:
        return "ambiguous", f"two poses fit about as well on the scans with {name}"
    odds = f"{np.exp(best.odds):.1f} to 1 where {np.exp(ENOUGH):.0f} to 1 are asked"
    return "doubtful", f"no pose is sure enough: the best, on the scans with {name}, has {odds}"


def _overlaps(scans: Scans, model: Group, radius: float) -> dict[int, float]:
    """Returns the share of each scan's surface that is near another scan's."""
    overlaps = {}
    placed = {scan: moved(pose, scans.surface(scan).points) for scan, pose in model.poses.items()}
    trees = {scan: neighbor_tree(points) for scan, points in placed.items()}
    reach = max(_NEAR * radius, 2 * max(scans.surface(scan).spacing for scan in model.poses))
    for scan, points in placed.items():
        sample = points[:: max(1, len(points) // 1000)]
        near = np.zeros(len(sample), dtype=np.bool_)
        for other, tree in trees.items():
            if other != scan:
                near |= np.isfinite(tree.query(sample, distance_upper_bound=reach)[0])
        overlaps[scan] = float(near.mean())
    return overlaps
