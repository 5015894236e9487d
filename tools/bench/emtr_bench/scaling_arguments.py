"""The command line of the scaling benchmark."""

from __future__ import annotations

import argparse
from pathlib import Path

from .arguments import natural, positive

SIZES = (1000, 3000, 10000, 30000, 100000, 300000, 1000000, 3000000, 10000000)

EPILOG = """examples:
  scaling                                  every size, the quickest of 3 runs each
  scaling --sizes 1000000 --repeat 10      one size
  scaling --require --plot scaling.png     with a picture; exit 1 when a target is missed

exit code: 0; 1 when a run failed or, with --require, a target was missed; 2 for a bad argument."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="scaling",
        description="Time by stage and peak memory of a registration, from a thousand to ten "
        "million points a cloud: two partial scans of a bumpy ball, made on the spot, each size "
        "in a process of its own.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("--sizes", type=positive, nargs="+", metavar="N", default=SIZES,
        help="points of each cloud (default: 1e3 to 1e7, two a decade)")  # fmt: skip
    add("--repeat", type=positive, default=3, metavar="N", help="runs a size (default: 3)")
    add("--threads", type=natural, default=0, help="threads (default: 0, all)")
    add("--seed", type=natural, default=2, help="of surface, noise and search (default: 2)")
    add("--json", type=Path, metavar="FILE", help="write all figures to FILE")
    add("--plot", type=Path, metavar="FILE", help="draw them into a PNG (needs matplotlib)")
    add("--require", action="store_true", help="exit 1 when a target is missed")
    add("--smoke", action="store_true", help="three small sizes, once each")
    return made
