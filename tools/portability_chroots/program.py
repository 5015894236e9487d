"""Runs the steps in each chroot, or the check of the syntax, and says what failed."""

from __future__ import annotations

import argparse
import signal
import sys
import time
from collections.abc import Sequence

from . import syntax
from .arguments import parse
from .chroot import Chroot, ChrootFailure
from .steps import steps

TAIL = 40  # lines of a log


def try_compiler(chroot: Chroot, compiler: str, arguments: argparse.Namespace) -> str:
    """Runs the steps up to the first that fails; returns the verdict in one line."""
    log = chroot.folder / f"{chroot.suite}-{compiler}.log"
    with log.open("w") as out:
        for name, script in steps(compiler, arguments):
            began = time.monotonic()
            print(f"{chroot.suite} {compiler}: {name} ... ", end="", flush=True)
            out.write(f"== {name}\n")
            out.flush()
            status = chroot.run(script, out)
            print(f"{'done' if status == 0 else 'FAILED'}, {time.monotonic() - began:.0f} s")
            if status != 0:
                print("\n".join(log.read_text(errors="replace").splitlines()[-TAIL:]))
                return f"FAILED: {name}, see {log}"
    warnings = log.read_text(errors="replace").count(" warning: ")
    return f"passed, {warnings} warnings of the compiler"


def in_chroots(arguments: argparse.Namespace) -> int:
    verdicts = {}
    for suite in arguments.suites:
        chroot = Chroot(arguments.folder, suite)
        print(f"{suite}: the chroot in {chroot.root} ... ", end="", flush=True)
        chroot.make(arguments.mirror, arguments.reuse)
        print("done")
        for compiler in arguments.compilers:
            verdicts[suite, compiler] = try_compiler(chroot, compiler, arguments)
    print()
    for (suite, compiler), verdict in verdicts.items():
        print(f"{suite:10} {compiler:6} {verdict}")
    return int(any(verdict.startswith("FAILED") for verdict in verdicts.values()))


def by_syntax(arguments: argparse.Namespace) -> int:
    checked, refused = 0, []
    for compiler in arguments.compilers:
        found = syntax.check(compiler, arguments.folder, arguments.jobs)
        if found is None:
            print(f"skipped: {compiler} is not installed")
            continue
        checked += 1
        refused += found
    print("\n".join(refused))
    return 1 if refused or not checked else 0


def main(words: Sequence[str] | None = None) -> int:
    arguments = parse(words)
    # An exception ends what runs in the chroot; the signal by itself would leave it running.
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(128 + number))
    try:
        return by_syntax(arguments) if arguments.smoke else in_chroots(arguments)
    except (ChrootFailure, OSError) as failure:
        print(f"\nportability: {failure}", file=sys.stderr)
        return 2
