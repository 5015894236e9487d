"""The command line of the comparison."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import natural, positive
from ..pair_arguments import WHERE, add_pair_options

# Too coarse a voxel costs the other libraries successes, too fine a one time. With this many
# points they have the most successes on the paper's pairs for the least time.
VOXEL_POINTS = 6000

EPILOG = """The other libraries are installed from PyPI, in the versions of
tools/bench/peers-requirements.txt, into a virtual environment of their own.

examples:
  peers --tier paper --transforms 4                  everything on the paper's pairs
  peers --only emtr kiss-matcher --pair trex_03_01   one pair, all presets and two rows
  peers --tier all --sweep --plot sweep.png          the others at their best, too; takes long

exit code: 0; 1 when a preset of emtr crashed; 2 when nothing could be run."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="peers",
        description="emtr against Open3D (RANSAC, FGR) and KISS-Matcher, each finished by "
        "point-to-plane ICP (Open3D) or by GICP (small_gicp): success, errors and wall time on "
        "the same pairs, motions and number of threads, in turns.",
        epilog=f"{WHERE}\n\n{EPILOG}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add_pair_options(made, "paper")
    add("--transforms", type=positive, default=4, metavar="N", help="motions a pair (default: 4)")
    add("--presets", nargs="+", metavar="NAME", help="of emtr (default: all that there are)")
    add("--only", nargs="+", default=[], metavar="METHOD",
        help="these methods: a row's name, or emtr, open3d-ransac, open3d-fgr, "
        "kiss-matcher")  # fmt: skip
    add("--threads", type=positive, default=2, help="of every method (default: 2)")
    add("--limit", type=positive, default=60, metavar="SECONDS", help="a run (default: 60)")
    add("--seed", type=natural, default=0, help="run i of a pair has seed SEED + i (default: 0)")
    add("--voxel-points", type=positive, default=VOXEL_POINTS, metavar="N",
        help="the voxel given to the other libraries leaves N points in both clouds together "
        f"(default: {VOXEL_POINTS})")  # fmt: skip
    add("--sweep", action="store_true",
        help="each other method at each setting of the next two options too: its fastest setting "
        "that loses no success beside the recommended one, and the frontier")  # fmt: skip
    add("--sweep-points", nargs="+", type=positive, default=[1500, 3000, 6000, 12000], metavar="N",
        help="as --voxel-points, for the search (default: 1500 3000 6000 12000)")  # fmt: skip
    add("--refine-points", nargs="+", type=natural, default=[0, 3000, 12000], metavar="N",
        help="the same for the refinement; 0: what its library does by itself "
        "(default: 0 3000 12000)")  # fmt: skip
    add("--plot", type=Path, metavar="FILE", help="with --sweep, draw success against time into a "
        "PNG")  # fmt: skip
    add("--json", type=Path, metavar="FILE", help="write every run to FILE")
    add("--venv", type=Path, metavar="DIR", help="where the other libraries are installed "
        "(default: build/venv-peers)")  # fmt: skip
    add("--smoke", action="store_true",
        help="one motion of the smallest pair; installs nothing, and leaves out what is "
        "missing")  # fmt: skip
    return made
