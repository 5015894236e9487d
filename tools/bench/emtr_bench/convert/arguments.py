"""The command line of the converter."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import positive

SETS = ("stanford", "fgr", "uwa", "resso", "modelnet", "threedmatch")

EPILOG = """It downloads nothing. Each set has terms of its own, and most are for research alone:
docs/BENCHMARKING.md says where the archives are. FROM may have archives (zip, tar, tar.gz, tgz,
tar.bz2) and unpacked folders of several sets; what belongs to none is left alone.

examples:
  convert ~/Downloads my_data                    whatever sets are there
  convert ~/Downloads my_data --set stanford     these alone
  accuracy --data my_data --tier all             a benchmark on them

exit code: 0; 2 when nothing was found or a file was not what was expected."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="convert",
        description="Converts downloaded archives of public sets into pairs for the benchmarks: "
        + ", ".join(SETS)
        + ".",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("source", type=Path, metavar="FROM", help="folder with the archives")
    add("target", type=Path, metavar="TO", help="folder of pairs, made or added to")
    add("--set", nargs="+", choices=SETS, metavar="SET", help="of " + ", ".join(SETS))
    add("--least-overlap", type=share, default=0.1, metavar="SHARE",
        help="of scans that the set does not pair itself, those pairs of which both clouds share "
        "this much (default: 0.1)")  # fmt: skip
    add("--per-category", type=positive, default=1, metavar="N",
        help="shapes of each category of modelnet (default: 1)")  # fmt: skip
    return made


def share(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0.0 <= value <= 1.0:
        raise argparse.ArgumentTypeError(f"expected a share from 0 to 1, got {text!r}")
    return value
