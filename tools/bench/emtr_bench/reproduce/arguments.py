"""The command line of the reproduction."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import natural, positive
from ..pair_arguments import WHERE, add_pair_options
from .sections import SECTIONS

EPILOG = """examples:
  reproduce                                  everything, the paper's 20 motions a pair
  reproduce --quick                          a look, in a minute
  reproduce --section evolving evaluations   two sections
  reproduce --method my_module:optimise      your own optimizer beside the others

Your function is called as optimise(problem, rng). problem.evaluate(rows, task) gives the fitness of
rows of genes in [0, 1]; task 0 is alpha on the dense clouds, 1 beta, 2 alpha on the sparse clouds.
Go on until problem.spent; the best pose that task 0 has seen is your answer.

A run that was interrupted goes on where it was when it is started again with the same options.

exit code: 0; 2 when nothing could be run; 130 when interrupted."""


def parser() -> argparse.ArgumentParser:
    listed = "\n".join(f"  {name:<12} {text}" for name, text in SECTIONS.items())
    made = argparse.ArgumentParser(
        prog="reproduce",
        description="The paper's experiments over your data: every method, table and figure, its "
        "figures beside ours, as one report (Markdown, PNG, CSV).",
        epilog=f"sections:\n{listed}\n\n{WHERE}\n\n{EPILOG}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add_pair_options(made, "paper")
    add("--section", nargs="+", metavar="SECTION", choices=list(SECTIONS),
        help="these sections only (default: all)")  # fmt: skip
    add("--method", action="append", default=[], metavar="MODULE:FUNCTION",
        help="one more evolving method, of your own; may be given again")  # fmt: skip
    add(
        "--modelnet",
        type=Path,
        metavar="DIR",
        help="folder of ModelNet40, CATEGORY/test/SHAPE.off (default: shapes that are made)",
    )
    add("--shapes", type=positive, default=1266, metavar="N",
        help="shapes of ModelNet40, or made ones (default: 1266)")  # fmt: skip
    add("--transforms", type=positive, default=20, metavar="N", help="motions a pair (default: 20)")
    add("--seed", type=natural, default=0, help="run i of a pair has seed SEED + i (default: 0)")
    add("--jobs", type=positive, default=2, help="processes side by side (default: 2)")
    add("--threads", type=positive, default=1, help="threads a process (default: 1)")
    add("--out", type=Path, metavar="DIR",
        help="where the report, its tables and figures and the log of runs go (default: "
        "build/reproduction)")  # fmt: skip
    add("--page", type=Path, metavar="FILE",
        help="write the report, without pictures of clouds, to FILE too")  # fmt: skip
    add("--report-only", action="store_true",
        help="run nothing: write the report of the runs that --out has")  # fmt: skip
    add("--quick", action="store_true", help="two small pairs, two motions: about a minute")
    add("--smoke", action="store_true",
        help="the smallest pair, one motion, few methods: some seconds")  # fmt: skip
    return made
