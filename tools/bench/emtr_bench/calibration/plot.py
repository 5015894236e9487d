"""The calibration as a picture: share right over confidence, and how many runs there are."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from ..picture import new_figure, save
from .figures import Calibration


def plot(presets: Mapping[str, Calibration], path: Path) -> None:
    """Writes a PNG, whole or not at all."""
    figure = new_figure()
    reliability, counts = figure.subplots(1, 2)
    reliability.plot([0, 1], [0, 1], "k:", lw=1)
    width = 0.8 / len(presets)
    for index, (preset, found) in enumerate(presets.items()):
        rows = [row for row in found.bins if row.count]
        below = [row.right.value - row.right.low for row in rows]
        above = [row.right.high - row.right.value for row in rows]
        reliability.errorbar(
            [row.confidence for row in rows], [row.right.value for row in rows], [below, above],
            fmt="o-", ms=4, lw=1, capsize=2, label=f"{preset}: error {found.error:.3f}",
        )  # fmt: skip
        side = (index - (len(presets) - 1) / 2) * width
        step = 1 / len(found.bins)
        centers = [(row.low + row.high) / 2 + side * step for row in found.bins]
        counts.bar(centers, [row.count for row in found.bins], width * step, label=preset)
    reliability.set(xlabel="mean confidence", ylabel="share right, 95 % interval",
                    title="Reliability", xlim=(-0.02, 1.02), ylim=(-0.02, 1.02))  # fmt: skip
    counts.set(xlabel="confidence", ylabel="runs", title="Runs", yscale="log")
    for axes in (reliability, counts):
        axes.grid(True, which="major", alpha=0.3)
        axes.legend(fontsize=8)
    save(figure, path)
