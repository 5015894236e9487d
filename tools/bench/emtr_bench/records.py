"""The JSON for machines: every run, every row, and what they were made with."""

from __future__ import annotations

import dataclasses
import json
import math
import os
import platform
from pathlib import Path
from typing import Any

from . import paper_tables
from .data import are_generated
from .pairs import DataError
from .runner import Options, Outcome, Run
from .summary import Figures, PairSummary
from .unrelated import Unrelated
from .whole_file import write_whole


def record(
    options: Options,
    version: str,
    runs: list[Run],
    rows: list[PairSummary],
    average: Figures,
    unrelated: list[Unrelated],
) -> dict[str, Any]:
    """Everything, ready for JSON. Degrees, seconds, matrices source into target."""
    return {
        "benchmark": "accuracy",
        "emtr_version": version,
        "options": dataclasses.asdict(options),
        "generated_pairs": are_generated(run.pair for run in runs),
        "machine": {
            "system": platform.platform(),
            "processor": platform.processor() or platform.machine(),
            "cpus": os.cpu_count(),
            "python": platform.python_version(),
        },
        "paper": {
            "mean_success": paper_tables.MEAN_SUCCESS,
            "lowest_success": paper_tables.LOWEST_SUCCESS,
            "mean_seconds": paper_tables.MEAN_SECONDS,
        },
        "mean": _figures(average),
        "pairs": [_row(row) for row in rows],
        "runs": [_run(run) for run in runs],
        "unrelated": [_unrelated(run) for run in unrelated],
    }


def write(path: Path, value: dict[str, Any]) -> None:
    """Whole or not at all. What is NaN becomes null."""
    write_whole(path, json.dumps(_plain(value), indent=1, allow_nan=False) + "\n")


def read(path: Path) -> dict[str, Any]:
    """What `accuracy --json` wrote. Raises DataError, which names it, for what is no such file."""
    try:
        value = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise DataError(f"{path}: {error}") from error
    if not isinstance(value, dict) or value.get("benchmark") != "accuracy":
        raise DataError(f"{path}: not written by accuracy --json")
    return value


def _run(run: Run) -> dict[str, Any]:
    found = {
        "pair": run.pair.name,
        "tier": run.pair.tier,
        "group": run.pair.group,
        "index": run.index,
        "class": run.kind,
        "seed": run.seed,
        "T_true": run.T_true.tolist(),
        "T_est": None,
        "E_R": run.rotation,
        "E_t": run.translation,
        "E_s": run.scale,
        "success": run.success,
        "joint": run.joint,
        "among_alternatives": run.among,
        "alternatives_right": list(run.others_right),
        "wall_seconds": run.wall,
        "error": run.error or None,
    }
    if run.outcome is not None:
        found.update(_outcome(run.outcome))
    return found


def _unrelated(run: Unrelated) -> dict[str, Any]:
    found = {
        "source": run.pairing.source.name,
        "target": run.pairing.target.name,
        "group": run.pairing.source.group,
        "seed": run.seed,
        "wall_seconds": run.wall,
        "error": run.error or None,
    }
    if run.outcome is not None:
        found.update(_outcome(run.outcome))
    return found


def _outcome(outcome: Outcome) -> dict[str, Any]:
    return {
        "T_est": outcome.transformation.tolist(),
        "registered": outcome.registered,
        "reason": outcome.reason,
        **outcome.quality,
        **outcome.counts,
        "alternatives": [
            {**other._asdict(), "transformation": other.transformation.tolist()}
            for other in outcome.alternatives
        ],
        "queries": outcome.queries,
        "seconds": outcome.seconds,
    }


def _row(row: PairSummary) -> dict[str, Any]:
    return {
        "pair": row.name,
        "tier": row.tier,
        "paper_row": row.paper_row or None,
        "runs": row.runs,
        "crashed": row.crashed,
        **_figures(row.figures),
        "paper": dataclasses.asdict(row.paper) if row.paper else None,
    }


def _figures(figures: Figures) -> dict[str, Any]:
    values = dataclasses.asdict(figures)
    for name in ("rotation", "translation"):
        spread = values.pop(name)
        values[f"{name}_mean"], values[f"{name}_std"] = spread
    return values


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
