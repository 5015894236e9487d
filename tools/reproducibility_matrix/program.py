"""Compares every result of a pair and preset with the first, and with a record."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from . import builds, clouds, kernels, record
from .arguments import parse
from .builds import REPOSITORY, Build
from .fields import Fields, differing
from .runs import Run, RunFailure, by_programs, by_python, by_shell


def all_builds(arguments: argparse.Namespace) -> Iterator[Build]:
    if arguments.smoke:
        folder = Path(os.environ.get("EMTR_BUILD_DIR", REPOSITORY / "build"))
        yield Build("tools/check", folder)
        return
    for compiler in arguments.compilers or builds.COMPILERS:
        if not builds.available(compiler):
            print(f"skipped: {compiler} is not installed", flush=True)
            continue
        for level in builds.LEVELS:
            if arguments.levels is None or level[1:] in arguments.levels:
                yield builds.make(compiler, level)


def variants(
    build: Build, pair: str, names: list[str], arguments: argparse.Namespace
) -> Iterator[tuple[str, int, bool]]:
    """Yields instruction set, threads, and whether to use the mathematics of an old machine."""
    every = arguments.every or (pair == clouds.GENERATED and not build.slow)
    threads = arguments.threads
    if build.slow and pair != clouds.GENERATED and not arguments.every:
        yield names[-1], threads[-1], False
        return
    for name in names:
        for count in threads:
            if every or count == threads[0] or name == names[-1]:
                yield name, count, False
    yield names[0], threads[0], True


def results(build: Build, run: Run) -> dict[str, Fields]:
    out = by_programs(build.program, run)
    out["shell"] = by_shell(build.command, run)
    out["Python"] = by_python(run, build.package)
    return out


def table(arguments: argparse.Namespace) -> tuple[int, record.Results]:
    """Prints the table; returns how many results differ, and the first of each pair and preset.

    Raises BuildFailure, RunFailure or OSError.
    """
    runnable, not_here = kernels.split()
    for name in not_here:
        print(f"skipped: this machine cannot run the instruction set {name}")
    names = [name for name in runnable if name in (arguments.kernels or runnable)]
    data = Path(os.environ.get("EMTR_DATA", REPOSITORY.parent / "shared" / "data"))
    first: dict[tuple[str, str], tuple[str, Fields]] = {}
    compared = wrong = 0
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        pairs = {}
        for pair in arguments.pairs:
            try:
                both = clouds.load(pair, data)
            except FileNotFoundError as failure:
                print(f"skipped: {pair}: no {failure.filename} (set EMTR_DATA)")
                continue
            ends = [Path(folder, f"{pair.replace('/', '_')}_{end}.pcd") for end in "st"]
            pairs[pair] = [clouds.write_pcd(path, cloud) for path, cloud in zip(ends, both)]
        for build in all_builds(arguments):
            for pair, (source, target) in pairs.items():
                for preset in arguments.presets:
                    differ, count = [], 0
                    runs = [
                        Run(source, target, preset, 5, threads, kernel, old_libm)
                        for kernel, threads, old_libm in variants(build, pair, names, arguments)
                    ]
                    for run, found in zip(runs, pool.map(partial(results, build), runs)):
                        libm = ", old libm" if run.old_libm else ""
                        for way, fields in found.items():
                            here = f"{build.name}, {run.kernel}, {run.threads} threads{libm}, {way}"
                            there, wanted = first.setdefault((pair, preset), (here, fields))
                            count += 1
                            if off := differing(wanted, fields):
                                differ.append(f"  {here} against {there}: {', '.join(off)}")
                    compared, wrong = compared + count, wrong + len(differ)
                    verdict = f"{len(differ)} DIFFER" if differ else "same bits"
                    print(f"{build.name:12} {pair:26} {preset:8} {count:4} {verdict}", flush=True)
                    for line in differ[:20]:
                        print(line, flush=True)
    print(f"{compared} results, {wrong} of them different")
    firsts: record.Results = {}
    for (pair, preset), (_, fields) in first.items():
        firsts.setdefault(pair, {})[preset] = fields
    return wrong, firsts


def main() -> int:
    arguments = parse()
    try:
        before = arguments.against and record.read(arguments.against, dict(arguments.renamed))
        wrong, found = table(arguments)
        if arguments.record and found:
            record.write(arguments.record, found)
            print(f"wrote {arguments.record}")
    except (builds.BuildFailure, RunFailure, OSError, ValueError) as failure:
        print(f"reproducibility: {failure}", file=sys.stderr)
        return 2
    if before is not None:
        changed = record.differences(before, found)
        print("\n".join(changed or [f"same bits as in {arguments.against}"]))
        wrong += len(changed)
    return 1 if wrong or not found else 0
