"""The command line of the benchmark of many pairs."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import natural, positive

KINDS = ("threads", "processes", "dask")


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="batch",
        description="Registers many small generated pairs by pyemtr.register_many() and prints the "
        "pairs per second beside those of a plain loop, for each kind of executor and number of "
        "workers, and the overhead of a pair: what it takes beside its registration. With --kill "
        "and --kill-workers it checks that runs which are killed lose nothing and do nothing "
        "twice. The machine should have nothing else to do.",
        epilog="exit code: 0; 1 when a killed run does not end with the records of one that was "
        "left alone; 2 when nothing could be run.",
    )
    add = parser.add_argument
    add("--pairs", type=positive, default=200, help="in a run [%(default)s]")
    add("--points", type=positive, default=1000, help="of a cloud [%(default)s]")
    add("--kinds", nargs="+", choices=KINDS, default=list(KINDS), help="of executors [all]")
    add("--workers", nargs="+", type=positive, default=[1, 2, 4], help="[1 2 4]")
    add("--rounds", type=positive, default=3, help="of which the best counts [%(default)s]")
    add("--kill", type=natural, default=0, metavar="N",
        help="instead: kill a run by SIGKILL at N random moments and take it up again, in Python "
        "and, if it is built, the command's")  # fmt: skip
    add("--kill-workers", type=natural, default=0, metavar="N",
        help="instead, or with --kill too: kill N workers of Dask during a run")  # fmt: skip
    add("--seed", type=natural, default=0, help="of the random moments [%(default)s]")
    add("--command", type=Path, help="pcl_emtr [that of build]")
    add("--json", type=Path, metavar="FILE", help="write all figures to FILE")
    add("--smoke", action="store_true", help="few pairs, threads only, one kill")
    arguments = parser.parse_args()
    if arguments.smoke:
        arguments.pairs, arguments.points, arguments.rounds = 12, 300, 1
        arguments.kinds, arguments.workers = ["threads"], [1, 2]
    return arguments
