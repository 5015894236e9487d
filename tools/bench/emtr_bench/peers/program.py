"""The comparison: chooses pairs and methods, runs them, prints and writes what came out."""

from __future__ import annotations

import argparse
import sys

import pyemtr

from .. import machine, records
from ..data import chosen, related
from ..pairs import DataError, Pair
from . import methods, output, sweep, tables
from .methods import Method
from .runs import Options, PeerRun, measure
from .settings import Setting, grid
from .sweep import at_recommended
from .sweep_tables import FOOTER as SWEEP_FOOTER
from .sweep_tables import sweep_tables

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
        arguments.threads, arguments.limit, arguments.seed, Setting(arguments.voxel_points),
    )  # fmt: skip
    settings = choose_settings(arguments, options.recommended)
    pairs = choose_pairs(arguments)
    found = machine.describe(_installed(present))
    print(", ".join(f"{name} {value}" for name, value in found.items()))
    for name, why in left_out.items():
        print(f"left out: {name} ({why})")
    runs = _run(pairs, present, options, settings)
    print(_report(at_recommended(runs, options.recommended)))
    if arguments.sweep:
        print(_sweep_report(runs, options.recommended))
    if arguments.plot:
        from .sweep_plot import plot

        swept = {tier: sweep.points(mine) for tier, mine in _tiers(runs).items()}
        plot(swept, options.recommended, arguments.plot)
        print(f"wrote {arguments.plot}")
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


def choose_settings(arguments: argparse.Namespace, recommended: Setting) -> list[Setting]:
    if arguments.plot and not arguments.sweep:
        raise ValueError("--plot draws a sweep: it goes with --sweep")
    if not arguments.sweep:
        return [recommended]
    return grid(recommended, arguments.sweep_points, arguments.refine_points)


def choose_pairs(arguments: argparse.Namespace) -> list[Pair]:
    pairs = related(chosen(arguments))
    return [min(pairs, key=lambda pair: pair.size)] if arguments.smoke else pairs


def _run(
    pairs: list[Pair], present: list[Method], options: Options, settings: list[Setting]
) -> list[PeerRun]:
    """A line a pair and motion, so that one sees how it goes."""
    runs: list[PeerRun] = []
    for done in measure(pairs, present, options, settings):
        runs += done
        shown = at_recommended(done, options.recommended)
        cells = (f"{r.seconds:.3f}{' ' if r.success else '!'}" if not r.error else "lost! "
                 for r in shown)  # fmt: skip
        print(f"{done[0].pair.name}[{done[0].index}]".ljust(30), *cells, flush=True)
    return runs


def _report(runs: list[PeerRun]) -> str:
    parts = ["(seconds of each method in the tables' order; ! where it failed)"]
    parts += [tables.tier_tables(name, mine) for name, mine in _tiers(runs).items()]
    parts += [tables.FOOTER, tables.lost(runs)]
    return "\n\n".join(part for part in parts if part)


def _sweep_report(runs: list[PeerRun], recommended: Setting) -> str:
    parts = [""]
    parts += [sweep_tables(name, mine, recommended) for name, mine in _tiers(runs).items()]
    return "\n\n".join([*parts, SWEEP_FOOTER])


def _tiers(runs: list[PeerRun]) -> dict[str, list[PeerRun]]:
    """The runs of each tier by its title, and then of all where there are several."""
    names = dict.fromkeys(run.pair.tier for run in runs)
    tiers = {f"tier {name}": [run for run in runs if run.pair.tier == name] for name in names}
    return {**tiers, "all tiers": runs} if len(tiers) > 1 else tiers


def _installed(present: list[Method]) -> list[str]:
    used = {module for method in present for module in method.modules} | {"numpy"}
    return [package for package in PACKAGES if package in used]
