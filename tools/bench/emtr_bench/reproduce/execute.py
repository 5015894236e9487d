"""One run of any section, and all that are to be done."""

from __future__ import annotations

import functools
import sys
import time
from collections.abc import Callable, Iterator
from typing import Any

from evolving_methods import emtr_ssc

from ..jobs import side_by_side
from . import cases, functions, modelnet, plan, precision, sweep, traditional
from .plan import Context, Work
from .run_log import Record, RunLog


def execute(works: list[Work], context: Context, log: RunLog, jobs: int) -> None:
    """Does what the log has not, and tells how far it is."""
    left = [_missing(work, log) for work in works]
    left = [work for work in left if work.runs]
    total, done, start = sum(len(work.runs) for work in left), 0, time.monotonic()
    already = sum(len(work.runs) for work in works) - total
    if already:
        print(f"{already} runs are in {log.path} already; {total} are left", flush=True)
    for work, records in zip(left, results(left, context, jobs)):
        log.append(records)
        done += len(records)
        seconds = (time.monotonic() - start) / done * (total - done)
        print(f"[{done}/{total}] {work.pair.name}, motion {work.index}; "
              f"about {seconds / 60:.1f} min left", file=sys.stderr, flush=True)  # fmt: skip


def results(works: list[Work], context: Context, jobs: int) -> Iterator[list[Record]]:
    yield from side_by_side(functools.partial(do, context=context), works, jobs)


def do(work: Work, context: Context) -> list[Record]:
    return [run(section, method, work, context) for section, method in work.runs]


def run(section: str, method: str, work: Work, context: Context) -> Record:
    """One record. What a method raises ends the program: a method that cannot run is an error."""
    found = _SECTIONS[section](method, work, context)
    return {
        "section": section, "method": method, "pair": work.pair.name, "index": work.index,
        "row": work.pair.paper_row, "tier": work.pair.tier, **found,
    }  # fmt: skip


def _missing(work: Work, log: RunLog) -> Work:
    done = [run for run in work.runs if log.has((*run, work.pair.name, work.index))]
    return work.without(done)


def _library(method: str, work: Work, context: Context) -> dict[str, Any]:
    preset, settings = plan.LIBRARY[method]
    return cases.register(
        work.pair, work.index, context.seed + work.index, context.threads, preset, settings
    )


def _sweep(method: str, work: Work, context: Context) -> dict[str, Any]:
    return sweep.run(method, work.pair, work.index, context.seed + work.index, context.threads)


def _evolving(method: str, work: Work, context: Context, kind: str) -> dict[str, Any]:
    return cases.evolve(
        work.pair, work.index, context.seed + work.index, context.threads,
        context.methods[method], kind,
    )  # fmt: skip


def _tasks(method: str, work: Work, context: Context) -> dict[str, Any]:
    settings = emtr_ssc.Settings(adaptive=method == plan.ADAPTIVE)
    return cases.evolve_emtr(
        work.pair, work.index, context.seed + work.index, context.threads, settings
    )


def _traditional(method: str, work: Work, context: Context) -> dict[str, Any]:
    return traditional.run(method, work.pair, work.index, context.seed + work.index)


def _modelnet(method: str, work: Work, context: Context) -> dict[str, Any]:
    return modelnet.run(method, str(work.pair.folder), context.seed, context.threads)


def _precision(method: str, work: Work, context: Context) -> dict[str, Any]:
    return precision.run(method, work.pair, work.index, context.seed + work.index, context.threads)


def _functions(method: str, work: Work, context: Context) -> dict[str, Any]:
    chosen = context.methods.get(method, method)  # or the name of a public one
    return functions.run(chosen, work.pair.name, context.seed + work.index)


_SECTIONS: dict[str, Callable[[str, Work, Context], dict[str, Any]]] = {
    "library": _library,
    "evolving": functools.partial(_evolving, kind=cases.EQUAL_QUERIES),
    "evaluations": functools.partial(_evolving, kind=cases.EQUAL_EVALUATIONS),
    "tasks": _tasks,
    "sweep": _sweep,
    "traditional": _traditional,
    "modelnet": _modelnet,
    "precision": _precision,
    "functions": _functions,
}
