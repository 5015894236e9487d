"""The command line of the benchmark of given matches."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import positive
from ..pair_arguments import WHERE_ELSE, add_pair_options

EPILOG = """Each case is made anew, by the protocol of TEASER++: points in a cube of side 1 (or of
--cloud FILE or of pairs, scaled to it), rotated at random and moved by up to 1, noise of 0.01 in
each coordinate; the targets of wrong matches are uniform in a ball of diameter sqrt(3). A case
is right within 10 degrees and 0.1. registered counts the cases that were, wrong those that were
registered and are not right.

When the module teaserpp_python is installed, TEASER++ runs on the same cases, with the noise bound
of 5.54 standard deviations that it must be told.

exit code: 0; 1 when a wrong pose was registered; 2 when nothing could be run."""


def share(text: str) -> float:
    """Reads a percentage."""
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0 <= value <= 100:
        raise argparse.ArgumentTypeError(f"expected a number from 0 to 100, got {text!r}")
    return value / 100


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="matches",
        description="Registers by given matches, most of them wrong.",
        epilog=f"{EPILOG}\n\n{WHERE_ELSE} Each pair's target gives the points then.",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("--counts", nargs="+", type=positive, default=[100, 1000, 5000, 10000], metavar="N",
        help="how many matches (default: 100 1000 5000 10000)")  # fmt: skip
    add("--outliers", nargs="+", type=share, metavar="PERCENT",
        default=[0.0, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99, 1.0],
        help="how many of them are wrong (default: 0 50 80 90 95 98 99 100)")  # fmt: skip
    add("--noise", type=float, default=0.01, help="of a coordinate of the target (default: 0.01)")
    add(
        "--unknown-scale",
        action="store_true",
        help="targets 1 to 5 times as large, which nobody is told; right within 10 percent too",
    )
    add("--cases", type=positive, default=20, metavar="N", help="of each kind (default: 20)")
    add("--threads", type=positive, default=1, metavar="N", help="(default: 1)")
    add_pair_options(made, "all")
    add("--cloud", type=Path, metavar="FILE", help="PLY file to take the points from")
    add("--json", type=Path, metavar="FILE", help="write the figures to FILE")
    add("--smoke", action="store_true", help="a few small cases")
    return made
