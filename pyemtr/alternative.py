"""Another pose that may align the clouds."""

from __future__ import annotations

from typing import NamedTuple

from .arrays import Floats


class Alternative(NamedTuple):
    """A pose clearly different from the answer: more than 10 degrees or 0.15 radii away.

    Attributes:
        transformation: float64 (4, 4), source into target, q = R p + t, in the user's unit.
        score: as :attr:`pyemtr.Result.score`, at most the answer's.
        surface_fit, violation, evidence: as those of :class:`pyemtr.Result`; NaN where the
            correspondences alone decide.
    """

    transformation: Floats
    score: float
    surface_fit: float
    violation: float
    evidence: float
