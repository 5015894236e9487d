"""Runs the variants and prints; see the command's --help."""

from __future__ import annotations

import argparse
import statistics
import sys
from typing import Any

from .. import machine, records
from ..accuracy import Engine
from ..data import are_generated, chosen, related
from ..pairs import DataError, Pair
from ..runner import Options, Run, run_all
from .variants import VARIANTS, Variant


def ablation(arguments: argparse.Namespace, engine: Engine) -> int:
    """Does what the command line says; gives the exit code."""
    variants = [
        v for v in VARIANTS
        if arguments.part is None or v.part == "nothing" or v.part in arguments.part
    ]  # fmt: skip
    found = machine.describe(("pyemtr", "numpy"))
    try:
        pairs, transforms = choose(arguments)
        for variant in variants:
            engine.check(_options(variant, arguments))
        rows = _measure(variants, pairs, transforms, arguments, engine)
    except (DataError, ValueError) as error:
        print(f"ablation: {error}", file=sys.stderr)
        return 2
    if arguments.json:
        value = {
            "benchmark": "ablation", "emtr_version": engine.version, "machine": found,
            "generated_pairs": are_generated(pairs),
            "preset": arguments.preset, "transforms": transforms, "seed": arguments.seed,
            "pairs": [[t, sum(p.tier == t for p in pairs)] for t in _tiers(pairs)], "rows": rows,
        }  # fmt: skip
        records.write(arguments.json, value)
        print(f"wrote {arguments.json}")
    return int(any(row["crashed"] for row in rows))


def choose(arguments: argparse.Namespace) -> tuple[list[Pair], int]:
    """The pairs and how many motions each."""
    pairs = related(chosen(arguments))
    if arguments.smoke:
        return [min(pairs, key=lambda pair: pair.size)], 1
    return pairs, arguments.transforms


def figures(variant: Variant, runs: list[Run], reference: list[Run]) -> dict[str, Any]:
    """A variant's row: joint success in percent by tier and over all runs, and how many runs of its
    block's reference it lost and won. The runs are the same pairs, motions and seeds in the same
    order, so these two tell small differences from chance."""
    both = list(zip(runs, reference))
    tiers = list(dict.fromkeys(run.pair.tier for run in runs))
    return {
        "block": variant.block,
        "part": variant.part,
        "settings": variant.settings,
        "runs": len(runs),
        "joint": {tier: _joint([r for r in runs if r.pair.tier == tier]) for tier in tiers},
        "joint_all": _joint(runs),
        "lost": sum(there.joint and not here.joint for here, there in both),
        "won": sum(here.joint and not there.joint for here, there in both),
        "registered": sum(run.registered for run in runs),
        "registered_right": sum(run.registered and run.joint for run in runs),
        "seconds": statistics.median(run.wall for run in runs),
        "crashed": [run.error for run in runs if run.error],
    }


def _measure(
    variants: list[Variant],
    pairs: list[Pair],
    transforms: int,
    arguments: argparse.Namespace,
    engine: Engine,
) -> list[dict[str, Any]]:
    tiers = _tiers(pairs)
    print(f"preset {arguments.preset}, {len(pairs)} pairs, {transforms} motions each: "
          f"joint success in %, emtr {engine.version}")  # fmt: skip
    heads = [*tiers, "all", "lost", "won", "seconds"]
    print(f"{'off':<45}" + "".join(f"{name:>13}" for name in heads))
    rows: list[dict[str, Any]] = []
    reference: dict[str, list[Run]] = {}  # by block, whose first variant it is
    for variant in variants:
        options = _options(variant, arguments)
        runs = list(run_all(pairs, transforms, engine.register, options, arguments.jobs))
        row = figures(variant, runs, reference.setdefault(variant.block, runs))
        cells = [f"{row['joint'][tier]:.1f}" for tier in tiers]
        cells += [f"{row['joint_all']:.1f}", str(row["lost"]), str(row["won"]),
                  f"{row['seconds']:.3f}"]  # fmt: skip
        name = f"{variant.block}: {variant.part}"
        print(f"{name:<45}" + "".join(f"{cell:>13}" for cell in cells), flush=True)
        if row["crashed"]:
            print(f"CRASHED: {len(row['crashed'])} runs; the first:\n{row['crashed'][0]}")
        rows.append(row)
    return rows


def _options(variant: Variant, arguments: argparse.Namespace) -> Options:
    return Options(arguments.preset, arguments.seed, arguments.threads, variant.settings)


def _tiers(pairs: list[Pair]) -> list[str]:
    return list(dict.fromkeys(pair.tier for pair in pairs))


def _joint(runs: list[Run]) -> float:
    return 100.0 * sum(run.joint for run in runs) / len(runs)
