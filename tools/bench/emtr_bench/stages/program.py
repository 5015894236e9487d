"""Measures and prints; see the command's --help."""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pyemtr

from .. import machine, records
from ..data import chosen, related
from ..pair_arguments import asks_for_pairs
from ..pairs import Array, DataError
from ..peers.summary import Quartiles
from ..peers.tables import number, spread
from ..runner import moved
from ..sample import sample_clouds
from .arguments import STRUCTURES
from .limits import limits, machine_rates
from .measure import compare_structures, profile

SMOKE_POINTS = 1500


def stages(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    if arguments.smoke:
        arguments.points, arguments.repetitions, arguments.slow_repetitions = SMOKE_POINTS, 1, 1
    known = pyemtr.presets()
    presets = arguments.presets or list(known)
    unknown = [preset for preset in presets if preset not in known]
    if unknown:
        print(f"stages: --presets {unknown[0]}: no such preset; there are {', '.join(known)}",
              file=sys.stderr)  # fmt: skip
        return 2
    found = machine.describe(("pyemtr", "numpy"))
    try:
        with tempfile.TemporaryDirectory() as scratch:
            parts = [_measure(clouds, presets, arguments)
                     for clouds in _all_clouds(arguments, Path(scratch))]  # fmt: skip
    except DataError as error:
        print(f"stages: {error}", file=sys.stderr)
        return 2
    structures = [row for part in parts for row in part["structures"]]
    if arguments.json:
        value = {
            "benchmark": "stages", "machine": found, "kernel": pyemtr.kernel_name(),
            "repetitions": arguments.repetitions,
            "slow_repetitions": arguments.slow_repetitions, **parts[0], "others": parts[1:],
        }  # fmt: skip
        records.write(arguments.json, value)
        print(f"wrote {arguments.json}")
    return int(not all(row["same_bits"] for row in structures))


def _all_clouds(arguments: argparse.Namespace, scratch: Path) -> Iterator[tuple[str, Array, Array]]:
    """Name, source and target of what is measured: the sample pair, or the pairs asked for."""
    if not asks_for_pairs(arguments):
        yield "sample", *sample_clouds(scratch, arguments.points)
        return
    pairs = related(chosen(arguments))
    if arguments.smoke:
        pairs = [min(pairs, key=lambda pair: pair.size)]
    for pair in pairs:
        case = moved(pair, 0)
        yield pair.name, case.source, case.target


def _measure(
    clouds: tuple[str, Array, Array], presets: list[str], arguments: argparse.Namespace
) -> dict[str, Any]:
    name, source, target = clouds
    print(f"{name}: clouds of {len(source)} and {len(target)} points, "
          f"kernel {pyemtr.kernel_name()}")  # fmt: skip
    profiles = [
        profile(source, target, preset, threads, arguments.repetitions)
        for preset in presets
        for threads in arguments.threads
    ]
    print(_profile_table(profiles), flush=True)
    structures = [
        compare_structures(source, target, preset, arguments.threads[-1],
                           arguments.slow_repetitions)
        for preset in presets
    ]  # fmt: skip
    print(f"{_structure_table(structures)}\n", flush=True)
    rates = machine_rates()
    least = [limits(source, target, preset, arguments.repetitions, rates) for preset in presets]
    print(f"{_limit_table(least)}\n", flush=True)
    return {"pair": name, "points": [len(source), len(target)], "profiles": profiles,
            "structures": structures, "limits": least}  # fmt: skip


def _profile_table(profiles: list[dict[str, Any]]) -> str:
    names = list(profiles[0]["seconds"])
    widths = {name: max(12, len(name) + 2) for name in names}
    heads = "".join(f"{name:>{width}}" for name, width in widths.items())
    lines = ["", f"{'median seconds':<16}{'threads':>8}{heads}"]
    for row in profiles:
        cells = "".join(
            f"{number(row['seconds'][name]['median'], 4):>{width}}"
            for name, width in widths.items()
        )
        lines.append(f"{row['preset']:<16}{row['threads']:>8}{cells}")
    return "\n".join(lines)


def _structure_table(rows: list[dict[str, Any]]) -> str:
    lines = ["", "evolution, median seconds (quartiles)"]
    for row in rows:
        parts = []
        for name in STRUCTURES:
            found = Quartiles(**row["evolution"][name])
            parts.append(f"{name} {number(found.median)} ({spread(found)})")
        bits = "the same bits" if row["same_bits"] else "NOT THE SAME BITS"
        lines.append(f"{row['preset']}, {row['threads']} threads: {', '.join(parts)}, "
                     f"ratio {number(row['ratio'], 1)}, {bits}")  # fmt: skip
    return "\n".join(lines)


def _limit_table(all_limits: list[dict[str, Any]]) -> str:
    lines = [f"{'one thread':<16}{'work':<18}{'amount':>14}{'least ms':>12}{'ms':>10}  of stage"]
    for found in all_limits:
        for row in found["rows"]:
            least, reached = (number(1e3 * row[name], 2) for name in ("least", "reached"))
            lines.append(f"{found['preset']:<16}{row['kind']:<18}{row['amount']:>14,}{least:>12}"
                         f"{reached:>10}  {row['stage']}")  # fmt: skip
    return "\n".join(lines)
