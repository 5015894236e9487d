"""A logistic model of the samples, and how well it does on sources that it has not seen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sklearn.linear_model import LogisticRegression
from sklearn.model_selection import LeaveOneGroupOut, cross_val_predict

from ..calibration.figures import Calibration, calibration
from ..calibration.judged import Judged
from .samples import Sample

#: Next to none: the terms are few and the samples many.
_INVERSE_REGULARIZATION = 1e4
#: Of an answer that takes the place of a right one: searches lose right poses less often than that.
_WEIGHT_OF_REMOVED = 0.5


@dataclass(frozen=True)
class Fitted:
    bias: float
    weights: tuple[float, ...]  # of samples.TERMS
    figures: Calibration | None  # of each source by a model that has not seen it; of two and more


def fit(samples: Sequence[Sample], minimum: float, bins: int) -> Fitted:
    """Fits the model. `minimum`: confidence from which on an answer is called registered."""
    features = np.array([sample.features for sample in samples])
    right = np.array([sample.right for sample in samples])
    sources = np.array([sample.source for sample in samples])
    removed = np.array([sample.removed for sample in samples])
    weight = balance(sources) * np.where(removed, _WEIGHT_OF_REMOVED, 1.0)
    made = _model().fit(features, right, sample_weight=weight)
    figures = None
    if len(set(sources)) > 1:
        unseen = cross_val_predict(
            _model(), features, right, groups=sources, cv=LeaveOneGroupOut(),
            method="predict_proba", params={"sample_weight": weight},
        )[:, 1]  # fmt: skip
        judged = [
            Judged(float(p), bool(r), bool(p >= minimum), source != "unrelated")
            for p, r, source in zip(unseen, right, sources)
        ]
        figures = calibration(judged, bins)
    return Fitted(float(made.intercept_[0]), tuple(map(float, made.coef_[0])), figures)


def balance(sources: NDArray[Any]) -> NDArray[np.float64]:
    """Weights by which each source counts as its samples' square root: many runs of one scene are
    more than one, and less than as many scenes. Their mean is 1."""
    _, inverse, counts = np.unique(sources, return_inverse=True, return_counts=True)
    weight = 1.0 / np.sqrt(counts[inverse])
    return np.asarray(weight / weight.mean(), dtype=np.float64)


def _model() -> LogisticRegression:
    return LogisticRegression(C=_INVERSE_REGULARIZATION, max_iter=1000)
