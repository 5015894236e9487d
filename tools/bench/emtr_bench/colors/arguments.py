"""The command line of the benchmark of colors."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from ..arguments import natural, positive
from ..pair_arguments import WHERE_ELSE, add_pair_options

#: The scenes by group; a prefix of the last group's names says what is wrong with a scene's colors.
GROUPS = {
    "tuned": ("wall", "floor", "box", "column", "corridor", "intensity", "unrelated", "unmarked"),
    "held-out": ("mosaic", "wallpaper", "facade", "ceiling", "carpet", "road", "road_intensity",
                 "parcel", "can", "things", "hotel"),
    "contrary": ("unrelated-mosaic", "unrelated-wallpaper", "unrelated-facade", "unrelated-ceiling",
                 "unrelated-carpet", "unrelated-road", "unrelated-road_intensity",
                 "unrelated-parcel", "unrelated-can",
                 "constant-mosaic", "random-mosaic", "painted-mosaic",
                 "constant-parcel", "random-parcel", "painted-parcel",
                 "constant-things", "random-things", "painted-things"),
}  # fmt: skip
SOLVERS = ("off", "auto", "on", "open3d", "open3d-true")

EPILOG = """Each case is made anew. Group tuned: 20000 points a scan with noise, an exposure of
their own and any rotation between them. The library's thresholds were chosen on scenes of these
kinds.
  wall       a flat wall with posters; the scans share 60 percent
  floor      tiles with stains
  box        square ends, and labels on two of its sides
  column     a round column with posters
  corridor   two walls with posters, floor and ceiling
  intensity  the wall by a LiDAR's intensity, which falls off with range
  unrelated  two different walls: nothing is right
  unmarked   tiles without stains: each pose is as good as the next tile's, none is right
Group held-out: other prints, shapes, sizes and units, and each scan by a sensor of its own: 10000
to 40000 points, gain, white balance, gamma, dark corners, 8 bits, noise, holes.
  mosaic     a wall of small stones, and a picture
  wallpaper  one motif over and over, and a few pictures
  facade     rows of windows, each like the next
  ceiling    panels, and lamps that blind the camera
  carpet     shades without an edge
  road       lane marks and patches; road_intensity the same by a LiDAR
  parcel     square ends, two or three labels with text, in millimeters
  can        a printed label all around, in millimeters
  things     boxes on a floor, whose shape is enough
  hotel      one wallpaper with different pictures: nothing is right
Group contrary: two scenes of one kind that do not belong together (unrelated-), or colors of which
each scan has one for all points (constant-), one for each point by chance (random-), or those of
a print of its own (painted-).

A case is right within 1 degree and 0.02 m, of the held-out scenes 0.005 of their extent; of a box
and the like only one of the poses that the shape admits is. registered counts the cases that were,
wrong those that were registered and are not right. open3d is the RANSAC on FPFH of the module
open3d with colored ICP after it, where that is installed; it has no verdict. open3d-true is that
colored ICP from the true pose: its errors are those of its refinement alone.

exit code: 0; 1 when a wrong pose was registered with colors; 2 when nothing could be run."""


OWN = """Their PLY
files must have the properties red, green and blue, or intensity. Each case is another motion of the
source. Right is then within 5 degrees and 0.05 of the larger cloud's radius, since the poses of
real pairs have errors of their own."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="colors",
        description="Registers painted scenes, with their colors and without.",
        epilog=f"{EPILOG}\n\n{WHERE_ELSE} {OWN}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("--scenes", nargs="+", type=scenes, default=[GROUPS["tuned"]], metavar="SCENE",
        help="which, by name or group (default: tuned)")  # fmt: skip
    add("--cases", type=positive, default=20, metavar="N", help="of each (default: 20)")
    add("--seed", type=natural, default=0, metavar="N", help="of the first case (default: 0)")
    add(
        "--solvers",
        nargs="+",
        choices=SOLVERS,
        default=("off", "auto", "open3d"),
        metavar="SOLVER",
        help="off, auto, on: emtr with this use_colors; open3d; open3d-true (default: off auto "
        "open3d)",
    )
    add("--preset", default="default", help="(default: default)")
    add("--threads", type=positive, default=1, metavar="N", help="(default: 1)")
    add_pair_options(made, "all")
    add("--json", type=Path, metavar="FILE", help="write the figures and each case to FILE")
    add("--smoke", action="store_true", help="two small cases of a few scenes")
    return made


def scenes(text: str) -> Sequence[str]:
    if text in GROUPS:
        return GROUPS[text]
    if any(text in names for names in GROUPS.values()):
        return (text,)
    known = ", ".join([*GROUPS, *(name for names in GROUPS.values() for name in names)])
    raise argparse.ArgumentTypeError(f"expected one of {known}; got {text!r}")
