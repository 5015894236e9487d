"""Paired Wilcoxon signed-rank tests, corrected by Holm for all claims of one table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

LEVEL = 0.05


@dataclass(frozen=True)
class Test:
    """`p` is corrected. `count` pairs of values that are not the same in all."""

    claim: str
    count: int
    median_difference: float
    p: float

    @property
    def verdict(self) -> str:
        return "significant" if self.p < LEVEL else "not significant"


@dataclass(frozen=True)
class Claim:
    """That the first of each pair of values is `alternative` ("less", "greater" or "two-sided")."""

    text: str
    ours: Sequence[float]
    theirs: Sequence[float]
    alternative: str


def holm(p_values: Sequence[float]) -> list[float]:
    """Holm's step-down correction: each p times the number of those that are not smaller, and
    never less than one before it."""
    order = np.argsort(p_values, kind="stable")
    corrected = np.empty(len(p_values))
    largest = 0.0
    for rank, i in enumerate(order):
        largest = max(largest, (len(p_values) - rank) * p_values[i])
        corrected[i] = min(1.0, largest)
    return corrected.tolist()


def tested(claims: Sequence[Claim]) -> list[Test]:
    """The claims that have values, with corrected p."""
    claims = [claim for claim in claims if len(claim.ours)]
    corrected = holm([_p(claim) for claim in claims])
    return [
        Test(
            claim.text,
            len(claim.ours),
            float(np.median(np.subtract(claim.ours, claim.theirs))),
            p,
        )
        for claim, p in zip(claims, corrected)
    ]


def _p(claim: Claim) -> float:
    from scipy.stats import wilcoxon

    difference = np.subtract(claim.ours, claim.theirs)
    if not difference.any():
        return 1.0  # nothing to tell apart
    return float(wilcoxon(difference, alternative=claim.alternative, zero_method="zsplit").pvalue)
