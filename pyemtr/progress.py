"""The progress of a running registration."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Callable, NamedTuple, Optional


class Progress(NamedTuple):
    """Passed to the callback before each stage, after each iteration, and about every 20 ms.

    Attributes:
        stage: "normalization", "scale_search", "downsampling", "features", "matching", "seeds",
            "evolution", "candidates", "fallback_search", "refinement" or "verdict", in this order.
            A preset without a stage skips it. If a coarse search leaves doubt, those from
            "normalization" on begin again.
        iteration, iterations: how many are done, and how many there are in all.
        best_alpha, best_beta: the best fitness so far of the two tasks, lower is better. Alpha's
            scale changes at the switch from sparse to dense.
        fraction: how much of the whole run is done, from 0 to below 1, never less than before. It
            is estimated from what each stage usually takes. A finer search after a coarse one adds
            nothing to it, nor does a fallback search that the settings do not ask for "always".
    """

    stage: str
    iteration: int
    iterations: int
    best_alpha: float
    best_beta: float
    fraction: float = 0.0


Callback = Callable[[Progress], Optional[bool]]


def as_raw_callback(
    callback: Callback | None, settings: Mapping[str, Any]
) -> Callable[..., Any] | None:
    """Returns the callback as the extension calls it, with plain arguments."""
    if callback is None:
        return None
    if not callable(callback):
        raise TypeError(f"callback: expected a callable or None, got {type(callback).__name__}")
    run = _Done(settings)

    def raw(stage: str, done: int, count: int, alpha: float, beta: float) -> bool | None:
        fraction = run.fraction(stage, done, count)
        return callback(Progress(stage, done, count, alpha, beta, fraction))

    return raw


class _Done:
    """How much of a run is done, by the usual shares of its stages."""

    def __init__(self, settings: Mapping[str, Any]) -> None:
        self._share = _shares(settings)
        self._first: float | None = None  # where the run began: a Problem has stages behind it
        self._last = 0.0

    def fraction(self, stage: str, iteration: int, iterations: int) -> float:
        before = 0.0
        for name, share in self._share.items():
            if name == stage:
                break
            before += share
        if stage == "evolution" and iterations:
            before += self._share[stage] * iteration / iterations
        if self._first is None:
            self._first = before
        total = sum(self._share.values()) - self._first
        self._last = max(self._last, (before - self._first) / total)
        return self._last


def _shares(settings: Mapping[str, Any]) -> dict[str, float]:
    """Returns what each stage takes, in the order in which they run, in hundredths of a run of
    preset "default" of clouds of 40 000 points."""
    ranked = bool(settings["candidates"])
    again = ranked and settings["fallback_search"] == "always"
    return {
        "normalization": 2,
        "scale_search": 0 if settings["scale"] == "fixed" else 200,
        "downsampling": 8,
        "features": 25 if settings["features"] == "pcl" else 5,
        "matching": 20,
        "seeds": 3 if settings["seeds"] else 0,
        "evolution": 18 if settings["seeds"] else 60,
        "candidates": 20 if ranked else 0,
        "fallback_search": 300 if again else 0,
        "refinement": 20 if settings["refine"] else 0,
        "verdict": 4,
    }
