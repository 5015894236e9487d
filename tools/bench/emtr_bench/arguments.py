"""The command line of the accuracy benchmark."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from .pair_arguments import WHERE, add_pair_options
from .searched_scales import SEARCHED

if TYPE_CHECKING:  # the command line is read before it is known that numpy is there
    from .runner import Setting

EPILOG = """examples:
  accuracy --preset paper --tier paper            the paper's rows, 20 transforms each
  accuracy --tier all --transforms 4 --jobs 2     every pair, quicker
  accuracy --tier all --unrelated 200             and scans that do not belong together
  accuracy --pair trex_03_01 --failures           one pair, and why runs failed
  accuracy --tier extreme --prior guess           with a guess nearby, or --prior axis
  accuracy --tier paper --queries                 the cost against the paper's formula

exit code: 0; 1 when a run crashed or, with --require, a mark was missed; 2 when nothing
could be run (a bad pair, no pyemtr, a bad argument)."""


def parser(program: str = "accuracy") -> argparse.ArgumentParser:
    """`program` is the one that the user has called."""
    made = argparse.ArgumentParser(
        prog=program,
        description="Success, errors, cost and time of emtr on pairs with ground truth, by the "
        "paper's protocol, beside the paper's figures.",
        epilog=f"{WHERE}\n\n{EPILOG}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("--preset", help="preset of the library (default: default; paper with --queries)")
    add_pair_options(made, "paper")
    add("--transforms", type=positive, default=20, metavar="N", help="motions a pair (default: 20)")
    add("--seed", type=natural, default=0, help="run i of a pair has seed SEED + i (default: 0)")
    add("--set", action="append", type=setting, default=[], metavar="NAME=VALUE",
        help="change a setting of the preset")  # fmt: skip
    add("--jobs", type=positive, default=1, help="processes side by side (default: 1)")
    add("--threads", type=natural, default=0, help="threads a process (default: 0, all)")
    add("--viewpoints", action="store_true",
        help="tell the library where the sensors stood, where it is known")  # fmt: skip
    add(
        "--prior",
        choices=("guess", "axis"),
        default="",
        help="tell something true of each pose: a guess within 20 degrees and 0.3 radii, or the "
        "axis of its rotation",
    )
    add(
        "--scale",
        choices=SEARCHED,
        default="",
        help="give each source another scale, and have it searched: free: 0.02 to 50 and 1000; "
        "bounded: 0.8 to 1.25; units: a factor between units. Right then means within 3 percent "
        "of the scale too",
    )
    add("--unrelated", type=natural, default=0, metavar="N",
        help="then N pairings of scans that do not belong together")  # fmt: skip
    add("--json", type=Path, metavar="FILE", help="write every run to FILE")
    add("--failures", action="store_true",
        help="list the runs that failed, and whether the search or the objective did")  # fmt: skip
    add(
        "--queries",
        action="store_true",
        help="check the nearest-neighbor queries instead of the accuracy",
    )
    add("--require", action="store_true", help="exit 1 when the pairs miss the paper's marks, or "
        "unrelated scans are called registered")  # fmt: skip
    add("--smoke", action="store_true",
        help="2 small pairs x 2 transforms")  # fmt: skip
    return made


def positive(text: str) -> int:
    value = natural(text)
    if value == 0:
        raise argparse.ArgumentTypeError("expected a whole number above 0, got 0")
    return value


def natural(text: str) -> int:
    if not text.isascii() or not text.isdigit():
        raise argparse.ArgumentTypeError(f"expected a whole number, not negative, got {text!r}")
    return int(text)


def setting(text: str) -> tuple[str, Setting]:
    name, equals, value = text.partition("=")
    if not name or not equals or not value:
        raise argparse.ArgumentTypeError(f"expected NAME=VALUE, got {text!r}")
    for kind in (int, float):
        try:
            return name, kind(value)
        except ValueError:
            continue
    return name, value  # the name of a choice; the library knows which there are
