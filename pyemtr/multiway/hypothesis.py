"""What one pair of scans proposes: the pose that it was registered in, and its alternatives."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Floats
from ..result import Result

#: What is left for a pose that is almost sure, or almost excluded.
LEAST, MOST = 1e-4, 0.999
_SHARPNESS = 12.0  # how much more probable an alternative is for a score that is better by 1


@dataclass(eq=False)
class Hypothesis:
    """A pose of a pair that may be right.

    Attributes:
        source, target: indices of the scans, source > target.
        pose: float64 (4, 4), source into target.
        rank: 0 for the registration's answer, i for its i-th alternative.
        probability: that the pose is right, of the pair alone.
        result: of the registration.
    """

    source: int
    target: int
    pose: Floats
    rank: int
    probability: float
    result: Result

    @property
    def registered(self) -> bool:
        return self.rank == 0 and self.result.registered


def hypotheses_of(source: int, target: int, result: Result) -> list[Hypothesis]:
    """Returns what a registration proposes, the answer first.

    The answer has the confidence as its probability. An alternative of the same score is as
    probable, one of a lower score less so; together they have no more than what is left.
    """
    if not np.isfinite(result.transformation).all():
        return []
    confidence = float(np.nan_to_num(result.confidence))
    found = [
        Hypothesis(source, target, result.transformation, 0, _bounded(confidence), result),
    ]
    scores = np.array([one.score for one in result.alternatives] or [0.0])
    likely = np.exp(_SHARPNESS * np.nan_to_num(scores - result.score, nan=-1.0))
    shares = np.minimum(confidence * likely, (1 - confidence) * likely / likely.sum())
    for i, alternative in enumerate(result.alternatives):
        probability = _bounded(float(shares[i]))
        found.append(
            Hypothesis(source, target, alternative.transformation, i + 1, probability, result)
        )
    return found


def _bounded(probability: float) -> float:
    return min(max(probability, LEAST), MOST)
