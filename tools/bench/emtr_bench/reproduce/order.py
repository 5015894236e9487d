"""The order of the methods by mean success, ours beside the paper's."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from . import plan, published
from .figures_of_runs import chosen, mean_over_pairs, percent
from .run_log import Record

#: Sections, the fairer budget first, and what each budget is.
BUDGETS = (("evaluations", "evaluations"), ("evolving", "queries"))
BY_CHANCE = 2.0  # standard errors of a difference that says nothing


def text(records: Sequence[Record]) -> list[str]:
    """One point: both orders, their correlation, and which methods are swapped by more than chance.
    The larger budget, where it was run, because the paper's is most likely that."""
    from scipy.stats import kendalltau

    for section, budget in BUDGETS:
        ours, paper = _means(records, section)
        if len(ours) < 3:
            continue
        tau = float(kendalltau(list(ours.values()), [paper[name] for name in ours]).statistic)
        runs = min(len(chosen(records, section, name)) for name in ours if name != plan.OURS)
        swapped = _swapped(ours, paper, runs)
        return [
            f"Order by mean success, with as many {budget}: {_listed(ours)}; published: "
            f"{_listed(paper)}. Kendall's tau is {tau:.2f} (1: the same order). "
            + (f"Swapped by more than two standard errors: {', '.join(swapped)}."
               if swapped else "No two are swapped by more than two standard errors.")
        ]  # fmt: skip
    return []


def _means(records: Sequence[Record], section: str) -> tuple[dict[str, float], dict[str, float]]:
    """Success in percent, ours and published, of the methods that have both."""
    runs = {name: chosen(records, section, name)
            for name in dict.fromkeys(r["method"] for r in chosen(records, section))}  # fmt: skip
    if not runs:
        return {}, {}
    runs[plan.OURS] = chosen(records, "library", plan.OURS)
    ours, paper = {}, {}
    for name, found in runs.items():
        known = published.value("success_ratio", name, "average_success_ratio_percent")
        if found and known is not None:
            ours[name], paper[name] = mean_over_pairs(found, percent), known.mean
    return ours, paper


def _listed(means: dict[str, float]) -> str:
    order = sorted(means, key=lambda name: -means[name])
    return ", ".join(f"{name} {means[name]:.1f}" for name in order)


def _swapped(ours: dict[str, float], paper: dict[str, float], runs: int) -> list[str]:
    found = []
    for a, b in itertools.permutations(ours, 2):
        variance = sum(p * (100.0 - p) / runs for p in (ours[a], ours[b]))
        beyond = ours[a] - ours[b] > BY_CHANCE * math.sqrt(variance)
        if beyond and paper[a] < paper[b]:
            found.append(f"{a} is ahead of {b}")
    return found
