"""The scaling benchmark as a picture: time by stage, and memory, over the number of points."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .picture import new_figure, save


def plot(rows: Sequence[dict[str, Any]], path: Path) -> None:
    """Writes a PNG, whole or not at all."""
    figure = new_figure()
    time, memory = figure.subplots(1, 2)
    points = [row["points"] for row in rows]
    for stage in ("normalization", "downsampling", "features", "matching", "evolution"):
        time.loglog(points, [row["stages"][stage] for row in rows], ".-", lw=1, label=stage)
    time.loglog(points, [row["seconds"] for row in rows], "ko-", label="total")
    time.loglog(points, [row["seconds_kept"] for row in rows], "k:", label="both clouds kept")
    time.set(xlabel="points of each cloud", ylabel="seconds", title="Time")
    time.legend(fontsize=8)
    memory.loglog(points, [row["peak_bytes"] / 1e6 for row in rows], "ko-", label="process, peak")
    memory.loglog(points, [row["input_bytes"] / 1e6 for row in rows], "b--", label="input arrays")
    memory.loglog(points, [3 * row["input_bytes"] / 1e6 for row in rows], "r:", label="3 x input")
    memory.set(xlabel="points of each cloud", ylabel="MB", title="Resident memory")
    memory.legend(fontsize=8)
    for axes in (time, memory):
        axes.grid(True, which="major", alpha=0.3)
    save(figure, path)
