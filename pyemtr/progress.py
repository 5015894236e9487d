"""The progress of a running registration."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple, Optional


class Progress(NamedTuple):
    """Passed to the callback before each stage, after each iteration, and about every 20 ms.

    Attributes:
        stage: "normalization", "downsampling", "features", "matching", "seeds", "evolution",
            "candidates", "fallback_search", "refinement" or "verdict", in this order. A preset
            without a stage skips it.
        iteration, iterations: how many are done, and how many there are in all.
        best_alpha, best_beta: the best fitness so far of the two tasks, lower is better. Alpha's
            scale changes at the switch from sparse to dense.
    """

    stage: str
    iteration: int
    iterations: int
    best_alpha: float
    best_beta: float


Callback = Callable[[Progress], Optional[bool]]


def as_raw_callback(callback: Callback | None) -> Callable[..., Any] | None:
    """Returns the callback as the extension calls it, with plain arguments."""
    if callback is None:
        return None
    if not callable(callback):
        raise TypeError(f"callback: expected a callable or None, got {type(callback).__name__}")
    return lambda *values: callback(Progress(*values))
