"""Measures how long a run goes on after its time limit, or after a signal."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable
from typing import Any

Register = Callable[..., Any]  # takes settings of pyemtr.register(), returns its Result


def after_limit(register: Register, seconds: float) -> float | None:
    """With that limit; None when it was done before."""
    start = time.perf_counter()
    result = register(time_limit=seconds)
    return time.perf_counter() - start - seconds if result.reason == "time_limit" else None


def after_signal(register: Register, seconds: float) -> float | None:
    """As Ctrl-C would send one then; None when it was done before."""
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    start = time.perf_counter()
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        register()
    except KeyboardInterrupt:
        return time.perf_counter() - start - seconds
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    return None
