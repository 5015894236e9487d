"""Means over runs, as the paper's tables have them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from pyemtr.metrics import MAX_ROTATION_ERROR

from .published import Published
from .run_log import Record


def success(record: Record) -> bool:
    """The paper's: the rotation alone. A run without a pose is a failure."""
    return record["E_R"] is not None and record["E_R"] < MAX_ROTATION_ERROR


def chosen(
    records: Sequence[Record], section: str, method: str | None = None, pair: str | None = None
) -> list[Record]:
    return [
        r for r in records
        if r["section"] == section and method in (None, r["method"]) and pair in (None, r["pair"])
    ]  # fmt: skip


def pair_rows(records: Sequence[Record]) -> dict[str, str]:
    """Name of each pair: what its row is called, the paper's name where it has one."""
    return {r["pair"]: r["row"] or r["pair"] for r in records}


def percent(records: Sequence[Record]) -> float:
    return 100.0 * float(np.mean([success(r) for r in records])) if records else math.nan


def mean_over_pairs(records: Sequence[Record], figure: Callable[[list[Record]], float]) -> float:
    """Each pair with the same weight, leaving out those of which there is no figure."""
    names = dict.fromkeys(r["pair"] for r in records)
    values = [figure([r for r in records if r["pair"] == name]) for name in names]
    values = [value for value in values if not math.isnan(value)]
    return float(np.mean(values)) if values else math.nan


def spread(
    records: Sequence[Record], column: str, factor: float = 1.0, of_success: bool = True
) -> Published | None:
    """Mean of a column over the successes, and the standard deviation of more than one; None
    without any."""
    values = [factor * r[column] for r in records
              if r.get(column) is not None and (success(r) or not of_success)]  # fmt: skip
    if not values:
        return None
    deviation = float(np.std(values, ddof=1)) if len(values) > 1 else None
    return Published(float(np.mean(values)), deviation)


def mean(records: Sequence[Record], column: str, factor: float = 1.0) -> float:
    values = [factor * r[column] for r in records if r.get(column) is not None]
    return float(np.mean(values)) if values else math.nan
