"""The comparison: chooses pairs and methods, runs them, prints and writes what came out."""

from __future__ import annotations

import argparse
import sys

import pyemtr

from .. import machine, records
from ..data import chosen, related
from ..pairs import DataError, Pair
from . import methods, output, tables
from .methods import Method
from .runs import Options, PeerRun, measure

PACKAGES = ("pyemtr", "open3d", "kiss_matcher", "small_gicp", "numpy")


def compare(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    try:
        return _compare(arguments)
    except (DataError, ValueError) as error:
        print(f"peers: {error}", file=sys.stderr)
        return 2


def _compare(arguments: argparse.Namespace) -> int:
    wanted = choose_methods(arguments.presets, arguments.only)
    left_out = {m.name: "no " + ", no ".join(m.missing()) for m in wanted if m.missing()}
    if left_out and not arguments.smoke:
        raise ValueError("not installed: " + "; ".join(f"{m}: {w}" for m, w in left_out.items()))
    present = [method for method in wanted if method.name not in left_out]
    if not present:
        raise ValueError("nothing to run: " + "; ".join(f"{m}: {w}" for m, w in left_out.items()))
    options = Options(
        1 if arguments.smoke else arguments.transforms,
        arguments.threads, arguments.limit, arguments.seed, arguments.voxel_points,
    )  # fmt: skip
    pairs = choose_pairs(arguments)
    found = machine.describe(_installed(present))
    print(", ".join(f"{name} {value}" for name, value in found.items()))
    for name, why in left_out.items():
        print(f"left out: {name} ({why})")
    runs = _run(pairs, present, options)
    print(_report(runs))
    if arguments.json:
        records.write(arguments.json, output.record(found, options, left_out, runs))
        print(f"wrote {arguments.json}")
    return int(any(run.error for run in runs if run.method.startswith(methods.OURS)))


def choose_methods(presets: list[str] | None, only: list[str]) -> list[Method]:
    known = pyemtr.presets()
    for preset in presets or []:
        if preset not in known:
            raise ValueError(f"--presets {preset}: no such preset; there are {', '.join(known)}")
    return methods.select(methods.all_methods(presets or list(known)), only)


def choose_pairs(arguments: argparse.Namespace) -> list[Pair]:
    pairs = related(chosen(arguments))
    return [min(pairs, key=lambda pair: pair.size)] if arguments.smoke else pairs


def _run(pairs: list[Pair], present: list[Method], options: Options) -> list[PeerRun]:
    """A line a pair and motion, so that one sees how it goes."""
    runs: list[PeerRun] = []
    for done in measure(pairs, present, options):
        runs += done
        cells = (f"{r.seconds:.3f}{' ' if r.success else '!'}" if not r.error else "lost! "
                 for r in done)  # fmt: skip
        print(f"{done[0].pair.name}[{done[0].index}]".ljust(30), *cells, flush=True)
    return runs


def _report(runs: list[PeerRun]) -> str:
    parts = ["(seconds of each method in the tables' order; ! where it failed)"]
    tiers = list(dict.fromkeys(run.pair.tier for run in runs))
    for tier in tiers:
        parts.append(tables.tier_tables(f"tier {tier}", [r for r in runs if r.pair.tier == tier]))
    if len(tiers) > 1:
        parts.append(tables.tier_tables("all tiers", runs))
    parts += [tables.FOOTER, tables.lost(runs)]
    return "\n\n".join(part for part in parts if part)


def _installed(present: list[Method]) -> list[str]:
    used = {module for method in present for module in method.modules} | {"numpy"}
    return [package for package in PACKAGES if package in used]
