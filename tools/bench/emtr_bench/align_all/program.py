"""Aligns the scenes and prints; see the command's --help."""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import asdict
from typing import Any

from .. import machine
from ..data import chosen
from ..pairs import DataError
from ..whole_file import write_whole
from .edges import measure_edges
from .judge import judge
from .large import large
from .methods import Method, method, threads_or_all
from .scenes import Scene, generated, scenes_of
from .swarm import compare

HEAD = (
    f"{'scene':<24}{'method':<8}{'scans':>6}{'judged':>8}{'precise':>9}{'right':>7}{'wrong':>7}"
    f"{'degrees':>9}{'radii':>9}{'seconds':>9}{'cpu':>9}"
)


def align_all(arguments: argparse.Namespace) -> int:
    """Does what the command line says; gives the exit code."""
    if arguments.large:
        return large(arguments)
    if arguments.swarm:
        return compare(arguments)
    try:
        scenes = scenes_to_align(arguments)
    except DataError as error:
        print(f"align_all: {error}", file=sys.stderr)
        return 2
    if arguments.edges:
        return measure_edges(scenes, arguments)
    methods: dict[str, Method] = {}
    for name in arguments.method:
        found = method(name)
        if found is None:
            print(f"{name}: its package is not installed, so it is left out")
        else:
            methods[name] = found
    if not methods:
        print("align_all: none of the methods is installed", file=sys.stderr)
        return 2
    print(HEAD, flush=True)
    rows = []
    for scene in scenes:
        for name, align in methods.items():
            rows.append(one_row(scene, name, align, arguments))
            print(line(rows[-1]), flush=True)
    for name in methods:
        print(line(total([row for row in rows if row["method"] == name])))
    if arguments.json:
        value = {
            "benchmark": "align_all",
            "machine": machine.describe(("pyemtr", "numpy", "gtsam")),
            "seed": arguments.seed,
            "rows": rows,
        }
        write_whole(arguments.json, json.dumps(value, indent=1) + "\n")
        print(f"wrote {arguments.json}")
    return int(any(row["method"] == "emtr" and row["wrong"] for row in rows))


def scenes_to_align(arguments: argparse.Namespace) -> list[Scene]:
    """The scenes of the command line. Raises DataError where there are none."""
    if arguments.smoke:
        return [generated(arguments.seed, {1: 3, 2: 3, 3: 1})]
    scenes = list(scenes_of(chosen(arguments), arguments.seed))
    known = {scene.name for scene in scenes}
    for name in arguments.scene or []:
        if name not in known:
            raise DataError(f"--scene {name}: no such scene; there are {', '.join(sorted(known))}")
    if not scenes:
        raise DataError("the chosen pairs have no three scans of one thing")
    return [scene for scene in scenes if not arguments.scene or scene.name in arguments.scene]


def one_row(
    scene: Scene, name: str, align: Method, arguments: argparse.Namespace
) -> dict[str, Any]:
    answer = align(scene, threads_or_all(arguments.threads), arguments.seed)
    judged = judge(scene, answer.poses, answer.models)
    placed = sum(model is not None for model in answer.models)
    row = {"scene": scene.name, "method": name, "count": len(scene.clouds), "placed": placed}
    return {**row, **asdict(judged), "seconds": answer.seconds,
            "cpu": answer.cpu}  # fmt: skip


def total(rows: list[dict[str, Any]]) -> dict[str, Any]:
    names = ("count", "scans", "precise", "right", "wrong", "seconds", "cpu")
    sums = {name: sum(row[name] for row in rows) for name in names}
    nothing = float("nan")
    return {"scene": "all", "method": rows[0]["method"], **sums, "degrees": nothing,
            "radii": nothing}  # fmt: skip


def line(row: dict[str, Any]) -> str:
    share = 100 / max(row["scans"], 1)
    return (
        f"{row['scene']:<24}{row['method']:<8}{row['count']:>6}{row['scans']:>8}"
        f"{share * row['precise']:>8.1f}%{share * row['right']:>6.0f}%{row['wrong']:>7}"
        f"{row['degrees']:>9.3f}{row['radii']:>9.4f}{row['seconds']:>9.2f}{row['cpu']:>9.2f}"
    )
