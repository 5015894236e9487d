"""One size of the scaling benchmark, in a process of its own: JSON in, JSON out."""

from __future__ import annotations

import json
import sys
import time
from typing import Any

import pyemtr
from pyemtr.metrics import rotation_error

from .bumpy_ball import ball_pair


def measure(points: int, seed: int, threads: int, repeat: int) -> dict[str, Any]:
    """The quickest of `repeat` registrations, and what the process has needed at most by then."""
    pair = ball_pair(points, seed)
    before = resident_bytes("VmHWM")
    best: dict[str, Any] = {}
    for _ in range(repeat):
        start = time.perf_counter()
        result = pyemtr.register(pair.source, pair.target, seed=seed, threads=threads)
        seconds = time.perf_counter() - start
        if not best or seconds < best["seconds"]:
            best = {"seconds": seconds, "stages": result.timings}
    peak = resident_bytes("VmHWM")

    # From here on nothing counts for the memory: how long it takes with both clouds kept.
    clouds = [pyemtr.Cloud(cloud, threads=threads) for cloud in (pair.source, pair.target)]
    kept = []
    for _ in range(repeat):
        start = time.perf_counter()
        pyemtr.register(*clouds, seed=seed, threads=threads)
        kept.append(time.perf_counter() - start)
    return {
        "points": points,
        "input_bytes": pair.bytes,
        "bytes_before": before,
        "peak_bytes": peak,
        "seconds_kept": min(kept),
        "registered": result.registered,
        "E_R": rotation_error(result.transformation, pair.T_true),
        "dense": result.dense_source + result.dense_target,
        "sparse": result.sparse_source,
        **best,
    }


def resident_bytes(name: str) -> int:
    """VmHWM (highest so far) or VmRSS (now). Unlike ru_maxrss, of this program alone: that one
    begins with what the parent had at the start."""
    with open("/proc/self/status", encoding="ascii") as status:
        for line in status:
            if line.startswith(f"{name}:"):
                return int(line.split()[1]) * 1024
    raise RuntimeError(f"/proc/self/status has no {name}")


if __name__ == "__main__":
    json.dump(measure(**json.loads(sys.argv[1])), sys.stdout)
