"""The JSON for machines: every run, and the rows of the tables."""

from __future__ import annotations

import dataclasses
from typing import Any

from ..data import are_generated
from .runs import Options, PeerRun
from .settings import Setting
from .summary import Quartiles, method_rows, ratios
from .sweep import at_recommended, at_their_fastest, frontier, points


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
        "options": {
            **dataclasses.asdict(options),
            "voxel_points": options.recommended.search_points,
        },
        "generated_pairs": are_generated(run.pair for run in runs),
        "left_out": left_out,
        "tiers": {
            tier: _tier(at_recommended(mine, options.recommended)) for tier, mine in tiers.items()
        },
        "sweep": {tier: _sweep(mine, options.recommended) for tier, mine in tiers.items()}
        if len({run.setting for run in runs} - {None}) > 1
        else None,
        "runs": [_run(run) for run in runs],
    }


def _tier(runs: list[PeerRun]) -> dict[str, Any]:
    rows = [_named(dataclasses.asdict(row), "seconds", row.seconds) for row in method_rows(runs)]
    found = [_named(dataclasses.asdict(ratio), "times", ratio.times) for ratio in ratios(runs)]
    return {"pairs": len({r.pair.name for r in runs}), "methods": rows, "ratios": found}


def _sweep(runs: list[PeerRun], recommended: Setting) -> dict[str, Any]:
    """Every point, which are on the frontier, and the tables with the others at their fastest."""
    found = points(runs)
    best = frontier(found)
    rows = [
        {
            **_named(dataclasses.asdict(point.row), "seconds", point.row.seconds),
            "setting": _setting(point.setting),
            "frontier": point in best,
        }
        for point in found
    ]
    kept = at_their_fastest(runs, recommended)
    chosen = {run.method: _setting(run.setting) for run in kept}
    return {"points": rows, "fastest": chosen, **_tier(kept)}


def _setting(setting: Setting | None) -> dict[str, Any] | None:
    return None if setting is None else dataclasses.asdict(setting)


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
        "setting": _setting(run.setting),
        "T_true": run.T_true.tolist(),
        "T_est": None if run.T_est is None else run.T_est.tolist(),
        "E_R": run.rotation,
        "E_t": run.translation,
        "success": run.success,
        "seconds": run.seconds,
        "error": run.error or None,
    }
