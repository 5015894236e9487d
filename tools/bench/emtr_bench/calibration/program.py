"""Reads or makes the runs, prints and writes what they say; see the command's --help."""

from __future__ import annotations

import argparse
import dataclasses
import sys
import tempfile
from pathlib import Path

from .. import accuracy, records
from ..arguments import parser
from ..pair_arguments import pair_words
from ..pairs import DataError
from .figures import calibration as figures_of
from .judged import read
from .tables import text


def calibration(arguments: argparse.Namespace, engine: accuracy.Engine) -> int:
    """Does what the command line says; gives the exit code."""
    try:
        with tempfile.TemporaryDirectory(prefix="calibration-") as scratch:
            files, status = arguments.files, 0
            if not files:
                files, status = make(arguments, engine, Path(scratch))
            presets = read(files)
    except DataError as error:
        print(f"calibration: {error}", file=sys.stderr)
        return 2
    found = {name: figures_of(runs, arguments.bins) for name, runs in presets.items()}
    print("\n\n".join(text(f"preset {name}", figures) for name, figures in found.items()))
    if arguments.json:
        value = {name: dataclasses.asdict(figures) for name, figures in found.items()}
        records.write(arguments.json, {"benchmark": "calibration", "presets": value})
        print(f"wrote {arguments.json}")
    if arguments.plot:
        from .plot import plot

        plot(found, arguments.plot)
        print(f"wrote {arguments.plot}")
    return status


def make(
    arguments: argparse.Namespace, engine: accuracy.Engine, folder: Path
) -> tuple[list[Path], int]:
    """Runs the accuracy benchmark on all pairs; the files, and the worst of its exit codes."""
    files, status = [], 0
    for preset in arguments.presets:
        files.append(folder / f"{preset}.json")
        words = ["--preset", preset, "--json", str(files[-1])]
        if arguments.smoke:
            words.append("--smoke")
        else:
            words += ["--transforms", str(arguments.transforms),
                      "--unrelated", str(arguments.unrelated)]  # fmt: skip
        words += [] if arguments.tier or arguments.pair else ["--tier", "all"]
        words += pair_words(arguments)
        made = accuracy.measure(parser("calibration").parse_args(words), engine)
        status = max(status, made)
        print()
    return files, status
