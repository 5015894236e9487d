"""The command line of tools/reproducibility."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from . import builds, clouds, kernels

THREADS = (1, 2, 3, 4, 8)

DESCRIPTION = """\
Builds emtr with gcc and clang at -O0, -O2 and -O3 into build/reproducibility, registers five real
pairs and a generated one by the class, C, the shell and Python with 1 to 8 threads and each
instruction set, and once as on a machine whose mathematics library does without FMA, and compares
all results to the last bit.

Each instruction set meets each number of threads on the generated pair; on real pairs each meets
the first number of threads, and the last each number. A build at -O0 is ten times slower: it does
the latter on the generated pair, and real pairs once. At most as many runs at a time as there are
cores."""

EPILOG = """\
examples:
  tools/reproducibility --record before.json    before a change of the code
  tools/reproducibility --against before.json   after it
  tools/reproducibility --against before.json --renamed old_name=new_name

exit code: 0; 1 when anything differs; 2 when something could not be built, run or read."""


def parse(words: Sequence[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/reproducibility",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("--compilers", nargs="+", choices=list(builds.COMPILERS))
    add("--levels", nargs="+", choices=[level[1:] for level in builds.LEVELS])
    add("--threads", nargs="+", type=int, default=list(THREADS))
    add("--kernels", nargs="+", choices=list(kernels.NEEDED))
    add("--presets", nargs="+", default=["default", "paper"])
    add("--pairs", nargs="+", default=[clouds.GENERATED, *clouds.REAL])
    add("--every", action="store_true", help="leave nothing out, which takes hours")
    add("--smoke", action="store_true", help="only the build of tools/check, one pair, 2 threads")
    add("--record", type=Path, metavar="FILE", help="write the result of each pair and preset")
    add("--against", type=Path, metavar="FILE", help="compare with a record, field by field")
    add("--renamed", nargs="+", type=_pair, default=[], metavar="OLD=NEW",
        help="fields of --against that have a new name; any other that one side lacks counts "
        "as different")  # fmt: skip
    arguments = parser.parse_args(words)
    if arguments.renamed and not arguments.against:
        parser.error("--renamed: expected --against FILE too")
    if arguments.record and not arguments.record.absolute().parent.is_dir():
        parser.error(f"--record: no folder {arguments.record.parent}")
    if arguments.smoke:
        arguments.threads, arguments.pairs = [2], [clouds.GENERATED]
        arguments.presets = ["default"]
    return arguments


def _pair(text: str) -> tuple[str, str]:
    old, equals, new = text.partition("=")
    if not (old and equals and new):
        raise argparse.ArgumentTypeError(f"expected OLD=NEW, got {text!r}")
    return old, new
