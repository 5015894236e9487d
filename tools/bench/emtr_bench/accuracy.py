"""The accuracy benchmark: chooses pairs, runs them, prints and writes what came out."""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from typing import Protocol

from . import accuracy_text, pairings, queries, records, summary, unrelated
from .data import chosen, related
from .pairs import DataError, Pair
from .runner import Array, Options, Outcome, Run, Sensors, run_all

SMOKE_PAIRS, SMOKE_TRANSFORMS = 2, 2


class Engine(Protocol):
    """The library under measurement; tests use a fake one."""

    version: str

    def register(
        self, source: Array, target: Array, options: Options, sensors: Sensors | None
    ) -> Outcome: ...

    def check(self, options: Options) -> None:
        """Raises ValueError, naming it, when the preset or a setting is unknown."""

    def fitness(self, run: Run, options: Options) -> tuple[float, float]:
        """Returns the mean of rho over the dense clouds for the true and the estimated pose."""


@dataclass(frozen=True)
class Plan:
    pairs: list[Pair]
    pairings: list[pairings.Pairing]
    transforms: int
    jobs: int
    options: Options


def accuracy(arguments: argparse.Namespace, engine: Engine) -> int:
    """Does what the command line says; gives the exit code."""
    try:
        return measure(arguments, engine)
    except DataError as error:
        print(f"accuracy: {error}", file=sys.stderr)
        return 2


def measure(arguments: argparse.Namespace, engine: Engine) -> int:
    """The same for another program, which gets the DataError and tells it under its own name."""
    options = make_options(arguments, engine)
    pairs = chosen(arguments)
    transforms = arguments.transforms
    apart = [] if arguments.smoke or arguments.queries else pairings.given(pairs)
    pairs = related(pairs)
    if arguments.smoke:
        pairs = sorted(pairs, key=lambda pair: pair.size)[:SMOKE_PAIRS]
        transforms = min(transforms, SMOKE_TRANSFORMS)
    made = pairings.choose(pairs, arguments.unrelated)
    if len(made) < arguments.unrelated:
        print(f"--unrelated {arguments.unrelated}: the chosen pairs make {len(made)} pairings of "
              "scans that do not belong together, and no more")  # fmt: skip
    apart += made
    plan = Plan(pairs, apart, transforms, arguments.jobs, options)
    return (check_queries if arguments.queries else measure_accuracy)(plan, arguments, engine)


def make_options(arguments: argparse.Namespace, engine: Engine) -> Options:
    settings = dict(arguments.set)
    if arguments.queries and "sparse_to_dense" in settings:
        raise DataError("--queries runs with and without sparse_to_dense: do not --set it")
    if arguments.queries and arguments.unrelated:
        raise DataError("--queries judges no pose: no --unrelated")
    preset = arguments.preset or ("paper" if arguments.queries else "default")
    options = Options(
        preset, arguments.seed, arguments.threads, settings, arguments.viewpoints, arguments.prior,
        arguments.scale,
    )  # fmt: skip
    if options.scale and (
        options.prior or arguments.queries or arguments.failures or "scale" in settings
    ):
        raise DataError("--scale: not with --prior, --queries, --failures or --set scale=")
    try:
        engine.check(options)
    except ValueError as error:
        raise DataError(str(error)) from error
    return options


def measure_accuracy(plan: Plan, arguments: argparse.Namespace, engine: Engine) -> int:
    places = ", sensor positions given where known" if plan.options.viewpoints else ""
    places += f", prior: {plan.options.prior}" if plan.options.prior else ""
    places += f", unknown scale: {plan.options.scale}" if plan.options.scale else ""
    print(f"preset {plan.options.preset}, {plan.transforms} transforms a pair, "
          f"seeds {plan.options.seed}+, emtr {engine.version}{places}")  # fmt: skip
    print(accuracy_text.header(), flush=True)
    runs: list[Run] = []
    rows: list[summary.PairSummary] = []
    finished = run_all(plan.pairs, plan.transforms, engine.register, plan.options, plan.jobs)
    for pair in plan.pairs:
        if rows and rows[-1].tier != pair.tier:
            print(_tier_mean(rows, runs, rows[-1].tier))
        mine = [next(finished) for _ in range(plan.transforms)]
        runs += mine
        rows.append(summary.summarise(mine))
        print(accuracy_text.row(rows[-1]), flush=True)
    if len({row.tier for row in rows}) > 1:
        print(_tier_mean(rows, runs, rows[-1].tier))
    average = summary.mean_figures(rows, runs)
    print(accuracy_text.rule())
    print(accuracy_text.mean_rows("mean", average, rows))
    print(accuracy_text.footer(runs, rows, average), flush=True)
    others = list(unrelated.run_all(plan.pairings, engine.register, plan.options, plan.jobs))
    if others:
        print(unrelated.text(others))
    if arguments.failures:
        print(accuracy_text.failures(runs, lambda run: engine.fitness(run, plan.options)))
    if arguments.json:
        value = records.record(plan.options, engine.version, runs, rows, average, others)
        records.write(arguments.json, value)
        print(f"wrote {arguments.json}")
    missed = accuracy_text.marks(rows) + unrelated.marks(others)
    if arguments.require:
        print("marks: " + ("; ".join(missed) if missed else "met"))
    crashed = any(run.error for run in runs) or any(run.error for run in others)
    return int(crashed or bool(arguments.require and missed))


def check_queries(plan: Plan, arguments: argparse.Namespace, engine: Engine) -> int:
    print(queries.header(), flush=True)
    passed = 0
    for pair in plan.pairs:
        result = queries.check(pair, engine.register, plan.options)
        passed += result.passed
        print(queries.row(result), flush=True)
    print(f"{passed} of {len(plan.pairs)} pairs PASS")
    return int(bool(arguments.require and passed < len(plan.pairs)))


def _tier_mean(rows: list[summary.PairSummary], runs: list[Run], tier: str) -> str:
    mine = [row for row in rows if row.tier == tier]
    figures = summary.mean_figures(mine, [run for run in runs if run.pair.tier == tier])
    return accuracy_text.mean_rows(f"  mean of {tier}", figures, mine)
