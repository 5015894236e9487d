"""Success, errors and verdict by tier, and the paper's pairs one by one."""

from __future__ import annotations

import statistics
from typing import Any

from .markdown import number, table

_TIER_HEADS = ("tier", "pairs", "runs", "success %", "joint %", "median E_R", "mean E_R",
               "mean E_t x 100", "seconds", "precision %", "recall %")  # fmt: skip
_PAIR_HEADS = ("pair", "success %", "the paper's row", "E_R", "the paper's", "E_t x 100",
               "the paper's", "queries, 10^6", "the paper's", "seconds")  # fmt: skip


def accuracy_section(value: dict[str, Any]) -> str:
    runs = value["runs"]
    tiers = list(dict.fromkeys(run["tier"] for run in runs))
    rows = [_tier(tier, [run for run in runs if run["tier"] == tier]) for tier in tiers]
    if len(tiers) > 1:
        rows.append(_tier("all", runs))
    parts = [f"Preset `{value['options']['preset']}`.", table(_TIER_HEADS, rows)]
    if len(tiers) == 1 and all(pair["paper"] for pair in value["pairs"]):
        parts.append(table(_PAIR_HEADS, [_pair(pair) for pair in value["pairs"]]))
    return "\n\n".join(parts)


def _tier(tier: str, runs: list[dict[str, Any]]) -> list[str]:
    good = [run for run in runs if run["success"]]
    registered = [run for run in runs if run.get("registered")]
    joint = [run for run in runs if run["joint"]]
    seconds = [run["wall_seconds"] for run in runs if not run["error"]]
    rotations = [run["E_R"] for run in good]
    return [
        tier,
        str(len({run["pair"] for run in runs})),
        str(len(runs)),
        _percent(len(good), len(runs)),
        _percent(len(joint), len(runs)),
        number(statistics.median(rotations), 3) if good else "",
        number(statistics.fmean(rotations), 3) if good else "",
        number(100 * statistics.fmean(run["E_t"] for run in good), 3) if good else "",
        number(statistics.fmean(seconds), 3) if seconds else "",
        _percent(sum(run["joint"] for run in registered), len(registered)),
        _percent(sum(bool(run.get("registered")) for run in joint), len(joint)),
    ]


def _pair(pair: dict[str, Any]) -> list[str]:
    paper = pair["paper"]
    return [
        pair["pair"],
        number(pair["success"], 1),
        pair["paper_row"],
        number(pair["rotation_mean"], 3),
        number(paper["rotation"][0], 3),
        number(pair["translation_mean"], 3),
        number(paper["translation"][0], 3),
        number(pair["evaluation"]),
        number(paper["queries"]),
        number(pair["seconds"], 3),
    ]


def _percent(count: int, of: int) -> str:
    return number(100.0 * count / of, 1) if of else ""
