"""The command line of the benchmark of many scans."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import positive
from ..pair_arguments import WHERE, add_pair_options

EPILOG = f"""{WHERE}

The scans of a scene are those of all pairs of one group whose names begin with the same word, as
bunny_045_000 and bunny_000_090; equal files are one scan. Each is moved at random. Scans are judged
where pairs chain them: a scan is right when it is in the model of most of its chain, within 1
degree and 0.01 radii of it ("precise"), or within 5 degrees and 0.06 radii ("right"). Scenes of
fewer than three scans are left out.

--method open3d takes Open3D's multiway registration (FPFH, RANSAC and ICP of all pairs, as its
tutorial has it, and its optimization of the pose graph), and kiss the pairs of KISS-Matcher with
the pose graph of emtr. They run where the packages open3d and kiss_matcher are installed,
as in build/venv-peers.

exit code: 0; 1 when a scan of emtr is placed wrong; 2 when nothing could be run."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="align_all",
        description="Aligns many scans of one thing, and judges the poses.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add_pair_options(made, "all")
    add("--scene", nargs="+", metavar="NAME", help="these scenes alone, as stanford/bunny")
    add("--method", nargs="+", choices=("emtr", "open3d", "kiss"), default=["emtr"],
        help="(default: emtr)")  # fmt: skip
    add("--threads", type=positive, metavar="N", help="(default: one for each processor)")
    add("--seed", type=int, default=0, metavar="N", help="of the motions and the run (default: 0)")
    add("--json", type=Path, metavar="FILE", help="write the figures to FILE")
    add("--edges", action="store_true",
        help="instead, measure the errors of edges by their information matrices")  # fmt: skip
    add("--large", type=positive, metavar="N",
        help="instead, align a made site of N large scans, and tell memory and time")  # fmt: skip
    add("--swarm", action="store_true",
        help="instead, compare the joint refinement with swarms over all poses")  # fmt: skip
    add("--points", type=positive, default=1_000_000, metavar="N",
        help="of each scan of --large (default: 1000000)")  # fmt: skip
    add("--folder", type=Path, metavar="DIR",
        help="where the scans of --large are meanwhile (default: the system's)")  # fmt: skip
    add("--smoke", action="store_true", help="two generated things and a scan of a third")
    return made
