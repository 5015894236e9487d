"""The JSON for machines: every run, and the rows of the tables."""

from __future__ import annotations

import dataclasses
from typing import Any

from .runs import Options, PeerRun
from .summary import Quartiles, method_rows, ratios


def record(
    machine: dict[str, str], options: Options, left_out: dict[str, str], runs: list[PeerRun]
) -> dict[str, Any]:
    """Ready for records.write. Degrees, seconds, matrices source into target."""
    names = dict.fromkeys(run.pair.tier for run in runs)
    tiers = {tier: [run for run in runs if run.pair.tier == tier] for tier in names}
    if len(tiers) > 1:
        tiers["all"] = runs
    return {
        "benchmark": "peers",
        "machine": machine,
        "options": dataclasses.asdict(options),
        "left_out": left_out,
        "tiers": {tier: _tier(mine) for tier, mine in tiers.items()},
        "runs": [_run(run) for run in runs],
    }


def _tier(runs: list[PeerRun]) -> dict[str, Any]:
    rows = [_named(dataclasses.asdict(row), "seconds", row.seconds) for row in method_rows(runs)]
    found = [_named(dataclasses.asdict(ratio), "times", ratio.times) for ratio in ratios(runs)]
    return {"pairs": len({r.pair.name for r in runs}), "methods": rows, "ratios": found}


def _named(values: dict[str, Any], key: str, quartiles: Quartiles) -> dict[str, Any]:
    return {**values, key: quartiles._asdict()}


def _run(run: PeerRun) -> dict[str, Any]:
    return {
        "method": run.method,
        "pair": run.pair.name,
        "tier": run.pair.tier,
        "index": run.index,
        "class": run.kind,
        "voxel": run.voxel,
        "T_true": run.T_true.tolist(),
        "T_est": None if run.T_est is None else run.T_est.tolist(),
        "E_R": run.rotation,
        "E_t": run.translation,
        "success": run.success,
        "seconds": run.seconds,
        "error": run.error or None,
    }
