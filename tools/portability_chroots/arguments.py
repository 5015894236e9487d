"""The command line of tools/portability."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
SUITES = ("bookworm", "trixie", "testing")
COMPILERS = {"gcc": ("gcc", "g++"), "clang": ("clang", "clang++")}
# Run on this machine, make programs for another processor.
CROSS_COMPILERS = {"arm64": ("aarch64-linux-gnu-gcc", "aarch64-linux-gnu-g++")}

DESCRIPTION = """\
Makes a chroot of each suite of Debian by debootstrap, installs there what the pages say that a
build needs, and for each compiler: builds the libraries, the command and the tests, compiles each
header alone, runs ctest, installs, builds and runs the programs of the pages and of tests/consumers
against what is installed, and registers a generated pair. The poses of all must have the same bits.
The checkout is mounted read-only. It needs root, and 3 GB a suite."""

EPILOG = """\
With --smoke there is no chroot: each header alone and each source of the libraries and the command
goes through the compilers of this machine, which check it and write nothing.

With --architecture arm64 the chroot is of another processor. mmdebstrap extracts its packages. This
machine's compiler makes its programs, the Python extension too, and qemu-user runs them; Debian's
qemu-user-static and binfmt-support let it. Debian packages are not made there.

With --readme the chroot has git and no more, and the README's two commands, tools/quickstart and
tools/check, run in a clone of what is committed; their compiler is the system's. pip there takes
the certificates that the variable PIP_CERT names.

The variable EMTR_PORTABILITY_CCACHE names a folder for ccache that is mounted into the chroots;
without it nothing is cached. The log of a build is beside its chroot, in SUITE-COMPILER.log, or in
SUITE-arm64-gcc.log.

examples:
  tools/portability                                  all of them
  tools/portability --suites trixie --compilers gcc  one of them
  tools/portability --reuse --tests '^c_api'         the chroots as they are, some of the tests
  tools/portability --suites trixie --architecture arm64
  tools/portability --suites bookworm trixie --readme

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
    add("--architecture", choices=list(CROSS_COMPILERS), metavar="NAME",
        help="another processor: arm64, with gcc alone [this machine's]")  # fmt: skip
    add("--folder", type=Path, default=REPOSITORY / "build" / "portability",
        help="where the chroots are [build/portability]")  # fmt: skip
    add("--mirror", default="http://deb.debian.org/debian", help="[%(default)s]")
    add("--tests", default="", metavar="REGEX", help="only these of ctest's tests [all]")
    add("--jobs", type=_jobs, default=2, metavar="N", help="[%(default)s]")
    add("--reuse", action="store_true",
        help="keep chroots and builds that are there, instead of making them anew")  # fmt: skip
    add("--readme", action="store_true", help="the README's two commands in fresh chroots")
    add("--smoke", action="store_true", help="a check of the syntax that needs no chroot")
    arguments = parser.parse_args(words)
    if arguments.architecture:
        arguments.compilers = ["gcc"]
    if arguments.readme:
        if arguments.architecture:
            parser.error("--readme: expected no --architecture")
        arguments.compilers = ["cc"]  # the system's
    return arguments


def _jobs(text: str) -> int:
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"expected a number of jobs above 0, got {text!r}")
    return int(text)
