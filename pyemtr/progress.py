"""What a running registration tells its caller."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple, Optional


class Progress(NamedTuple):
    """Given to the callback before each stage, after each iteration, and again every 20 ms or so.

    ``stage`` is "normalization", "downsampling", "features", "matching", "seeds", "evolution", "candidates",
    "fallback_search", "refinement" or "verdict", in this order; a preset without a stage leaves it out.
    ``iteration`` of ``iterations`` are done. ``best_alpha`` and ``best_beta`` are the best
    fitness so far of the two tasks, lower is better; alpha's scale changes at the switch from
    sparse to dense.
    """

    stage: str
    iteration: int
    iterations: int
    best_alpha: float
    best_beta: float


Callback = Callable[[Progress], Optional[bool]]


def as_raw_callback(callback: Callback | None) -> Callable[..., Any] | None:
    """The callback as the extension calls it, with plain arguments."""
    if callback is None:
        return None
    if not callable(callback):
        raise TypeError(f"callback: expected a callable or None, got {type(callback).__name__}")
    return lambda *values: callback(Progress(*values))
