"""Checks the cost the library counts against the paper's formula.

With sparse-to-dense P I (delta N_s + (1 - delta) (N_d + M_d)) nearest-neighbor queries in
the evaluations of task alpha, without it P I (N_d + M_d).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace

from .pairs import Pair
from .paper_tables import RATIO_RANGE, row_of
from .runner import Options, Outcome, Register, moved


@dataclass(frozen=True)
class Budget:
    """The settings that the formula needs, as the library held them."""

    population: int  # P
    iterations: int  # I
    switch_fraction: float  # delta

    def with_switch(self, sparse: int, dense: int) -> int:
        # The switch happens at ceil(delta I), a whole iteration.
        first = math.ceil(self.switch_fraction * self.iterations)
        return self.population * (first * sparse + (self.iterations - first) * dense)

    def without_switch(self, dense: int) -> int:
        return self.population * self.iterations * dense


@dataclass(frozen=True)
class Check:
    pair: Pair
    sparse: int  # N_s
    dense: int  # N_d + M_d
    expected: tuple[int, int]  # with, without
    counted: tuple[int, int]

    @property
    def ratio(self) -> float:
        return self.counted[0] / self.counted[1] if self.counted[1] else math.nan

    @property
    def passed(self) -> bool:
        low, high = RATIO_RANGE
        return self.counted == self.expected and low <= self.ratio <= high


def check(pair: Pair, register: Register, options: Options) -> Check:
    """Registers the pair's first motion twice, with and without sparse-to-dense."""
    both = [_register(pair, register, options, switch) for switch in (1, 0)]
    budget = Budget(*(both[0].settings[field.name] for field in fields(Budget)))
    sparse = both[0].counts["sparse_source"]
    dense = both[0].counts["dense_source"] + both[0].counts["dense_target"]
    return Check(
        pair,
        sparse,
        dense,
        (budget.with_switch(sparse, dense), budget.without_switch(dense)),
        (both[0].queries["evaluation"], both[1].queries["evaluation"]),
    )


def header() -> str:
    return (
        "queries of task alpha's evaluations against the paper's formula; ratio asked for: "
        f"{100 * RATIO_RANGE[0]:g} to {100 * RATIO_RANGE[1]:g} %\n"
        f"{'pair':<27}{'N_s':>6}{'N_d+M_d':>9}{'with: formula':>15}{'counted':>12}"
        f"{'without: formula':>18}{'counted':>12}{'ratio %':>9}{'paper':>7}"
    )


def row(result: Check) -> str:
    paper = row_of(result.pair.paper_row)
    published = f"{100 * paper.queries / paper.queries_dense:.1f}" if paper else "-"
    return (
        f"{result.pair.name:<27}{result.sparse:>6}{result.dense:>9}"
        f"{result.expected[0]:>15}{result.counted[0]:>12}"
        f"{result.expected[1]:>18}{result.counted[1]:>12}"
        f"{100 * result.ratio:>9.2f}{published:>7}  {'PASS' if result.passed else 'FAIL'}"
    )


def _register(pair: Pair, register: Register, options: Options, switch: int) -> Outcome:
    case = moved(pair, 0)
    # The formula is of all iterations.
    settings = {
        **options.settings,
        "sparse_to_dense": switch,
        "stall_iterations": 0,
        "coarse_points": 0,
    }
    return register(case.source, case.target, replace(options, settings=settings), None)
