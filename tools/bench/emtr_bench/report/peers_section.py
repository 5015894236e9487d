"""emtr beside other libraries, by tier."""

from __future__ import annotations

from typing import Any

from .markdown import number, quartiles, table

_METHOD_HEADS = ("method", "runs", "lost", "success %", "median E_R", "mean E_R",
                 "median E_t x 100", "mean E_t x 100", "seconds: median (quartiles)")  # fmt: skip

_SWEEP = (
    "The setting of the least median time among those with no less success than the recommended "
    "one has, chosen on these same runs. Points: left by the voxels in both clouds together, for "
    "the search and for the refinement."
)
_SWEEP_HEADS = ("method", "points: search", "points: refinement", "success %",
                "seconds: median (quartiles)")  # fmt: skip


def peers_section(value: dict[str, Any], picture: str) -> str:
    """`picture`: the path from the page of what a sweep has drawn."""
    machine = value["machine"]
    others = [name for name in ("open3d", "kiss_matcher", "small_gicp") if name in machine]
    versions = ", ".join(f"{name} {machine[name]}" for name in others)
    options = value["options"]
    parts = [
        f"Versions: {versions or 'no other library'}. {options['threads']} threads each; the voxel "
        f"given to the others leaves {options['voxel_points']} points in both clouds together."
    ]
    if value["left_out"]:
        reasons = ", ".join(f"{name} ({why})" for name, why in value["left_out"].items())
        parts.append(f"Left out: {reasons}.")
    for tier, figures in value["tiers"].items():
        parts.append(f"### Tier {tier}: {figures['pairs']} pairs")
        parts.append(table(_METHOD_HEADS, [_method(row) for row in figures["methods"]]))
        if figures["ratios"]:
            parts.append(_ratios(figures["ratios"]))
    if value.get("sweep"):
        parts.append(f"![Success against time, at each setting of the other libraries]({picture})")
    for tier, figures in (value.get("sweep") or {}).items():
        parts.append(f"### Tier {tier}: the others at their fastest")
        parts.append(_SWEEP)
        rows = [_swept(row, figures["fastest"][row["method"]]) for row in figures["methods"]]
        parts.append(table(_SWEEP_HEADS, rows))
        if figures["ratios"]:
            parts.append(_ratios(figures["ratios"]))
    return "\n\n".join(parts)


def _method(row: dict[str, Any]) -> list[str]:
    translations = (row["median_translation"], row["mean_translation"])
    return [
        row["method"],
        str(row["runs"]),
        str(row["lost"]),
        number(row["success"], 1),
        number(row["median_rotation"], 3),
        number(row["mean_rotation"], 3),
        *(number(None if t is None else 100 * t, 3) for t in translations),
        quartiles(row["seconds"]),
    ]


def _swept(row: dict[str, Any], setting: dict[str, Any] | None) -> list[str]:
    search, refine = "", ""
    if setting is not None:
        search, refine = str(setting["search_points"]), str(setting["refine_points"] or "its own")
    return [row["method"], search, refine, number(row["success"], 1), quartiles(row["seconds"])]


def _ratios(ratios: list[dict[str, Any]]) -> str:
    """A row a peer, a column a preset."""
    ours = list(dict.fromkeys(ratio["ours"] for ratio in ratios))
    rows = []
    for peer in dict.fromkeys(ratio["peer"] for ratio in ratios):
        mine = {ratio["ours"]: ratio["times"] for ratio in ratios if ratio["peer"] == peer}
        rows.append([peer, *(quartiles(mine[name], 2) for name in ours)])
    heads = ["our seconds / theirs, pair by pair", *ours]
    return table(heads, rows)
