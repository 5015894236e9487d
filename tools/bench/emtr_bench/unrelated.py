"""Registers scans that do not belong together: none of them should be called registered."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from .jobs import side_by_side
from .pairings import Pairing, clouds
from .runner import Options, Outcome, Register, attempt


@dataclass(frozen=True)
class Unrelated:
    """One registration of a pairing. `error` holds the traceback of a run that crashed."""

    pairing: Pairing
    seed: int
    wall: float  # seconds around the call
    outcome: Outcome | None
    error: str

    @property
    def registered(self) -> bool:
        return self.outcome is not None and self.outcome.registered

    @property
    def confidence(self) -> float:
        """The library's; NaN when it gave none."""
        return math.nan if self.outcome is None else self.outcome.quality["confidence"]


def run_all(
    pairings: list[Pairing], register: Register, options: Options, jobs: int
) -> Iterator[Unrelated]:
    """Every pairing with one motion, in order, as they are done; sensor positions are not told."""
    work = functools.partial(run, register=register, options=options)
    yield from side_by_side(work, pairings, jobs)


def run(pairing: Pairing, register: Register, options: Options) -> Unrelated:
    """Pairing i has seed options.seed + i. A crash becomes a run with `error`."""
    source, target = clouds(pairing)
    seed = options.seed + pairing.index
    outcome, error, wall = attempt(register, source, target, replace(options, seed=seed), None)
    return Unrelated(pairing, seed, wall, outcome, error)


def text(runs: list[Unrelated]) -> str:
    """Tells how many were called registered, and which."""
    taken = [run for run in runs if run.registered]
    lines = [f"unrelated scans: {len(taken)} of {len(runs)} called registered (none should be)"]
    lines += [
        f"  {run.pairing.name} seed {run.seed}: confidence {run.confidence:.3f}" for run in taken
    ]
    crashed = [run for run in runs if run.error]
    if crashed:
        lines.append(f"CRASHED: {len(crashed)} runs; the first, {crashed[0].pairing.name}:")
        lines.append(crashed[0].error)
    return "\n".join(lines)


def marks(runs: list[Unrelated]) -> list[str]:
    """Names those that were called registered; empty when none was."""
    taken = sum(run.registered for run in runs)
    return [f"{taken} of {len(runs)} unrelated scans called registered"] if taken else []
