"""The table itself: every way to a result against the first."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from . import builds, clouds, kernels
from .builds import REPOSITORY, Build
from .fields import Fields, differing
from .runs import Run, RunFailure, by_programs, by_python, by_shell

THREADS = (1, 2, 3, 4, 8)


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/reproducibility",
        description="Builds emtr by gcc and clang at -O0, -O2 and -O3 into build/bits, registers "
        "five real pairs and a generated one by the class, C, the shell and Python with 1 to 8 "
        "threads and each instruction set, and once as on a machine whose mathematics library does "
        "without FMA, and compares everything that the results say, to the last bit. Each "
        "instruction set meets each number of threads on the generated pair; on real pairs each "
        "meets the first number of threads, and the last each number. What is built at -O0 is ten "
        "times slower: it does the latter on the generated pair, and real pairs once. Status 1 "
        "when anything differs. At most as many runs at a time as there are cores.",
    )
    parser.add_argument("--compilers", nargs="+", choices=list(builds.COMPILERS))
    parser.add_argument("--levels", nargs="+", choices=[level[1:] for level in builds.LEVELS])
    parser.add_argument("--threads", nargs="+", type=int, default=list(THREADS))
    parser.add_argument("--kernels", nargs="+", choices=list(kernels.NEEDED))
    parser.add_argument("--presets", nargs="+", default=["default", "paper"])
    parser.add_argument("--pairs", nargs="+", default=[clouds.GENERATED, *clouds.REAL])
    parser.add_argument("--every", action="store_true", help="leave nothing out, which takes hours")
    parser.add_argument(
        "--smoke", action="store_true", help="the build of tools/check alone, one pair, 2 threads"
    )
    arguments = parser.parse_args()
    if arguments.smoke:
        arguments.threads, arguments.pairs = [2], [clouds.GENERATED]
        arguments.presets = ["default"]
    return arguments


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
    """Instruction set, threads, and whether the mathematics library is that of an old machine."""
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


def table(arguments: argparse.Namespace) -> int:
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
    return 1 if wrong or not compared else 0


def main() -> int:
    arguments = parse()
    try:
        return table(arguments)
    except (builds.BuildFailure, RunFailure, OSError) as failure:
        print(f"bits: {failure}", file=sys.stderr)
        return 2
