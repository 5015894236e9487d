"""Makes cases, solves them and prints; see the command's --help."""

from __future__ import annotations

import argparse
import json
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from statistics import median
from typing import Any

import numpy as np

from pyemtr.metrics import rotation_error

from .. import machine
from ..whole_file import write_whole
from .scenes import SCENES, Case, floor, wall
from .solvers import Answer, Solver, emtr_solver, open3d_solver

RIGHT_DEGREES, RIGHT_DISTANCE = 1.0, 0.02
#: Scenes in which no pose is right.
NONE_RIGHT = ("unrelated", "unmarked")

HEAD = (
    f"{'':<11}{'':<15}{'right':>7}{'registered':>12}{'wrong':>7}"
    f"{'degrees':>11}{'meters':>11}{'seconds':>9}  reasons"
)


def colors(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    if arguments.smoke:
        arguments.scenes, arguments.cases, arguments.preset = ("wall", "box"), 1, "fast"
    solvers = {
        "emtr, shape": emtr_solver(arguments.preset, arguments.threads, "off"),
        "emtr, colors": emtr_solver(arguments.preset, arguments.threads, "auto"),
    }
    open3d = None if arguments.smoke else open3d_solver()
    if open3d:
        solvers["Open3D"] = open3d
    print(HEAD, flush=True)
    rows = list(solve_all(solvers, arguments))
    if arguments.json:
        value = {"benchmark": "colors", "machine": machine.describe(("pyemtr", "numpy")),
                 "preset": arguments.preset, "cases": arguments.cases, "rows": rows}  # fmt: skip
        write_whole(arguments.json, json.dumps(value, indent=1) + "\n")
        print(f"wrote {arguments.json}")
    return int(any(row["solver"] == "emtr, colors" and row["wrong"] for row in rows))


def case_of(scene: str, seed: int) -> Case:
    if scene == "unmarked":
        return floor(seed, marks=0)
    if scene == "unrelated":
        one, other = wall(seed), wall(seed + 1000)
        return replace(one, target=other.target, target_colors=other.target_colors)
    return SCENES[scene](seed)


def solve_all(
    solvers: dict[str, Solver], arguments: argparse.Namespace
) -> Iterator[dict[str, Any]]:
    """A row for each scene and solver, printed as it is done."""
    for scene in arguments.scenes:
        cases = [case_of(scene, seed) for seed in range(arguments.cases)]
        for name, solve in solvers.items():
            answers = [(solve(case), case) for case in cases]
            row = {"scene": scene, "solver": name, **summary(answers, scene)}
            print(line(row), flush=True)
            yield row


def summary(answers: list[tuple[Answer, Case]], scene: str) -> dict[str, Any]:
    """Returns the figures of one scene. The errors are those of the right answers."""
    errors = [
        (
            rotation_error(answer.pose, case.truth),
            float(np.linalg.norm(_center(case, answer.pose) - _center(case, case.truth))),
        )
        for answer, case in answers
    ]
    right = [
        degrees < RIGHT_DEGREES and meters < RIGHT_DISTANCE and scene not in NONE_RIGHT
        for degrees, meters in errors
    ]
    registered = [answer.registered for answer, _ in answers]
    of_right = [error for error, ok in zip(errors, right) if ok]
    return {
        "right": sum(right),
        "registered": sum(registered),
        "wrong": sum(r and not ok for r, ok in zip(registered, right)),
        "cases": len(answers),
        "degrees": median(degrees for degrees, _ in of_right) if of_right else float("nan"),
        "meters": median(meters for _, meters in of_right) if of_right else float("nan"),
        "seconds": median(answer.seconds for answer, _ in answers),
        "reasons": dict(Counter(answer.reason for answer, _ in answers if answer.reason)),
    }


def _center(case: Case, pose: Any) -> Any:
    """Where the middle of the source ends: its own origin may be far away."""
    return pose[:3, :3] @ case.source.mean(axis=0) + pose[:3, 3]


def line(row: dict[str, Any]) -> str:
    right = f"{row['right']}/{row['cases']}"
    reasons = ", ".join(f"{count} {reason}" for reason, count in row["reasons"].items())
    return (
        f"{row['scene']:<11}{row['solver']:<15}{right:>7}{row['registered']:>12}{row['wrong']:>7}"
        f"{row['degrees']:>11.3g}{row['meters']:>11.3g}{row['seconds']:>9.2f}  {reasons}"
    )
