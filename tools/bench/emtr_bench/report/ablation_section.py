"""Joint success with each part off in turn."""

from __future__ import annotations

from typing import Any

from .markdown import number, table


def ablation_section(value: dict[str, Any]) -> str:
    tiers = [tier for tier, _ in value["pairs"]]
    heads = ["off", *(f"{tier} ({pairs})" for tier, pairs in value["pairs"]), "all", "lost", "won",
             "seconds"]  # fmt: skip
    motions = f"{value['transforms']} motion" + "s" * (value["transforms"] != 1)
    parts = [f"Preset `{value['preset']}`, {motions} a pair."]
    for block in dict.fromkeys(row["block"] for row in value["rows"]):
        rows = [
            [row["part"], *(number(row["joint"][tier], 1) for tier in tiers),
             number(row["joint_all"], 1), str(row["lost"]), str(row["won"]),
             number(row["seconds"], 3)]
            for row in value["rows"] if row["block"] == block
        ]  # fmt: skip
        parts += [f"The method, {block}:", table(heads, rows)]
    return "\n\n".join(parts)
