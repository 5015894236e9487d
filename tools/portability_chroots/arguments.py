"""The command line of tools/portability."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
SUITES = ("bookworm", "trixie", "testing")
COMPILERS = {"gcc": ("gcc", "g++"), "clang": ("clang", "clang++")}

DESCRIPTION = """\
Makes a chroot of each suite of Debian by debootstrap, installs there what the pages say that a
build needs, and for each compiler: builds the libraries, the command and the tests, compiles each
header alone, runs ctest, installs, and builds and runs the programs of the pages and of
tests/consumers against what is installed. The checkout is mounted read-only. It needs root, and
3 GB a suite."""

EPILOG = """\
With --smoke there is no chroot: each header alone and each source of the libraries and the command
goes through the compilers of this machine, which check it and write nothing.

The variable EMTR_PORTABILITY_CCACHE names a folder for ccache that is mounted into the chroots;
without it nothing is cached. The log of a build is beside its chroot, in SUITE-COMPILER.log.

examples:
  tools/portability                                  all of them
  tools/portability --suites trixie --compilers gcc  one of them
  tools/portability --reuse --tests '^c_api'         the chroots as they are, some of the tests

exit code: 0; 1 when something fails to build or to pass; 2 when there could be no chroot."""


def parse(words: Sequence[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/portability",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("--suites", nargs="+", default=list(SUITES), metavar="SUITE",
        help=f"releases of Debian [{' '.join(SUITES)}]")  # fmt: skip
    add("--compilers", nargs="+", choices=list(COMPILERS), default=list(COMPILERS))
    add("--folder", type=Path, default=REPOSITORY / "build" / "portability",
        help="where the chroots are [build/portability]")  # fmt: skip
    add("--mirror", default="http://deb.debian.org/debian", help="[%(default)s]")
    add("--tests", default="", metavar="REGEX", help="only these of ctest's tests [all]")
    add("--jobs", type=_jobs, default=2, metavar="N", help="[%(default)s]")
    add("--reuse", action="store_true",
        help="keep chroots and builds that are there, instead of making them anew")  # fmt: skip
    add("--smoke", action="store_true", help="a check of the syntax that needs no chroot")
    return parser.parse_args(words)


def _jobs(text: str) -> int:
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"expected a number of jobs above 0, got {text!r}")
    return int(text)
