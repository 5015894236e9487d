"""The command line of the calibration."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import natural, positive
from ..pair_arguments import WHERE, add_pair_options

EPILOG = """examples:
  accuracy --tier all --transforms 4 --unrelated 200 --json runs.json
  calibration runs.json --plot calibration.png
  calibration                       makes such runs first, of preset default

A run is right when it is a joint success (E_R < 5 degrees, E_t < 0.06); scans that do not belong
together have no right pose. Several files of one preset are taken together. The intervals count
each run as one: those of one pair have more in common than they know of.

exit code: 0; 1 when a run that was made crashed; 2 when there was nothing to judge."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="calibration",
        description="Says whether the confidence is a probability: by bins, against the share of "
        "runs that were right, and how well it and `registered` tell right from wrong.",
        epilog=f"{EPILOG}\n\n{WHERE}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("files", nargs="*", type=Path, metavar="FILE", help="what `accuracy --json` has written")
    add("--presets", nargs="+", default=["default"], metavar="NAME",
        help="of emtr, when there is no file (default: default)")  # fmt: skip
    add_pair_options(made, "all")
    add("--transforms", type=positive, default=4, metavar="N",
        help="motions a pair, when there is no file (default: 4)")  # fmt: skip
    add("--unrelated", type=natural, default=200, metavar="N", help="pairings of scans that do "
        "not belong together, when there is no file (default: 200)")  # fmt: skip
    add("--bins", type=positive, default=10, help="of the confidence (default: 10)")
    add("--json", type=Path, metavar="FILE", help="write the figures to FILE")
    add("--plot", type=Path, metavar="FILE", help="draw them into a PNG (needs matplotlib)")
    add("--smoke", action="store_true", help="of 2 small pairs, when there is no file")
    return made
