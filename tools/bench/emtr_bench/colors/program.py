"""Makes cases, solves them and prints; see the command's --help."""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Iterator
from statistics import median
from typing import Any

import numpy as np

from pyemtr.metrics import rotation_error

from .. import machine
from ..pair_arguments import asks_for_pairs
from ..pairs import DataError
from ..whole_file import write_whole
from .cases import case_of, none_right
from .own_pairs import own_pairs
from .scenes import Case
from .solvers import Answer, Solver, emtr_solver, open3d_solver

HEAD = (
    f"{'':<26}{'':<12}{'right':>7}{'registered':>12}{'wrong':>7}"
    f"{'degrees':>11}{'distance':>11}{'seconds':>9}  reasons"
)


def colors(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    if arguments.smoke:
        arguments.scenes, arguments.cases = [("wall", "parcel")], 1
        arguments.preset, arguments.solvers = "fast", ("off", "auto")
    solvers = solvers_of(arguments)
    print(HEAD, flush=True)
    try:
        rows = list(solve_all(solvers, arguments))
    except DataError as error:
        print(f"colors: {error}", file=sys.stderr)
        return 2
    if arguments.json:
        value = {"benchmark": "colors", "machine": machine.describe(("pyemtr", "numpy")),
                 "preset": arguments.preset, "cases": arguments.cases, "seed": arguments.seed,
                 "rows": rows}  # fmt: skip
        write_whole(arguments.json, json.dumps(value, indent=1) + "\n")
        print(f"wrote {arguments.json}")
    return int(any(row["solver"] in ("auto", "on") and row["wrong"] for row in rows))


def solvers_of(arguments: argparse.Namespace) -> dict[str, Solver]:
    """The solvers that the command line names; Open3D's only where it is installed."""
    out = {}
    for name in dict.fromkeys(arguments.solvers):
        solver = (
            open3d_solver(starts_true=name == "open3d-true")
            if name.startswith("open3d")
            else emtr_solver(arguments.preset, arguments.threads, name)
        )
        if solver:
            out[name] = solver
    return out


def solve_all(
    solvers: dict[str, Solver], arguments: argparse.Namespace
) -> Iterator[dict[str, Any]]:
    """A row for each scene and solver, printed as it is done."""
    for scene, has_pose, cases in all_cases(arguments):
        for name, solve in solvers.items():
            answers = [(solve(case), case) for case in cases]
            row = {"scene": scene, "solver": name, **summary(answers, has_pose)}
            print(line(row), flush=True)
            yield row


def all_cases(arguments: argparse.Namespace) -> Iterator[tuple[str, bool, list[Case]]]:
    """Makes the cases of one scene, or of one pair of the user's, after the other; each with its
    name and whether some pose is right."""
    if asks_for_pairs(arguments):
        for pair, cases in own_pairs(arguments):
            yield pair.name, pair.related, cases
        return
    seeds = range(arguments.seed, arguments.seed + arguments.cases)
    for scene in (name for names in arguments.scenes for name in names):
        yield scene, not none_right(scene), [case_of(scene, seed) for seed in seeds]


def summary(answers: list[tuple[Answer, Case]], has_pose: bool) -> dict[str, Any]:
    """Returns the figures of one scene, of which some pose is right or none. The errors are those
    of the right answers."""
    runs = [run_of(answer, case, has_pose) for answer, case in answers]
    of_right = [run for run in runs if run["right"]]
    return {
        "right": len(of_right),
        "right_registered": sum(run["registered"] for run in of_right),
        "registered": sum(run["registered"] for run in runs),
        "wrong": sum(run["registered"] and not run["right"] for run in runs),
        "cases": len(runs),
        "degrees": median(run["degrees"] for run in of_right) if of_right else float("nan"),
        "distance": median(run["distance"] for run in of_right) if of_right else float("nan"),
        "seconds": median(run["seconds"] for run in runs),
        "reasons": dict(Counter(run["reason"] for run in runs if run["reason"])),
        "runs": runs,
    }


def run_of(answer: Answer, case: Case, has_pose: bool) -> dict[str, Any]:
    """Returns what one answer was like."""
    degrees = rotation_error(answer.pose, case.truth)
    distance = float(np.linalg.norm(_center(case, answer.pose) - _center(case, case.truth)))
    right = degrees < case.degrees and distance < case.tolerance and has_pose
    return {"right": right, "registered": answer.registered, "reason": answer.reason,
            "degrees": float(degrees), "distance": distance, "seconds": answer.seconds,
            "evidence": answer.evidence}  # fmt: skip


def _center(case: Case, pose: Any) -> Any:
    """Where the middle of the source ends: its own origin may be far away."""
    return pose[:3, :3] @ case.source.mean(axis=0) + pose[:3, 3]


def line(row: dict[str, Any]) -> str:
    right = f"{row['right']}/{row['cases']}"
    reasons = ", ".join(f"{count} {reason}" for reason, count in row["reasons"].items())
    return (
        f"{row['scene']:<26}{row['solver']:<12}{right:>7}{row['registered']:>12}{row['wrong']:>7}"
        f"{row['degrees']:>11.3g}{row['distance']:>11.3g}{row['seconds']:>9.2f}  {reasons}"
    )
