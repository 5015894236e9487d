"""The runs of the accuracy benchmark as pairs of a confidence and whether it was deserved."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .. import records
from ..pairs import DataError


@dataclass(frozen=True)
class Judged:
    """One run that has a confidence."""

    confidence: float
    joint: bool  # the pose is right; never of scans that do not belong together
    registered: bool
    related: bool


def read(paths: Iterable[Path]) -> dict[str, list[Judged]]:
    """The runs of each preset that gives confidences. Raises DataError for what is no such file,
    and when there is no such run in any of them."""
    found: dict[str, list[Judged]] = {}
    for path in paths:
        preset, runs = _read(path)
        if runs:
            found.setdefault(preset, []).extend(runs)
    if not found:
        raise DataError("no run has a confidence (preset paper gives none)")
    return found


def _read(path: Path) -> tuple[str, list[Judged]]:
    value = records.read(path)
    related = [_judged(run, bool(run["joint"]), True) for run in _known(value["runs"])]
    unrelated = [_judged(run, False, False) for run in _known(value["unrelated"])]
    return str(value["options"]["preset"]), related + unrelated


def _known(runs: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Those that did not crash and have a confidence."""
    return [run for run in runs if run.get("confidence") is not None]


def _judged(run: dict[str, Any], right: bool, related: bool) -> Judged:
    return Judged(float(run["confidence"]), right, bool(run["registered"]), related)
