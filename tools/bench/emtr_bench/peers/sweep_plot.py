"""Success against time as a picture, a tier each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from matplotlib.ticker import NullFormatter

from ..picture import new_figure, save
from .methods import OURS
from .settings import Setting
from .sweep import Point, fastest, frontier

MOST_COLUMNS = 4


def plot(tiers: Mapping[str, Sequence[Point]], recommended: Setting, path: Path) -> None:
    """Writes a PNG, whole or not at all: small dots are settings, large ones those recommended,
    rings the fastest that lose nothing, stars emtr, and the line is the frontier."""
    columns = min(len(tiers), MOST_COLUMNS)
    rows = -(-len(tiers) // columns)
    figure = new_figure()
    figure.set_size_inches(max(8.0, 4.4 * columns), 4.0 * rows + 0.8)
    methods = list(dict.fromkeys(p.method for found in tiers.values() for p in found))
    colors = {method: f"C{number % 10}" for number, method in enumerate(methods)}
    all_axes = figure.subplots(rows, columns, squeeze=False, sharey=True).ravel()
    for axes, (tier, found) in zip(all_axes, tiers.items()):
        best = frontier(found)
        axes.step([p.seconds for p in best], [p.success for p in best], "k:", lw=1, where="post")
        for method in methods:
            mine = [p for p in found if p.method == method and p.seconds == p.seconds]
            if mine:
                _draw(axes, mine, recommended, colors[method])
        axes.set(xscale="log", xlabel="median seconds", title=tier, ylim=(-4, 104))
        axes.xaxis.set_major_formatter("{x:g}")
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.grid(True, which="both", alpha=0.3)
    for axes in all_axes[::columns]:
        axes.set(ylabel="joint success, %")
    for axes in all_axes[len(tiers) :]:
        axes.remove()
    known = {label: line for axes in all_axes[: len(tiers)]
             for line, label in zip(*axes.get_legend_handles_labels())}  # fmt: skip
    figure.legend(known.values(), known.keys(), loc="outside lower center", ncols=4, fontsize=8)
    save(figure, path)


def _draw(axes: Any, mine: Sequence[Point], recommended: Setting, color: str) -> None:
    """One method: its points at least one, all of them with a time."""
    method = mine[0].method
    x, y = [p.seconds for p in mine], [p.success for p in mine]
    if method.startswith(OURS):
        axes.plot(x, y, "*", ms=12, color=color, label=method, ls="none")
        return
    sizes = [60.0 if p.setting == recommended else 14.0 for p in mine]
    axes.scatter(x, y, sizes, color=color, label=method)
    if any(p.setting == recommended for p in mine):
        ring = fastest(mine, recommended)
        axes.plot([ring.seconds], [ring.success], "o", ms=12, mfc="none", color=color)
