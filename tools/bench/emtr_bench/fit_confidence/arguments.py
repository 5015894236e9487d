"""The command line of the fit."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import natural, positive
from ..pair_arguments import WHERE, add_pair_options

EPILOG = """examples:
  accuracy --tier all --transforms 4 --unrelated 200 --json runs.json
  fit_confidence runs.json

logit = bias + weights of log(score_gap), sqrt(violation / surface_fit) and log(evidence).
It is fitted to the answers of the runs, to what would have been the answers if the right poses had
not been found, and to scans that do not belong together. Figures are of each source (the manifest's
group) by a model that has not seen it. The constants stand in libemtr/src/verdict/confidence.cpp,
where rivals and few points then lower the probability: see `calibration` for the figures of both.

exit code: 0; 1 when a run that was made crashed; 2 when there was nothing to fit."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="fit_confidence",
        description="Fits the confidence to runs with known poses, cross-validated by source.",
        epilog=f"{EPILOG}\n\n{WHERE}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("files", nargs="*", type=Path, metavar="FILE",
        help="what `accuracy --json` has written; default: such runs are made first")  # fmt: skip
    add("--leave-out", nargs="+", default=[], metavar="PAIR", help="pairs that have no right pose, "
        "or whose published pose is none")  # fmt: skip
    add("--minimum", type=float, default=0.5, metavar="P",
        help="confidence from which on a pose is called registered (default: 0.5)")  # fmt: skip
    add_pair_options(made, "all")
    add("--transforms", type=positive, default=4, metavar="N",
        help="motions a pair, when there is no file (default: 4)")  # fmt: skip
    add("--unrelated", type=natural, default=200, metavar="N", help="pairings of scans that do "
        "not belong together, when there is no file (default: 200)")  # fmt: skip
    add("--bins", type=positive, default=10, help="of the confidence (default: 10)")
    add("--json", type=Path, metavar="FILE", help="write the model and its figures to FILE")
    add("--smoke", action="store_true", help="of 2 small pairs, when there is no file")
    return made
