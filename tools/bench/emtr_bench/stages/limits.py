"""The least time that a registration's work could take on this machine, beside what it takes."""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import pyemtr

Array = NDArray[np.float64]
_ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS")


def limits(
    source: Array, target: Array, preset: str, repetitions: int, per_second: dict[str, float]
) -> dict[str, Any]:
    """One thread. A row for each kind of work that is counted: how much of it, the seconds that the
    machine needs for it at least, and the median seconds of the stage that does it."""
    found = [
        pyemtr.register(source, target, preset=preset, threads=1) for _ in range(repetitions + 1)
    ]
    result = found[0]
    work = {
        "bytes": ("normalization", source.nbytes + target.nbytes),
        "descriptor pairs": ("matching", result.dense_source * result.dense_target),
        "queries": ("evolution", sum(result.queries.values())),
    }
    rows = [
        {
            "kind": kind,
            "amount": amount,
            "stage": stage,
            "least": amount / per_second[kind],
            "reached": statistics.median(run.timings[stage] for run in found[1:]),
        }
        for kind, (stage, amount) in work.items()
    ]
    total = statistics.median(run.timings["total"] for run in found[1:])
    return {"preset": preset, "per_second": per_second, "rows": rows, "total": total}


def machine_rates() -> dict[str, float]:
    """What the machine does at most a second, by kind of work."""
    program = Path(__file__).with_name("machine_rates.py")
    done = subprocess.run(
        [sys.executable, str(program)],
        env={**os.environ, **dict.fromkeys(_ONE_THREAD, "1")},
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    return {name: float(value) for name, value in json.loads(done.stdout).items()}
