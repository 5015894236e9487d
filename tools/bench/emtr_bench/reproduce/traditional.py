"""The traditional methods: PCL's by the program bench_traditional, Open3D's FGR by a child process
in the environment of tools/bench/peers. Which of them are there is found out once, and told.

All of them work on clouds of the same voxel, which leaves 6000 points in both together.
"""

from __future__ import annotations

import atexit
import json
import os
import subprocess
import tempfile
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from ..locations import REPOSITORY, TOOLS
from ..pairs import DataError, Pair
from ..peers.environment import FOLDER
from ..peers.voxel import voxel_size
from ..runner import Array, pose_errors
from .cases import moved_pair

VOXEL_POINTS = 6000
LIMIT = 300.0  # seconds of a run
OF_PCL = ("ICP+", "NDT+", "TrICP+")
FGR = "FGR"


def program() -> Path:
    build = Path(os.environ.get("EMTR_BUILD_DIR", REPOSITORY / "build"))
    return build / "tools" / "bench" / "bench_traditional"


def there() -> tuple[list[str], list[str]]:
    """The methods that can be run, and what to do for the others."""
    found, missing = [], []
    if program().is_file():
        found += OF_PCL
    else:
        missing.append(
            f"{', '.join(OF_PCL)}: no bench_traditional in the build; build it by cmake with "
            "-DEMTR_BUILD_BENCH=ON"
        )
    if any(FOLDER.glob("lib/python*/site-packages/open3d")):
        found.append(FGR)
    else:
        missing.append(f"{FGR}: no Open3D in build/venv-peers, which tools/bench/peers makes")
    return found, missing


def run(method: str, pair: Pair, index: int, seed: int) -> dict[str, Any]:
    """One run, with its errors; a method without a pose has none."""
    answer = _by_open3d(pair, index, seed) if method == FGR else _by_pcl(pair, index, seed)[method]
    T = np.array(answer["T"], dtype=np.float64).reshape(4, 4)
    figures: dict[str, Any] = {"seconds": answer["seconds"], "E_R": None, "E_t": None}
    if np.isfinite(T).all():
        u, _, vt = np.linalg.svd(T[:3, :3])
        T[:3, :3] = u @ vt  # PCL's floats are a little off
        figures["E_R"], figures["E_t"] = pose_errors(moved_pair(pair, index), T)
        figures["T"] = T.tolist()
    return figures


@lru_cache(maxsize=2)
def _by_pcl(pair: Pair, index: int, seed: int) -> dict[str, dict[str, Any]]:
    """The answers of all methods of PCL, which share the search."""
    case = moved_pair(pair, index)
    voxel = voxel_size(case.source, case.target, VOXEL_POINTS)
    with tempfile.TemporaryDirectory(prefix="reproduce-") as folder:
        files = [Path(folder, f"{name}.pcd") for name in ("source", "target")]
        # PCL's floats want coordinates that are not far from 0.
        center = case.target.mean(axis=0)
        for file, cloud in zip(files, (case.source - center, case.target - center)):
            write_pcd(file, cloud)
        line = f"{files[0]} {files[1]} {voxel:.9g} {seed}\n"
        done = subprocess.run([str(program())], input=line, capture_output=True, text=True,
                              check=False, timeout=LIMIT)  # fmt: skip
    if done.returncode != 0:
        raise DataError(f"{program()} failed with status {done.returncode}: {done.stderr.strip()}")
    answers = [json.loads(text) for text in done.stdout.splitlines()]
    away = np.eye(4)
    away[:3, 3] = center
    for answer in answers:
        T = np.array(answer["T"], dtype=np.float64).reshape(4, 4)
        answer["T"] = away @ T @ np.linalg.inv(away)
    return {answer["method"]: answer for answer in answers}


def write_pcd(path: Path, points: Array) -> None:
    """Points (n, 3) as binary PCD of floats."""
    n = len(points)
    head = (
        "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
        f"WIDTH {n}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {n}\nDATA binary\n"
    )
    path.write_bytes(head.encode() + points.astype("<f4").tobytes())


def _by_open3d(pair: Pair, index: int, seed: int) -> dict[str, Any]:
    case = moved_pair(pair, index)
    voxel = voxel_size(case.source, case.target, VOXEL_POINTS)
    with tempfile.TemporaryDirectory(prefix="reproduce-") as folder:
        file = Path(folder, "clouds.npz")
        np.savez(file, source=case.source, target=case.target)
        child = _child()
        assert child.stdin is not None and child.stdout is not None
        child.stdin.write(json.dumps({"file": str(file), "voxel": voxel, "seed": seed}) + "\n")
        child.stdin.flush()
        line = child.stdout.readline()
    if not line:
        raise DataError(f"Open3D's process ended with status {child.wait()}")
    answer: dict[str, Any] = json.loads(line)
    return answer


@lru_cache(maxsize=1)
def _child() -> subprocess.Popen[str]:
    """Open3D's process, one for all runs of this one."""
    script = ["-m", "emtr_bench.reproduce.open3d_child"]
    environment = {**os.environ, "PYTHONPATH": str(TOOLS / "bench"), "OMP_NUM_THREADS": "1"}
    child = subprocess.Popen([str(_open3d_python()), *script], stdin=subprocess.PIPE,
                             stdout=subprocess.PIPE, text=True, env=environment)  # fmt: skip
    atexit.register(child.kill)
    return child


def _open3d_python() -> Path:
    return FOLDER / "bin" / "python"
