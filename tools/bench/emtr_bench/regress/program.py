"""Counts, compares with the committed figures or with another build, and says what changed."""

from __future__ import annotations

import argparse
import hashlib
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from .comparison import Comparison, millions
from .counting import Count, count
from .programs import PROGRAMS, Program, RegressFailure, make_sample
from .records import Record, read, write
from .toolchain import differences, toolchain


def regress(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    try:
        with tempfile.TemporaryDirectory() as scratch:
            sample = Path(scratch)
            make_sample(sample)
            if len(arguments.build) == 2:
                before, after = arguments.build
                return _compare_builds(before, after, sample, arguments)
            return _compare_with_record(arguments.build[0], sample, arguments)
    except (RegressFailure, OSError) as failure:
        print(f"regress: {failure}", file=sys.stderr)
        return 2


def _compare_builds(before: Path, after: Path, sample: Path, arguments: argparse.Namespace) -> int:
    old, new = toolchain(before), toolchain(after)
    for difference in differences(old, new):
        print(f"note: made differently: {difference}")
    worst = 0.0
    for program in _programs(arguments.only):
        comparison = Comparison(
            program.name, count(program, before, sample), count(program, after, sample)
        )
        print(comparison.text(), flush=True)
        worst = max(worst, comparison.change)
    return int(worst > arguments.tolerance)


def _compare_with_record(build: Path, sample: Path, arguments: argparse.Namespace) -> int:
    here = {**toolchain(build), "input": _digest(sample)}
    counts: dict[str, Count] = {}
    known = None if arguments.update else read(arguments.record)
    comparisons = []
    for program in _programs(arguments.only):
        counts[program.name] = count(program, build, sample)
        if known is None or program.name not in known.counts:
            print(f"{program.name}: {millions(counts[program.name].instructions)} million "
                  "instructions", flush=True)  # fmt: skip
            continue
        comparisons.append(
            Comparison(program.name, known.counts[program.name], counts[program.name])
        )
        print(comparisons[-1].text(), flush=True)
    if arguments.json:
        write(arguments.json, Record(here, counts))
    if known is None:
        if set(counts) != {program.name for program in PROGRAMS}:
            raise RegressFailure("--update: not every program runs here; nothing was written")
        write(arguments.record, Record(here, counts))
        print(f"wrote {arguments.record}")
        return 0
    return _verdict(comparisons, differences(known.toolchain, here), arguments)


def _verdict(
    comparisons: list[Comparison], different: list[str], arguments: argparse.Namespace
) -> int:
    update = "tools/bench/regress --update, and commit the figures with the change"
    slower = [c for c in comparisons if c.change > arguments.tolerance]
    faster = [c for c in comparisons if c.change < -arguments.tolerance]
    limit = f"{100 * arguments.tolerance:g} %"
    if different:
        print("not judged, the recorded figures were made by another toolchain:")
        print("\n".join(f"    {difference}" for difference in different))
        return 0
    if slower:
        names = ", ".join(f"{c.program} by {100 * c.change:.1f} %" for c in slower)
        print(f"SLOWER than recorded by more than {limit}: {names}.\n"
              f"If the cost is wanted: {update}.")  # fmt: skip
        return 1
    if faster:
        print(f"faster by more than {limit}: {update}")
    else:
        print(f"no program is slower than recorded by more than {limit}")
    return 0


def _programs(only: list[str]) -> Iterator[Program]:
    for program in PROGRAMS:
        if only and program.name not in only:
            continue
        if program.runs_here():
            yield program
        else:
            print(f"{program.name}: left out, this processor has no {program.needs}")


def _digest(sample: Path) -> str:
    """Hashes the clouds, which another version of NumPy may make a little different."""
    clouds = b"".join((sample / f"{name}.pcd").read_bytes() for name in ("source", "target"))
    return hashlib.sha256(clouds).hexdigest()[:12]
