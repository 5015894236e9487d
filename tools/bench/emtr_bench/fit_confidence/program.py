"""Reads or makes the runs, fits the model, prints and writes it; see the command's --help."""

from __future__ import annotations

import argparse
import dataclasses
import sys
import tempfile
from pathlib import Path

from .. import accuracy, records
from ..arguments import parser
from ..calibration.tables import text as calibration_text
from ..pair_arguments import pair_words
from ..pairs import DataError
from .model import Fitted, fit
from .samples import TERMS, Sample, read


def fit_confidence(arguments: argparse.Namespace, engine: accuracy.Engine) -> int:
    """Does what the command line says; gives the exit code."""
    try:
        with tempfile.TemporaryDirectory(prefix="fit-confidence-") as scratch:
            files, status = arguments.files, 0
            if not files:
                file = Path(scratch) / "runs.json"
                words = parser("fit_confidence").parse_args(_words(arguments, file))
                files, status = [file], accuracy.measure(words, engine)
            samples = read(files, arguments.leave_out)
            fitted = fit(samples, arguments.minimum, arguments.bins)
    except DataError as error:
        print(f"fit_confidence: {error}", file=sys.stderr)
        return 2
    print(text(fitted, samples))
    if arguments.json:
        records.write(arguments.json, {"benchmark": "fit_confidence", **dataclasses.asdict(fitted)})
        print(f"wrote {arguments.json}")
    return status


def text(fitted: Fitted, samples: list[Sample]) -> str:
    sources = len({sample.source for sample in samples})
    lines = [f"fitted to {len(samples)} answers of {sources} sources"]
    lines += [f"{'bias':>14} {fitted.bias:9.3f}"]
    lines += [f"{name:>14} {weight:9.3f}" for name, weight in zip(TERMS, fitted.weights)]
    if fitted.figures is None:
        return "\n".join([*lines, "", "one source: there is no other to try the model on"])
    return "\n".join([*lines, "", calibration_text("on sources not seen", fitted.figures)])


def _words(arguments: argparse.Namespace, file: Path) -> list[str]:
    words = ["--json", str(file), *pair_words(arguments)]
    words += [] if arguments.tier or arguments.pair else ["--tier", "all"]
    if arguments.smoke:
        return [*words, "--smoke"]
    return [*words, "--transforms", str(arguments.transforms),
            "--unrelated", str(arguments.unrelated)]  # fmt: skip
