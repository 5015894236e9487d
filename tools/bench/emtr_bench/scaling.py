"""The scaling benchmark: time and memory against the number of points."""

from __future__ import annotations

import argparse
import json
import math
import os
import platform
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pyemtr

from .records import write

SMOKE_SIZES = (1000, 30000, 210000)  # the last is large enough to be downsampled first
STAGES = (
    "normalization", "downsampling", "features", "matching", "seeds", "evolution", "candidates",
    "fallback_search", "refinement", "verdict",
)  # fmt: skip
TOOLS = Path(__file__).resolve().parents[1]

#: What the project promises for two clouds of ten million float32 points on two cores.
LARGEST, MOST_SECONDS, MOST_MEMORY = 10000000, 4.0, 3.0
#: Highest exponent of the time in the points, from this many on.
SLOPE_FROM, MOST_SLOPE = 100000, 1.05


class ScalingError(Exception):
    """A size that could not be measured."""


def scaling(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    sizes, repeat = sorted(set(arguments.sizes)), arguments.repeat
    if arguments.smoke:
        sizes, repeat = list(SMOKE_SIZES), 1
    print(header(), flush=True)
    rows = []
    try:
        for points in sizes:
            rows.append(measure(points, arguments.seed, arguments.threads, repeat))
            print(line(rows[-1]), flush=True)
    except ScalingError as error:
        print(f"scaling: {error}", file=sys.stderr)
        return 1
    exponent = slope(rows)
    print(
        f"time grows as points^{exponent:.2f} from {SLOPE_FROM:g} points on"
        if math.isfinite(exponent)
        else f"no slope: fewer than 2 sizes from {SLOPE_FROM:g} on"
    )
    if arguments.json:
        write(arguments.json, record(rows, exponent, arguments.threads, repeat))
        print(f"wrote {arguments.json}")
    if arguments.plot:
        from .scaling_plot import plot

        plot(rows, arguments.plot)
        print(f"wrote {arguments.plot}")
    missed = targets_missed(rows, exponent)
    if arguments.require:
        print("targets: " + ("; ".join(missed) if missed else "met"))
    wrong = [row["points"] for row in rows if not row["E_R"] < 5.0]
    if wrong:
        print(f"scaling: wrong pose at {wrong} points", file=sys.stderr)
    return int(bool(wrong or (arguments.require and missed)))


def measure(points: int, seed: int, threads: int, repeat: int) -> dict[str, Any]:
    job = json.dumps({"points": points, "seed": seed, "threads": threads, "repeat": repeat})
    command = [sys.executable, "-m", "emtr_bench.scaling_run", job]
    done = subprocess.run(command, cwd=TOOLS, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise ScalingError(f"the run with {points} points a cloud ended with {done.returncode}")
    row: dict[str, Any] = json.loads(done.stdout)
    return row


def memory(row: dict[str, Any]) -> float:
    """Highest resident memory of the process, input and interpreter included, over the input."""
    return float(row["peak_bytes"] / row["input_bytes"])


def slope(rows: Sequence[dict[str, Any]]) -> float:
    """Exponent of the time in the points by least squares, NaN for fewer than two sizes."""
    points = [(math.log(row["points"]), math.log(row["seconds"]))
              for row in rows if row["points"] >= SLOPE_FROM]  # fmt: skip
    if len(points) < 2:
        return math.nan
    x, y = (sum(values) / len(points) for values in zip(*points))
    covariance = sum((a - x) * (b - y) for a, b in points)
    return float(covariance / sum((a - x) ** 2 for a, _ in points))


def targets_missed(rows: Sequence[dict[str, Any]], exponent: float) -> list[str]:
    missed = []
    largest = [row for row in rows if row["points"] >= LARGEST]
    if not largest:
        missed.append(f"{LARGEST:g} points a cloud not measured")
    for row in largest:
        if row["seconds"] > MOST_SECONDS:
            missed.append(f"{row['points']:g} points: {row['seconds']:.2f} s > {MOST_SECONDS:g} s")
        if memory(row) >= MOST_MEMORY:
            missed.append(f"{row['points']:g} points: memory {memory(row):.2f} x the input, "
                          f"not below {MOST_MEMORY:g}")  # fmt: skip
    if not exponent <= MOST_SLOPE:
        missed.append(f"slope {exponent:.2f}, not at most {MOST_SLOPE:g}")
    missed += [f"{row['points']:g} points: not registered" for row in rows if not row["registered"]]
    return missed


def header() -> str:
    names = "".join(f"{stage:>11}" for stage in STAGES)
    first = f"{'points':>10}{names}{'total':>9}{'kept':>9}{'input':>9}{'peak':>9}{'peak/':>8}"
    units = f"{'a cloud':>10}" + len(STAGES) * f"{'ms':>11}"
    second = f"{units}{'s':>9}{'s':>9}{'MB':>9}{'MB':>9}{'input':>8}{'E_R':>8}"
    return "\n".join((first, second, "-" * len(second)))


def line(row: dict[str, Any]) -> str:
    stages = "".join(f"{1e3 * row['stages'][stage]:>11.1f}" for stage in STAGES)
    doubt = "" if row["registered"] else "  doubtful"
    return (
        f"{row['points']:>10}{stages}{row['seconds']:>9.3f}{row['seconds_kept']:>9.3f}"
        f"{row['input_bytes'] / 1e6:>9.1f}{row['peak_bytes'] / 1e6:>9.1f}{memory(row):>8.2f}"
        f"{row['E_R']:>8.2f}{doubt}"
    )


def record(
    rows: Sequence[dict[str, Any]], exponent: float, threads: int, repeat: int
) -> dict[str, Any]:
    return {
        "benchmark": "scaling",
        "emtr_version": pyemtr.__version__,
        "kernel": pyemtr.kernel_name(),
        "threads": threads,
        "repeat": repeat,
        "machine": {"system": platform.platform(), "cpus": os.cpu_count()},
        "slope": exponent,
        "slope_from": SLOPE_FROM,
        "sizes": [{**row, "memory_over_input": memory(row)} for row in rows],
    }
