"""Makes cases, solves them and prints; see the command's --help."""

from __future__ import annotations

import argparse
import json
import sys
from statistics import median
from typing import Any

import numpy as np

from pyemtr.metrics import rotation_error

from .. import machine
from ..whole_file import write_whole
from .cases import make_case, unit_cube
from .solvers import PUBLISHED, Answer, Solver, emtr_solver, teaser_solver

RIGHT_DEGREES, RIGHT_DISTANCE = 10.0, 0.1


def matches(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    if arguments.smoke:
        arguments.counts, arguments.outliers, arguments.cases = [50, 300], [0.0, 0.9, 1.0], 2
    cloud = None
    if arguments.cloud:
        from plyfile import PlyData

        try:
            vertex = PlyData.read(str(arguments.cloud))["vertex"]
        except OSError as error:
            print(f"matches: {error}", file=sys.stderr)
            return 2
        cloud = unit_cube(np.column_stack([vertex[axis] for axis in "xyz"]).astype(float))
    solvers: dict[str, Solver] = {"emtr": emtr_solver(arguments.threads)}
    teaser = teaser_solver(arguments.noise)
    if teaser:
        solvers["TEASER++"] = teaser
    else:
        print(PUBLISHED)
    print(HEAD, flush=True)
    rows = []
    for count in arguments.counts:
        for outliers in arguments.outliers:
            cases = [
                make_case(count, outliers, arguments.noise, seed, cloud)
                for seed in range(arguments.cases)
            ]
            for name, solve in solvers.items():
                answers = [(solve(case), case.truth) for case in cases]
                rows.append({"solver": name, "count": count, "outliers": outliers}
                            | summary(answers))  # fmt: skip
                print(line(rows[-1]), flush=True)
    if arguments.json:
        value = {"benchmark": "matches", "machine": machine.describe(("pyemtr", "numpy")),
                 "noise": arguments.noise, "cases": arguments.cases, "rows": rows}  # fmt: skip
        write_whole(arguments.json, json.dumps(value, indent=1) + "\n")
        print(f"wrote {arguments.json}")
    return int(any(row["solver"] == "emtr" and row["wrong"] for row in rows))


def summary(answers: list[tuple[Answer, Any]]) -> dict[str, float]:
    """Returns the figures of cases of one kind."""
    degrees = [rotation_error(answer.pose, truth) for answer, truth in answers]
    distances = [
        float(np.linalg.norm(answer.pose[:3, 3] - truth[:3, 3])) for answer, truth in answers
    ]
    right = [
        angle < RIGHT_DEGREES and distance < RIGHT_DISTANCE
        for angle, distance in zip(degrees, distances, strict=True)
    ]
    registered = [answer.registered for answer, _ in answers]
    return {
        "right": sum(right),
        "registered": sum(registered),
        "wrong": sum(r and not ok for r, ok in zip(registered, right, strict=True)),
        "cases": len(answers),
        "degrees": median(degrees),
        "distance": median(distances),
        "seconds": median(answer.seconds for answer, _ in answers),
    }


HEAD = (
    f"{'':<9}{'matches':>8}{'wrong %':>9}{'right':>9}{'registered':>12}{'wrong':>7}"
    f"{'degrees':>11}{'distance':>11}{'seconds':>10}"
)


def line(row: dict[str, Any]) -> str:
    right = f"{row['right']}/{row['cases']}"
    return (
        f"{row['solver']:<9}{row['count']:>8}{100 * row['outliers']:>9.1f}{right:>9}"
        f"{row['registered']:>12}{row['wrong']:>7}{row['degrees']:>11.3g}"
        f"{row['distance']:>11.3g}{row['seconds']:>10.4f}"
    )
