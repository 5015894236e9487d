"""The command line of the instruction counts."""

from __future__ import annotations

import argparse
import os
from pathlib import Path

from ..locations import REPOSITORY
from .programs import PROGRAMS
from .records import FILE

EPILOG = """examples:
  regress                      the build in build/, against tools/bench/regress.json
  regress --update             records its counts there
  regress build-before build   two builds

The counts depend on the compiler and the libraries, whose versions are recorded with them: where
these differ, the changes are printed and not judged.

exit code: 0; 1 when a program is slower by more than the tolerance; 2 when nothing could be
counted."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="regress",
        description="Counts the instructions of small registrations under valgrind, on one "
        "thread, and compares them with recorded counts or with another build's.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("build", nargs="*", type=Path, metavar="BUILD",
        help="build folder (default: EMTR_BUILD_DIR, else build); two to compare them")  # fmt: skip
    add("--update", action="store_true", help="record the counts instead of comparing them")
    add("--tolerance", type=_share, default=0.03, metavar="SHARE",
        help="how much slower is still well (default: 0.03)")  # fmt: skip
    add("--only", nargs="+", default=[], choices=[program.name for program in PROGRAMS],
        metavar="PROGRAM",
        help="of " + ", ".join(program.name for program in PROGRAMS))  # fmt: skip
    add("--record", type=Path, default=FILE, metavar="FILE", help="the recorded counts "
        "(default: tools/bench/regress.json)")  # fmt: skip
    add("--json", type=Path, metavar="FILE", help="write the counts of this run to FILE")
    add("--smoke", action="store_true", help="nothing else: it is short as it is")
    return made


def parse() -> argparse.Namespace:
    made = parser()
    arguments = made.parse_args()
    default = Path(os.environ.get("EMTR_BUILD_DIR") or REPOSITORY / "build")
    arguments.build = arguments.build or [default]
    if len(arguments.build) > 2:
        made.error("expected one build folder or two")
    if len(arguments.build) == 2 and (arguments.update or arguments.json):
        made.error("two builds are compared with each other: neither --update nor --json")
    if arguments.update and arguments.only:
        made.error("--update records every program: no --only")
    return arguments


def _share(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0.0 <= value < 10.0:
        raise argparse.ArgumentTypeError(f"expected a share from 0 to 10, got {text!r}")
    return value
