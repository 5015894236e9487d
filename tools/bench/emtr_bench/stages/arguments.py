"""The command line of the stage benchmark."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..arguments import positive
from ..pair_arguments import WHERE_ELSE, add_pair_options

STRUCTURES = ("grid", "kdtree")
EPILOG = """The first table has the wall seconds of each stage, for each preset and number of
threads. The second has those of the evolution with the candidate grid and with pcl::KdTreeFLANN
(neighbors=grid and kdtree), in turns, and tells whether both found the same bits. The third has
the work that can be counted, one thread: the bytes of the clouds, the pairs of descriptors and the
nearest-neighbor queries; the least milliseconds that this machine could need for each, which are
those of the plainest program by numpy that reads so many bytes, multiplies so many descriptors or
reads so often at a random place of a table; and those of the stage that does it.

exit code: 0; 1 when the bits were not the same; 2 when nothing could be run."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="stages",
        description="Wall time of each stage of a registration, of the sample pair by default.",
        epilog=f"{WHERE_ELSE}\n\n{EPILOG}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = made.add_argument
    add("--presets", nargs="+", metavar="NAME", help="of emtr (default: all that there are)")
    add("--threads", nargs="+", type=positive, default=[1, 2], metavar="N",
        help="how many threads (default: 1 2); the structures are compared with "
        "the last")  # fmt: skip
    add_pair_options(made, "all")
    add("--points", type=positive, default=40000,
        help="of each cloud of the sample pair (default: 40000)")  # fmt: skip
    add("--repetitions", type=positive, default=9, metavar="N",
        help="of each registration by the grid (default: 9)")  # fmt: skip
    add("--slow-repetitions", type=positive, default=3, metavar="N",
        help="of each structure where they are compared (default: 3)")  # fmt: skip
    add("--json", type=Path, metavar="FILE", help="write the figures to FILE")
    add("--smoke", action="store_true", help="a small pair, once each")
    return made
