"""A site of many large scans, made on the fly: what aligning it takes of memory and time.

The ground of the site has bumps in random places. The scanner stands along a closed way and sees
the ground around it. Each scan is a file and has a frame of its own. The alignment is the work of
a process of its own, so that its largest resident memory is that of nothing else.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import numpy as np

from .. import machine
from ..pairs import Array
from ..whole_file import write_whole
from .judge import PRECISE, RIGHT, within_limits
from .scenes import random_rotation

_REACH = 10.0  # m that a scan sees
_STEP = 6.0  # m between two places along the way
_BUMPS = 0.35  # a square meter
_NOISE = 0.01  # m
_RASTER = 0.05  # m, of the ground


def large(arguments: argparse.Namespace) -> int:
    """Makes the scans, aligns them, and prints; gives the exit code."""
    with tempfile.TemporaryDirectory(dir=arguments.folder) as name:
        folder = Path(name)
        begin = perf_counter()
        truth = write_site(folder, arguments.large, arguments.points, arguments.seed)
        print(f"made {arguments.large} scans of {arguments.points} points in "
              f"{perf_counter() - begin:.0f} s", flush=True)  # fmt: skip
        words = [sys.executable, "-m", "emtr_bench.align_all.large", str(folder)]
        words += [str(arguments.seed), str(arguments.threads or 0)]
        # In the folder, so that the packages are those of this process and no sources nearby.
        places = os.pathsep.join(place for place in sys.path if place)
        child = subprocess.run(
            words, stdout=subprocess.PIPE, text=True, check=False, cwd=folder,
            env={**os.environ, "PYTHONPATH": places},
        )  # fmt: skip
    if child.returncode:
        print("align_all: the alignment failed", file=sys.stderr)
        return 2
    found = json.loads(child.stdout)
    row = {"scans": arguments.large, "points": arguments.points, **judged(found, truth)}
    row.update({name: found[name] for name in ("seconds", "cpu", "megabytes", "stages", "pairs")})
    print(
        f"{row['placed']} of {row['scans']} scans placed in {row['models']} models, largest of"
        f" {row['largest']}; {row['precise']} precise, {row['right']} right, {row['wrong']} wrong;"
        f" {row['pairs']} pairs; {row['seconds']:.0f} s, {row['cpu']:.0f} s of CPU,"
        f" {row['megabytes']:.0f} MB at most"
    )
    for stage, seconds in row["stages"].items():
        print(f"  {stage}: {seconds:.0f} s")
    if arguments.json:
        value = {"benchmark": "align_all --large", "seed": arguments.seed, "row": row,
                 "machine": machine.describe(("pyemtr", "numpy", "gtsam"))}  # fmt: skip
        write_whole(arguments.json, json.dumps(value, indent=1) + "\n")
        print(f"wrote {arguments.json}")
    return int(row["wrong"] > 0)


def write_site(folder: Path, scans: int, points: int, seed: int) -> list[Array]:
    """Writes the scans as float32 arrays; returns their true poses, scan -> site."""
    rng = np.random.default_rng([seed, scans])
    radius = scans * _STEP / (2 * np.pi)
    half = radius + _REACH + 3
    bumps = rng.uniform(-half, half, (int(_BUMPS * 4 * half**2), 2))
    heights = rng.uniform(0.2, 1.4, len(bumps)) * rng.choice([-1, 1], len(bumps))
    widths = rng.uniform(0.4, 1.3, len(bumps))
    poses = []
    for k in range(scans):
        angle = 2 * np.pi * k / scans
        place = radius * np.array([np.cos(angle), np.sin(angle)])
        far, turn = _REACH * np.sqrt(rng.uniform(size=points)), rng.uniform(0, 2 * np.pi, points)
        at = place + far[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
        near = np.linalg.norm(bumps - place, axis=1) < _REACH + 4
        z = ground(at, place, bumps[near], heights[near], widths[near])
        z += rng.normal(scale=_NOISE, size=points)
        pose = np.eye(4)
        pose[:3, :3] = random_rotation(rng)
        pose[:3, 3] = [*place, 2.0]
        scan = (np.column_stack([at, z]) - pose[:3, 3]) @ pose[:3, :3]
        np.save(folder / f"scan_{k:04d}.npy", scan.astype(np.float32))
        poses.append(pose)
    return poses


def ground(at: Array, place: Array, bumps: Array, heights: Array, widths: Array) -> Array:
    """The heights (N,) at places (N, 2): between the nodes of a raster that all scans share."""
    low = np.floor((place - _REACH) / _RASTER) - 1
    nodes = np.arange(int(2 * _REACH / _RASTER) + 4)
    x, y = ((low[axis] + nodes) * _RASTER for axis in range(2))
    rows, columns = (
        np.exp(-((line[:, None] - bumps[:, axis]) ** 2) / widths**2)
        for axis, line in enumerate((x, y))
    )
    height = (rows * heights) @ columns.T
    cell = np.clip(np.floor(at / _RASTER - low).astype(np.int64), 0, len(nodes) - 2)
    (i, j), (u, v) = cell.T, (at / _RASTER - low - cell).T
    upper = (1 - v) * height[i, j] + v * height[i, j + 1]
    lower = (1 - v) * height[i + 1, j] + v * height[i + 1, j + 1]
    return np.asarray((1 - u) * upper + u * lower)


def judged(found: dict[str, Any], truth: list[Array]) -> dict[str, int]:
    """Counts scans against the first one of their model. A scan whose neighbors along the way are
    placed precisely and that drifts with them is not right either."""
    counts = {"placed": 0, "precise": 0, "right": 0, "wrong": 0, "largest": 0}
    for members in found["models"]:
        counts["placed"] += len(members)
        counts["largest"] = max(counts["largest"], len(members))
        first = members[0]
        for scan in members:
            wanted = np.linalg.inv(truth[first]) @ truth[scan]
            apart = np.linalg.inv(wanted) @ np.array(found["poses"][scan])
            error = _degrees(apart), float(np.linalg.norm(apart[:3, 3])) / _REACH
            counts["precise"] += within_limits(error, PRECISE)
            counts["right"] += within_limits(error, RIGHT)
            counts["wrong"] += not within_limits(error, RIGHT)
    return {"models": len(found["models"]), **counts}


def _degrees(pose: Array) -> float:
    return float(np.degrees(np.arccos(np.clip((np.trace(pose[:3, :3]) - 1) / 2, -1, 1))))


def align(folder: Path, seed: int, threads: int) -> dict[str, Any]:
    """Aligns the scans of a folder; returns the poses and what it took."""
    import pyemtr

    begin, cpu = perf_counter(), process_time()
    stages: dict[str, float] = {}
    last = ["", begin]

    def told(stage: str, done: int, count: int) -> None:
        now = perf_counter()
        if stage != last[0]:
            if last[0]:
                stages[str(last[0])] = now - float(last[1])
            last[:] = [stage, now]

    result = pyemtr.align_all(folder, seed=seed, threads=threads, callback=told)
    stages[str(last[0])] = perf_counter() - float(last[1])
    return {
        "models": result.models,
        "poses": [scan.pose.tolist() for scan in result.scans],
        "pairs": len(result.edges),
        "seconds": perf_counter() - begin,
        "cpu": process_time() - cpu,
        "megabytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
        "stages": stages,
    }


if __name__ == "__main__":
    json.dump(align(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])), sys.stdout)
