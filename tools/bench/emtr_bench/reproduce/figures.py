"""The figures of numbers: bars, sweeps, convergence. Each writes a PNG if it has runs."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..whole_file import write_whole
from . import plan, published
from .figures_of_runs import chosen, mean_over_pairs, pair_rows, percent, spread
from .run_log import Record

Records = Sequence[Record]
OURS_COLOR, OTHER_COLOR, PAPER_COLOR = "#b03a2e", "#7f8c8d", "#2e6da4"
#: Of the other methods; no red, which is ours.
COLORS = ("C0", "C1", "C2", "C4", "C5", "C6", "C7", "C8", "C9", "#1b2631", "#a9cce3", "#f5b7b1")


def canvas(rows: int = 1, columns: int = 1, size: tuple[float, float] = (8.0, 3.6)) -> Any:
    """A figure and its axes, drawn without a screen."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, layout="constrained")
    FigureCanvasAgg(figure)
    return figure, figure.subplots(rows, columns, squeeze=False)


def save(figure: Any, path: Path) -> Path:
    content = io.BytesIO()
    figure.savefig(content, format="png", dpi=110)
    write_whole(path, content.getvalue())
    return path


def average_success(records: Records, path: Path) -> Path | None:
    mine, dense = chosen(records, "evolving"), chosen(records, "evaluations")
    ours = chosen(records, "library", plan.OURS)
    if not mine or not ours:
        return None
    names = [*dict.fromkeys(r["method"] for r in mine), plan.OURS]
    series = (
        ("EMTR-SSC's queries", OURS_COLOR,
         [mean_over_pairs(chosen([*mine, *ours], s, n), percent)
          for n in names for s in ["library" if n == plan.OURS else "evolving"]]),
        ("its evaluations, all dense", OTHER_COLOR,
         [mean_over_pairs(chosen(dense, "evaluations", n), percent) for n in names]),
        ("published", PAPER_COLOR,
         [_published_success(n) for n in names]),
    )  # fmt: skip
    figure, axes = canvas()
    drawn = [one for one in series if not np.isnan(one[2]).all()]
    for i, (label, color, values) in enumerate(drawn):
        axes[0, 0].bar(np.arange(len(names)) + 0.27 * (i - 1), values, 0.25, label=label,
                       color=color)  # fmt: skip
    axes[0, 0].set_xticks(range(len(names)), names, rotation=30, ha="right")
    axes[0, 0].set_ylabel("average success, %")
    axes[0, 0].set_ylim(0, 105)
    axes[0, 0].legend(fontsize=8)
    return save(figure, path)


def success_bars(records: Records, path: Path) -> Path | None:
    mine, ours = chosen(records, "evolving"), chosen(records, "library", plan.OURS)
    if not mine or not ours:
        return None
    budgets = [(mine, "EMTR-SSC's queries")]
    if dense := chosen(records, "evaluations"):
        budgets.append((dense, "its evaluations, all dense"))
    figure, axes = canvas(len(budgets), 1, (11.0, 0.6 + 3.2 * len(budgets)))
    for axis, (runs, title) in zip(axes[:, 0], budgets):
        _bars_by_pair(axis, runs, ours)
        axis.set_title(title, fontsize=9, loc="left")
    handles, labels = axes[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, fontsize=7, ncols=len(labels), loc="outside upper center")
    return save(figure, path)


def _bars_by_pair(axis: Any, mine: Records, ours: Records) -> None:
    names, rows = list(dict.fromkeys(r["method"] for r in mine)), pair_rows(mine)
    width = 0.86 / (len(names) + 1)
    for i, name in enumerate([*names, plan.OURS]):
        runs = ours if name == plan.OURS else [r for r in mine if r["method"] == name]
        values = [percent([r for r in runs if r["pair"] == pair]) for pair in rows]
        places = np.arange(len(rows)) + width * (i - len(names) / 2)
        axis.bar(places, values, width, label=name,
                 color=OURS_COLOR if name == plan.OURS else COLORS[i % len(COLORS)])  # fmt: skip
    axis.set_xticks(range(len(rows)), list(rows.values()), rotation=30, ha="right")
    axis.set_ylabel("success, %")


def sweep(records: Records, path: Path) -> Path | None:
    mine = chosen(records, "sweep")
    if not mine:
        return None
    figure, axes = canvas(2, 2, (8.0, 5.2))
    for row, (name, values, paper) in enumerate((
        ("rmp", plan.RATES, 0.7), ("delta", plan.SWITCHES, 0.6))):  # fmt: skip
        runs = [chosen(mine, "sweep", f"{name} {value:.1f}") for value in values]
        axes[row, 0].plot(values, [percent(r) for r in runs], "o-", color=OURS_COLOR)
        axes[row, 0].set_ylabel("success, %")
        axes[row, 0].set_ylim(-3, 103)
        for i, (column, factor, label) in enumerate(
            (("E_R", 1.0, "E_R, degrees"), ("E_t", 100.0, "E_t x 100"))):  # fmt: skip
            for stage, style in ((column, "o-"), (f"{column}_sparse", "o--")):
                means = [spread(r, stage, factor) for r in runs]
                axes[row, 1].plot(values, [np.nan if m is None else m.mean for m in means], style,
                                  color=f"C{i}", ms=4,
                                  label=label if stage == column else None)  # fmt: skip
        axes[row, 1].plot([], [], "k--", label="end of the sparse stage")
        axes[row, 1].set_yscale("log")
        axes[row, 1].legend(fontsize=7)
        for axis in axes[row]:
            axis.axvline(paper, color=PAPER_COLOR, lw=0.8, ls=":")
            axis.set_xlabel(f"{name} (dotted: the paper's choice)")
    return save(figure, path)


def complement(records: Records, path: Path) -> Path | None:
    names = (plan.OURS, plan.NO_COMPLEMENT)
    parts = [chosen(records, "library", n) for n in names]
    if not all(parts):
        return None
    rows = pair_rows(parts[0])
    figure, axes = canvas(1, 2, (9.0, 3.4))
    for i, (name, runs) in enumerate(zip(names, parts)):
        places = np.arange(len(rows)) + 0.4 * (i - 0.5)
        each = [[r for r in runs if r["pair"] == pair] for pair in rows]
        label = "on" if i == 0 else "off"
        color = (OURS_COLOR, OTHER_COLOR)[i]
        axes[0, 0].bar(places, [percent(r) for r in each], 0.38, label=label, color=color)
        errors = [spread(r, "E_R") for r in each]
        axes[0, 1].bar(places, [0.0 if e is None else e.mean for e in errors], 0.38, color=color)
        del name
    axes[0, 0].legend(title="complement", fontsize=8)
    for axis, label in zip(axes[0], ("success, %", "E_R of the successes, degrees")):
        axis.set_xticks(range(len(rows)), list(rows.values()), rotation=40, ha="right", fontsize=8)
        axis.set_ylabel(label)
    return save(figure, path)


def convergence(records: Records, path: Path) -> Path | None:
    """The median over runs of the best mean of rho on the dense clouds, over the queries."""
    others = chosen(records, "evaluations") or chosen(records, "evolving")
    mine = [*others, *chosen(records, "tasks", plan.PYTHON)]
    mine = [r for r in mine if r.get("history")]
    if not mine:
        return None
    figure, axes = canvas(size=(8.0, 4.2))
    for i, name in enumerate(dict.fromkeys(r["method"] for r in mine)):
        runs = [r for r in mine if r["method"] == name]
        grid = np.linspace(0.0, max(r["queries"] for r in runs), 200)
        curves = np.array([_best_until(r["history"], grid) for r in runs])
        ours = name == plan.PYTHON
        with np.errstate(invalid="ignore"):
            known = np.isfinite(curves).all(axis=0)
        axes[0, 0].plot(grid[known] * 1e-6, np.median(curves[:, known], axis=0), label=name,
                        lw=2.4 if ours else 1.2,
                        color=OURS_COLOR if ours else COLORS[i % len(COLORS)])  # fmt: skip
    axes[0, 0].set_xlabel("million nearest-neighbor queries")
    axes[0, 0].set_ylabel("best mean of rho, dense")
    axes[0, 0].legend(fontsize=8, ncols=2)
    return save(figure, path)


def _best_until(history: list[list[float]], grid: np.ndarray) -> np.ndarray:
    used, value = np.array(history, dtype=np.float64).T
    place = np.searchsorted(used, grid, side="right") - 1
    return np.where(place >= 0, value[np.maximum(place, 0)], np.nan)


def _published_success(name: str) -> float:
    found = published.value("success_ratio", name, "average_success_ratio_percent")
    return np.nan if found is None else found.mean


#: Name of the file, what it shows, and how it is drawn.
ALL: tuple[tuple[str, str, Callable[[Records, Path], Path | None]], ...] = (
    ("average_success", "Average success ratio, with both budgets, beside the paper's",
     average_success),
    ("success_bars", "Success by pair", success_bars),
    ("sweep", "Success and errors over rmp and delta", sweep),
    ("complement", "Knowledge complement on and off", complement),
    ("convergence", "Convergence: the median over all runs",
     convergence),
)  # fmt: skip


def draw(records: Records, folder: Path, prefix: str = "") -> dict[str, tuple[str, Path]]:
    """Name to caption and file, of those that there are runs for."""
    folder.mkdir(parents=True, exist_ok=True)
    found = {}
    for name, caption, make in ALL:
        path = make(records, folder / f"{prefix}{name}.png")
        if path is not None:
            found[name] = (caption, path)
    return found
