"""Runs the parts that are asked for, then writes the page."""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

import pyemtr

from ..locations import REPOSITORY
from ..whole_file import write_whole
from .page import page
from .parts import Part, all_parts
from .running import kept, run


def report(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    known = pyemtr.presets()
    presets = arguments.presets or list(known)
    unknown = [preset for preset in presets if preset not in known]
    if unknown:
        print(f"report: --presets {unknown[0]}: no such preset; there are {', '.join(known)}",
              file=sys.stderr)  # fmt: skip
        return 2
    if arguments.smoke:
        with tempfile.TemporaryDirectory(prefix="report-") as scratch:
            folder = Path(scratch)
            out = arguments.out or folder / "BENCHMARK.md"
            return make(folder, folder, out, presets, arguments)
    folder, pictures = Path("build", "bench"), Path("docs")
    (REPOSITORY / folder).mkdir(parents=True, exist_ok=True)
    out = arguments.out or REPOSITORY / "BENCHMARK.md"
    return make(folder, pictures, out, presets, arguments)


def make(
    folder: Path, pictures: Path, out: Path, presets: list[str], arguments: argparse.Namespace
) -> int:
    parts = all_parts(folder, pictures, presets, arguments.smoke, arguments.sweep)
    wanted = [p for p in parts if arguments.only is None or p.section in arguments.only]
    missing = [part for part in wanted if not (REPOSITORY / part.program).exists()]
    failures = [failure for part in wanted if part not in missing and (failure := _run(part))]
    for part in missing:
        print(f"left out: there is no {part.program}")
    write_whole(out, page(parts, REPOSITORY / pictures, out))
    for failure in failures:
        print(f"report: {failure}", file=sys.stderr)
    print(f"wrote {out}")
    return int(bool(failures or (missing and not arguments.smoke)))


def _run(part: Part) -> str:
    print(f"\n== {part.line}", flush=True)
    failure = run(part)
    figures = kept(part)
    if not failure and figures is not None and figures.status != 0:
        failure = f"{part.line}: ended with {figures.status}"
    return failure
