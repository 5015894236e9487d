"""The command line of the benchmark of colors."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import positive

SCENES = ("wall", "floor", "box", "column", "corridor", "intensity", "unrelated", "unmarked")

EPILOG = """Each case is made anew: 20000 points a scan with noise, an exposure of their own and any
rotation between them.
  wall       a flat wall with posters; the scans share 60 percent
  floor      tiles with stains
  box        square ends, and labels on two of its sides
  column     a round column with posters
  corridor   two walls with posters, floor and ceiling
  intensity  the wall by a LiDAR's intensity, which falls off with range
  unrelated  two different walls: nothing is right
  unmarked   tiles without stains: each pose is as good as the next tile's, none is right

A case is right within 1 degree and 0.02 m; of a box and the like only one of the poses that the
shape admits is. registered counts the cases that were, wrong those that were registered and are not
right. When the module open3d is installed, its RANSAC on FPFH with colored ICP after it runs on the
same cases; it has no verdict.

exit code: 0; 1 when a wrong pose was registered with colors; 2 when nothing could be run."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="colors",
        description="Registers painted scenes, with their colors and without.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("--scenes", nargs="+", choices=SCENES, default=SCENES, metavar="SCENE",
        help="which (default: all)")  # fmt: skip
    add("--cases", type=positive, default=20, metavar="N", help="of each (default: 20)")
    add("--preset", default="default", help="(default: default)")
    add("--threads", type=positive, default=1, metavar="N", help="(default: 1)")
    add("--json", type=Path, metavar="FILE", help="write the figures to FILE")
    add("--smoke", action="store_true", help="two small cases of a few scenes")
    return made
