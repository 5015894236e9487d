"""Confidence against the share of runs that were right."""

from __future__ import annotations

from typing import Any

from .markdown import number, table

_FIGURES = ("preset", "runs", "unrelated", "right", "calibration error", "Brier score", "AUC",
            "precision", "recall")  # fmt: skip
_BINS = ("confidence", "runs", "mean confidence", "share right", "95 % interval")


def calibration_section(value: dict[str, Any], plot: str) -> str:
    presets = value["presets"]
    parts = [
        table(_FIGURES, [_figures(name, found) for name, found in presets.items()]),
        f"![share right over confidence]({plot})",
    ]
    for name, found in presets.items():
        parts.append(f"### Preset {name}")
        parts.append(table(_BINS, [_bin(row) for row in found["bins"]]))
    return "\n\n".join(parts)


def _figures(name: str, found: dict[str, Any]) -> list[str]:
    return [
        f"`{name}`",
        *(str(found[key]) for key in ("runs", "unrelated", "right")),
        number(found["error"], 3),
        number(found["brier"], 4),
        number(found["auc"], 4),
        _share(found["precision"]),
        _share(found["recall"]),
    ]


def _bin(row: dict[str, Any]) -> list[str]:
    right = row["right"]
    return [
        f"{row['low']:.2f} to {row['high']:.2f}",
        str(row["count"]),
        number(row["confidence"], 3),
        number(right["value"], 3),
        "" if right["low"] is None else f"{right['low']:.3f} to {right['high']:.3f}",
    ]


def _share(found: dict[str, Any]) -> str:
    if found["value"] is None:
        return ""
    return f"{found['value']:.3f} ({found['low']:.3f} to {found['high']:.3f})"
