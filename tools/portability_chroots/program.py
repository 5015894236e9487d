"""Runs the steps in each chroot, or the check of the syntax, and says what failed."""

from __future__ import annotations

import argparse
import hashlib
import signal
import sys
import time
from collections.abc import Sequence

from . import pair, syntax
from .arguments import parse
from .chroot import Chroot, ChrootFailure
from .steps import PAIR_FOLDER, bits_path, steps

TAIL = 40  # lines of a log


def try_compiler(chroot: Chroot, compiler: str, arguments: argparse.Namespace) -> str:
    """Runs the steps up to the first that fails; returns the verdict in one line."""
    log = chroot.folder / f"{chroot.name}-{compiler}.log"
    with log.open("w") as out:
        for name, script in steps(compiler, arguments):
            began = time.monotonic()
            print(f"{chroot.name} {compiler}: {name} ... ", end="", flush=True)
            out.write(f"== {name}\n")
            out.flush()
            status = chroot.run(script, out)
            print(f"{'done' if status == 0 else 'FAILED'}, {time.monotonic() - began:.0f} s")
            if status != 0:
                print("\n".join(log.read_text(errors="replace").splitlines()[-TAIL:]))
                return f"FAILED: {name}, see {log}"
    warnings = log.read_text(errors="replace").count(" warning: ")
    return f"passed, {warnings} warnings of the compiler"


def compare_bits(found: dict[str, str]) -> str:
    """Returns a line about the poses of the generated pair, by chroot and compiler."""
    if not found:
        return "generated pair: registered nowhere"
    first, bits = next(iter(found.items()))
    others = [name for name, text in found.items() if text != bits]
    if others:
        return f"FAILED: the generated pair has other bits by {', '.join(others)} than by {first}"
    digest = hashlib.sha256(bits.encode()).hexdigest()[:16]
    return f"generated pair: the same bits in all {len(found)}, {digest}"


def in_chroots(arguments: argparse.Namespace) -> int:
    verdicts, bits = {}, {}
    for suite in arguments.suites:
        chroot = Chroot(arguments.folder, suite, arguments.architecture, arguments.readme)
        print(f"{chroot.name}: the chroot in {chroot.root} ... ", end="", flush=True)
        chroot.make(arguments.mirror, arguments.reuse)
        print("done")
        pair.write(chroot.root / PAIR_FOLDER.lstrip("/"))
        for compiler in arguments.compilers:
            poses = chroot.root / bits_path(compiler).lstrip("/")
            poses.unlink(missing_ok=True)
            verdicts[chroot.name, compiler] = try_compiler(chroot, compiler, arguments)
            if poses.is_file():
                bits[f"{chroot.name} {compiler}"] = poses.read_text()
    said = [f"{name:15} {compiler:6} {text}" for (name, compiler), text in verdicts.items()]
    if not arguments.readme:
        said.append(compare_bits(bits))
    print("\n" + "\n".join(said))
    return int(any("FAILED: " in line for line in said))


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
