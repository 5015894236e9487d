"""Finds the sets in a folder, and writes their pairs; see the command's --help."""

from __future__ import annotations

import argparse
import csv
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from ..layout import COLUMNS, MANIFEST, write_manifest, write_pair
from ..pairs import DataError
from . import fgr, modelnet, resso, stanford, threedmatch, uwa
from .archives import unpack_all
from .arguments import SETS
from .found import Found
from .shares import overlaps, tier_of


def convert(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    try:
        rows = manifest_of(arguments.target)
        if not arguments.source.is_dir():
            raise DataError(f"{arguments.source}: no such folder; it is to have the archives")
        with tempfile.TemporaryDirectory(prefix="convert-") as scratch:
            folders = unpack_all(arguments.source, Path(scratch))
            written = _write_all(folders, rows, arguments)
    except (DataError, OSError) as error:
        print(f"convert: {error}", file=sys.stderr)
        return 2
    if not written:
        print(f"convert: {arguments.source} has nothing of {', '.join(_wanted(arguments))}: "
              "docs/BENCHMARKING.md says what the archives are", file=sys.stderr)  # fmt: skip
        return 2
    print(f"wrote {written} pairs into {arguments.target}: accuracy --data {arguments.target}")
    return 0


def manifest_of(target: Path) -> dict[str, dict[str, str]]:
    """The rows of pairs that are there already, by name. Raises DataError for a folder that has
    something else in it."""
    path = target / MANIFEST
    if path.is_file():
        with path.open(newline="", encoding="utf-8") as file:
            return {row["name"]: row for row in csv.DictReader(file)}
    if target.exists() and (not target.is_dir() or any(target.iterdir())):
        raise DataError(f"{target}: expected a new folder, or one with a {MANIFEST}")
    return {}


def all_found(folders: list[Path], arguments: argparse.Namespace) -> Iterator[Found]:
    """The pairs of the wanted sets, set by set."""
    readers = {
        "stanford": stanford.pairs, "fgr": fgr.pairs, "uwa": uwa.pairs, "resso": resso.pairs,
        "modelnet": lambda places: modelnet.pairs(places, arguments.per_category),
        "threedmatch": threedmatch.pairs,
    }  # fmt: skip
    for name in _wanted(arguments):
        yield from readers[name](folders)


def _write_all(
    folders: list[Path], rows: dict[str, dict[str, str]], arguments: argparse.Namespace
) -> int:
    written = 0
    for found in all_found(folders, arguments):
        source, target = found.source(), found.target()
        shared = overlaps(source, target, found.T_gt)
        text = f"{found.group} {found.name}: overlap {shared[0]:.0%} and {shared[1]:.0%}"
        if not found.paired and min(shared) < arguments.least_overlap:
            continue
        if rows.get(found.name, {}).get("group", found.group) != found.group:
            raise DataError(f"{arguments.target}: has another pair that is called {found.name}")
        tier = found.tier or tier_of(shared)
        write_pair(
            arguments.target / "pairs" / found.group / found.name, source, target, found.T_gt
        )
        figures = (found.group, found.name, tier, len(source), len(target),
                   f"{shared[0]:.3f}", f"{shared[1]:.3f}")  # fmt: skip
        rows[found.name] = dict(zip(COLUMNS, map(str, figures)))
        write_manifest(arguments.target, rows.values())
        written += 1
        doubt = "" if max(shared) > 0.05 else "  (next to none: is the pose right?)"
        print(f"{text}, tier {tier}{doubt}", flush=True)
    return written


def _wanted(arguments: argparse.Namespace) -> list[str]:
    return list(arguments.set or SETS)
