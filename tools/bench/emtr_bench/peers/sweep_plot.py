"""Success against time as a picture, a tier each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from ..picture import new_figure, save
from .methods import OURS
from .settings import Setting
from .sweep import Point, fastest, frontier


def plot(tiers: Mapping[str, Sequence[Point]], recommended: Setting, path: Path) -> None:
    """Writes a PNG, whole or not at all: small dots are settings, large ones those recommended,
    rings the fastest that lose nothing, stars emtr, and the line is the frontier."""
    figure = new_figure()
    figure.set_size_inches(5.2 * len(tiers), 4.6)
    methods = list(dict.fromkeys(p.method for found in tiers.values() for p in found))
    colors = {method: f"C{number % 10}" for number, method in enumerate(methods)}
    all_axes = figure.subplots(1, len(tiers), squeeze=False)[0]
    for axes, (tier, found) in zip(all_axes, tiers.items()):
        best = frontier(found)
        axes.step([p.seconds for p in best], [p.success for p in best], "k:", lw=1, where="post")
        for method in methods:
            mine = [p for p in found if p.method == method and p.seconds == p.seconds]
            if not mine:
                continue
            x, y = [p.seconds for p in mine], [p.success for p in mine]
            if method.startswith(OURS):
                axes.plot(x, y, "*", ms=12, color=colors[method], label=method)
                continue
            sizes = [60.0 if p.setting == recommended else 14.0 for p in mine]
            axes.scatter(x, y, sizes, color=colors[method], label=method)
            ring = fastest(mine, recommended) if any(s > 20 for s in sizes) else mine[0]
            axes.plot([ring.seconds], [ring.success], "o", ms=12, mfc="none", color=colors[method])
        axes.set(xscale="log", xlabel="median seconds", ylabel="joint success, %", title=tier)
        axes.grid(True, which="major", alpha=0.3)
    all_axes[-1].legend(fontsize=7)
    save(figure, path)
