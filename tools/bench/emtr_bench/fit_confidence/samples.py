"""What the confidence is fitted to: measurements of answers, right and wrong, by their source."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .. import records
from ..pairs import DataError

#: The terms of the model, in the order of Sample.features.
TERMS = ("log_gap", "violation", "log_evidence")

# As in the library: of a score, fit or gap; and what makes another pose a rival.
_MINIMUM = 1e-3
_MEANINGFUL_SCORE, _RIVAL_SHARE = 0.03, 0.75


@dataclass(frozen=True)
class Sample:
    """One answer. `source`: where its pair comes from, which is left out as a whole. `removed`: it
    would have been the answer if the right poses had not been found."""

    source: str
    features: tuple[float, ...]
    right: bool
    removed: bool = False


@dataclass(frozen=True)
class Pose:
    """The measurements of an answer or of an alternative."""

    score: float
    surface_fit: float
    violation: float
    evidence: float
    right: bool


def read(paths: Iterable[Path], leave_out: Sequence[str] = ()) -> list[Sample]:
    """The samples of files that `accuracy --json` wrote, without the pairs named. Raises DataError
    for what is no such file, and when there are not both right and wrong answers."""
    found: list[Sample] = []
    for path in paths:
        value = records.read(path)
        for run in value["runs"]:
            if run["pair"] not in leave_out and run.get("score") is not None:
                found += samples(run["group"], poses(run, bool(run["joint"])))
        for run in value["unrelated"]:
            if run.get("score") is not None:
                found += samples("unrelated", poses(run, False))
    if len({sample.right for sample in found}) < 2:
        raise DataError("expected both right and wrong answers that have a score")
    return found


def poses(run: dict[str, Any], right: bool) -> list[Pose]:
    """The answer of a recorded run and its alternatives, best first."""
    others = run["alternatives"]
    rights = run.get("alternatives_right") or [False] * len(others)
    return [_pose(run, right), *(_pose(other, r) for other, r in zip(others, rights))]


def samples(source: str, ranked: Sequence[Pose]) -> list[Sample]:
    """The answer, and what would have been it if the right poses had not been found. Without those
    that have a rival, which a rule of the library judges."""
    wrong = [pose for pose in ranked if not pose.right]
    lists = [(ranked, False)]
    if wrong and len(wrong) < len(ranked):
        lists.append((wrong, True))
    return [
        Sample(source, features(poses), poses[0].right, removed)
        for poses, removed in lists
        if not rival(poses)
    ]


def rival(ranked: Sequence[Pose]) -> bool:
    """Tells whether the second of the poses is about as good as the first."""
    best = ranked[0].score
    return len(ranked) > 1 and ranked[1].score > max(_MEANINGFUL_SCORE, _RIVAL_SHARE * best)


def features(ranked: Sequence[Pose]) -> tuple[float, ...]:
    """The terms of the first pose, given the others."""
    best = ranked[0]
    second = max(0.0, ranked[1].score) if len(ranked) > 1 else 0.0
    return (
        math.log(max(best.score - second, _MINIMUM)),
        math.sqrt(best.violation / max(best.surface_fit, _MINIMUM)),
        math.log(max(best.evidence, 1.0)),
    )


def _pose(values: dict[str, Any], right: bool) -> Pose:
    names = ("score", "surface_fit", "violation", "evidence")
    return Pose(*(float(values[name]) for name in names), right)
