"""The command line of the page's maker."""

from __future__ import annotations

import argparse
from pathlib import Path

from .parts import NAMES

EPILOG = """examples:
  report                  every benchmark, then the page; takes long
  report --only peers     that part again; the others from their JSON
  report --only           the page alone, from the JSON that is there

exit code: 0; 1 when a part could not be run (the page then says "not measured") or ended with a
failure of its own (the page says so too); 2 for a bad argument."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="report",
        description="Runs the benchmarks one after the other and writes BENCHMARK.md. Leave the "
        "machine alone meanwhile.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("--only", nargs="*", choices=NAMES, metavar="PART", help="run these: " + ", ".join(NAMES))
    add("--presets", nargs="+", metavar="NAME",
        help="of emtr, for the accuracy (default: all that there are)")  # fmt: skip
    add("--sweep", action="store_true",
        help="compare with other libraries at their fastest settings too; takes hours")  # fmt: skip
    add("--out", type=Path, metavar="FILE", help="the page (default: BENCHMARK.md)")
    add("--smoke", action="store_true",
        help="tiny counts, into a temporary folder that is removed; --out keeps "
        "the page")  # fmt: skip
    return made
