"""The command line of the ablation."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import natural, positive
from ..pair_arguments import WHERE, add_pair_options
from .variants import VARIANTS

EPILOG = """Joint success (E_R < 5 degrees and E_t < 0.06) by tier, with each part off in turn: of
the whole method, and of the method without seeds and without the second search, where the swarms
carry the search. Every row has the same pairs, motions and seeds, so a row's lost and won runs
against the first of its block tell more than its percentage. One motion of all pairs is 1452
runs, some ten minutes on two idle cores.

exit code: 0; 1 when a run crashed; 2 when nothing could be run."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="ablation",
        description="Success on pairs with known poses with each part of the method off in turn.",
        epilog=f"{WHERE}\n\n{EPILOG}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("--preset", default="default", help="of the library (default: default)")
    add_pair_options(made, "all")
    add("--part", nargs="+", metavar="PART", choices=sorted({v.part for v in VARIANTS}),
        help="these parts only, beside nothing")  # fmt: skip
    add("--transforms", type=positive, default=1, metavar="N", help="motions a pair (default: 1)")
    add("--seed", type=natural, default=0, help="run i of a pair has seed SEED + i (default: 0)")
    add("--jobs", type=positive, default=1, help="processes side by side (default: 1)")
    add("--threads", type=natural, default=0, help="threads a process (default: 0, all)")
    add("--json", type=Path, metavar="FILE", help="write the figures to FILE")
    add("--smoke", action="store_true", help="the smallest pair once")
    return made
