"""The command line of the benchmark of stops."""

from __future__ import annotations

import argparse

from .arguments import natural, positive

BY = ("callback", "limit", "signal")


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="cancel",
        description="Registers two scans of a bumpy ball again and again, all stages by preset "
        "thorough, and prints for each stage how long at most nobody was asked whether to stop, "
        "how long at most a run took to end once it was told, and the sum of the two: what a user "
        "waits at most after the callback would say stop. With --by limit or --by signal a limit "
        "or a signal ends the runs at moments of each stage, and what is printed is how long they "
        "went on after it. The machine should have nothing else to do.",
    )
    parser.add_argument(
        "--by", choices=BY, default="callback", help="what ends a run [%(default)s]"
    )
    parser.add_argument(
        "--points", type=positive, default=10_000_000, help="of a cloud [%(default)s]"
    )
    parser.add_argument(
        "--threads", type=natural, default=0, help="0: as OpenMP would [%(default)s]"
    )
    parser.add_argument(
        "--stops", type=positive, default=3, help="in each stage, spread over it [%(default)s]"
    )
    parser.add_argument("--smoke", action="store_true", help="a small pair, one stop a stage")
    arguments = parser.parse_args()
    if arguments.smoke:
        arguments.points, arguments.stops = 20_000, 1
    return arguments
