"""Plans the runs, does those that the log has not, and writes the report."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from contextlib import closing
from typing import Any

from evolving_methods.methods import CONTROLS, METHODS, user_method

import pyemtr

from .. import machine
from ..data import are_generated, chosen, related
from ..locations import REPOSITORY
from ..pairs import DataError, Pair
from . import functions, plan, report, traditional
from .execute import execute
from .plan import Context, Work
from .run_log import RunLog
from .sections import SECTIONS

LOG = "runs.jsonl"
QUICK_PAIRS, QUICK_TRANSFORMS, QUICK_SHAPES = 2, 2, 4
SHAPE_PRESETS = ("paper", "default", "fast")
#: What a smoke run leaves out: what only repeats another method with other numbers.
SMOKE_SECTIONS = ("library", "evolving", "tasks", "sweep")
SMOKE_SWEEP = (plan.rate_name(0.0), plan.rate_name(0.7), plan.switch_name(0.6))
QUICK_SWEEP = (*SMOKE_SWEEP, plan.rate_name(0.3), plan.switch_name(0.0), plan.switch_name(0.3))


def reproduce(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    if arguments.out is None:
        arguments.out = REPOSITORY / "build" / "reproduction"
        if arguments.smoke:  # which always begins anew, and apart from the user's own runs
            arguments.out = arguments.out.with_name("reproduction-smoke")
            (arguments.out / LOG).unlink(missing_ok=True)
    try:
        return _reproduce(arguments)
    except (DataError, ValueError) as error:
        print(f"reproduce: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print(f"reproduce: interrupted; start it again to go on with {arguments.out}",
              file=sys.stderr)  # fmt: skip
        return 130


def _reproduce(arguments: argparse.Namespace) -> int:
    pairs, transforms, sections, names = choose(arguments)
    context = Context(
        arguments.seed, arguments.threads, tuple(user_method(text) for text in arguments.method)
    )
    for method in context.user_methods:
        method.load()
    notes = []
    if {"evolving", "functions"} & set(sections):
        notes += [f"{m.name}: no package {m.package}; pip install '.[reproduce]'"
                  for m in CONTROLS if m.missing]  # fmt: skip
    if "traditional" in sections:
        names["traditional"], missing = traditional.there()
        notes += missing
    for note in notes:
        print(f"not run, {note}", flush=True)
    works = [
        Work(pair, index, tuple(plan.runs_of(sections, pair, index, pairs, context, names)))
        for pair in pairs
        for index in range(transforms)
    ]
    small = arguments.quick or arguments.smoke
    if "modelnet" in sections:
        shapes = min(arguments.shapes, QUICK_SHAPES) if small else arguments.shapes
        works += plan.shape_works(arguments.modelnet, shapes, SHAPE_PRESETS)
    if "functions" in sections:
        works += plan.function_works(context, 1 if small else functions.SEEDS)
    options = {"seed": arguments.seed, "threads": arguments.threads, "emtr": pyemtr.__version__}
    print(
        f"{sum(len(work.runs) for work in works)} runs: {len(pairs)} pairs, {transforms} motions "
        f"each; {arguments.jobs} at a time",
        flush=True,
    )
    with closing(RunLog(arguments.out / LOG, options, arguments.report_only)) as log:
        if not arguments.report_only:
            execute(works, context, log, arguments.jobs)
        wanted = {(*run, work.pair.name, work.index) for work in works for run in work.runs}
        records = [r for r in log.records
                   if (r["section"], r["method"], r["pair"], r["index"]) in wanted]  # fmt: skip
    if not records:
        raise DataError(f"{arguments.out}: it has none of these runs, and --report-only makes none")
    about = {**describe(arguments, pairs, transforms), "missing": notes, "planned": len(wanted)}
    path = report.write(arguments.out, records, pairs, about)
    print(f"wrote {path}, its tables and its figures")
    if arguments.page:
        print(f"wrote {report.write_page(arguments.page, records, about)}")
    return 0


def choose(
    arguments: argparse.Namespace,
) -> tuple[list[Pair], int, Sequence[str], dict[str, Sequence[str]]]:
    """Pairs, motions, sections, and the methods of those sections that do not have all of them."""
    pairs = related(chosen(arguments))
    small = sorted(pairs, key=lambda pair: pair.size)
    sections = arguments.section or list(SECTIONS)
    if arguments.smoke:
        names: dict[str, Sequence[str]] = {
            "evolving": [m.name for m in METHODS],
            "sweep": SMOKE_SWEEP,
            "library": [plan.OURS, plan.DENSE_ONLY, plan.NO_COMPLEMENT, plan.DEFAULT],
        }
        return small[:1], 1, [s for s in sections if s in SMOKE_SECTIONS], names
    if arguments.quick:
        sections = arguments.section or [s for s in SECTIONS if s != "functions"]
        transforms = min(arguments.transforms, QUICK_TRANSFORMS)
        return small[:QUICK_PAIRS], transforms, sections, {"sweep": QUICK_SWEEP}
    return pairs, arguments.transforms, sections, {}


def describe(
    arguments: argparse.Namespace, pairs: Sequence[Pair], transforms: int
) -> dict[str, Any]:
    """What the report says of how it was made."""
    known = machine.describe()
    words = ["tools/bench/reproduce"]
    words += ["--quick"] if arguments.quick else ["--smoke"] if arguments.smoke else []
    words += ["--section", *arguments.section] if arguments.section else []
    words += [word for text in arguments.method for word in ("--method", text)]
    if not arguments.smoke and not arguments.quick and transforms != 20:
        words += ["--transforms", str(transforms)]
    if arguments.shapes != 1266:
        words += ["--shapes", str(arguments.shapes)]
    generated = "; generated pairs, which are easier than real ones" if are_generated(pairs) else ""
    return {
        "command": " ".join(words),
        "motions": f"{transforms} motions each{generated}",
        "made": f"emtr at {known['revision']}, {known['date']}, "
        f"{arguments.jobs} runs at a time of {arguments.threads} thread each, "
        f"{known['cpu']}, {known['cpus']} processors, load average {os.getloadavg()[0]:.1f}",
    }
