"""Makes cases, solves them and prints; see the command's --help."""

from __future__ import annotations

import argparse
import itertools
import json
import sys
from collections.abc import Iterator
from statistics import median
from typing import Any

import numpy as np

from pyemtr.metrics import rotation_error

from .. import machine
from ..data import chosen
from ..pair_arguments import asks_for_pairs
from ..pairs import FILES, DataError, read_ply
from ..unknown_scale import split
from ..whole_file import write_whole
from .cases import Array, Case, make_case, unit_cube
from .solvers import PUBLISHED, Answer, Solver, emtr_solver, teaser_solver

RIGHT_DEGREES, RIGHT_DISTANCE, RIGHT_SCALE = 10.0, 0.1, 0.1


def matches(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    if arguments.smoke:
        arguments.counts, arguments.outliers, arguments.cases = [50, 300], [0.0, 0.9, 1.0], 2
    try:
        clouds = clouds_of(arguments)
    except DataError as error:
        print(f"matches: {error}", file=sys.stderr)
        return 2
    solvers: dict[str, Solver] = {"emtr": emtr_solver(arguments.threads, arguments.unknown_scale)}
    teaser = teaser_solver(arguments.noise, arguments.unknown_scale)
    if teaser:
        solvers["TEASER++"] = teaser
    else:
        print(PUBLISHED)
    rows = []
    for name, cloud in clouds.items():
        print(f"{name}\n{HEAD}" if name else HEAD, flush=True)
        rows += [{"cloud": name, **row} for row in solve_all(cloud, solvers, arguments)]
    if arguments.json:
        value = {"benchmark": "matches", "machine": machine.describe(("pyemtr", "numpy")),
                 "noise": arguments.noise, "cases": arguments.cases, "rows": rows}  # fmt: skip
        write_whole(arguments.json, json.dumps(value, indent=1) + "\n")
        print(f"wrote {arguments.json}")
    return int(any(row["solver"] == "emtr" and row["wrong"] for row in rows))


def clouds_of(arguments: argparse.Namespace) -> dict[str, Array | None]:
    """Where the points are from, by name: "" and None for points made on the spot."""
    if arguments.cloud:
        return {str(arguments.cloud): unit_cube(read_ply(arguments.cloud))}
    if not asks_for_pairs(arguments):
        return {"": None}
    pairs = chosen(arguments)
    return {pair.name: unit_cube(read_ply(pair.folder / FILES[1])) for pair in pairs}


def solve_all(
    cloud: Array | None, solvers: dict[str, Solver], arguments: argparse.Namespace
) -> Iterator[dict[str, Any]]:
    """A row for each kind of case and solver, printed as it is done."""
    for count, outliers in itertools.product(arguments.counts, arguments.outliers):
        cases = [
            make_case(count, outliers, arguments.noise, seed, cloud, arguments.unknown_scale)
            for seed in range(arguments.cases)
        ]
        for name, solve in solvers.items():
            answers = [(solve(case), case) for case in cases]
            row = {"solver": name, "count": count, "outliers": outliers, **summary(answers)}
            print(line(row), flush=True)
            yield row


def summary(answers: list[tuple[Answer, Case]]) -> dict[str, float]:
    """Returns the figures of cases of one kind. Distances are in the source's unit."""
    found = [split(answer.pose) for answer, _ in answers]
    cases = [case for _, case in answers]
    degrees = [rotation_error(rigid, case.truth) for (_, rigid), case in zip(found, cases)]
    distances = [
        float(np.linalg.norm(rigid[:3, 3] / case.scale - case.truth[:3, 3]))
        for (_, rigid), case in zip(found, cases)
    ]
    scales = [abs(scale / case.scale - 1) for (scale, _), case in zip(found, cases)]
    right = [
        angle < RIGHT_DEGREES and distance < RIGHT_DISTANCE and scale < RIGHT_SCALE
        for angle, distance, scale in zip(degrees, distances, scales)
    ]
    registered = [answer.registered for answer, _ in answers]
    return {
        "right": sum(right),
        "registered": sum(registered),
        "wrong": sum(r and not ok for r, ok in zip(registered, right)),
        "cases": len(answers),
        "degrees": median(degrees),
        "distance": median(distances),
        "scale": median(scales),
        "seconds": median(answer.seconds for answer, _ in answers),
    }


HEAD = (
    f"{'':<9}{'matches':>8}{'wrong %':>9}{'right':>9}{'registered':>12}{'wrong':>7}"
    f"{'degrees':>11}{'distance':>11}{'scale %':>10}{'seconds':>10}"
)


def line(row: dict[str, Any]) -> str:
    right = f"{row['right']}/{row['cases']}"
    return (
        f"{row['solver']:<9}{row['count']:>8}{100 * row['outliers']:>9.1f}{right:>9}"
        f"{row['registered']:>12}{row['wrong']:>7}{row['degrees']:>11.3g}"
        f"{row['distance']:>11.3g}{100 * row['scale']:>10.3g}{row['seconds']:>10.4f}"
    )
