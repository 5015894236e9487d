"""Registrations in this process under limits of memory: JSON on standard output.

peak POINTS: resident memory that a registration needs, in sizes of its input, input included.
limits PRESET THREADS: what becomes of a registration as the address space grows, a line for each
limit, and without a limit at last.
"""

from __future__ import annotations

import json
import resource
import sys
from pathlib import Path

import numpy as np
import shapes

import pyemtr

MEGABYTES = (0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 256)


def status(name: str) -> int:
    """Bytes of a line of /proc/self/status."""
    text = Path("/proc/self/status").read_text(encoding="ascii")
    return 1024 * int(text.split(f"{name}:")[1].split()[0])


def peak(points: int) -> float:
    rng = np.random.default_rng(3)
    small = shapes.make_pair(seed=1, count=3000)
    pyemtr.register(small.source, small.target)  # threads and code are in memory now
    source, target = (
        (np.repeat(cloud, points // len(cloud) + 1, axis=0)[:points]).astype(np.float32)
        for cloud in (small.source, small.target)
    )
    source += rng.normal(scale=0.002, size=(points, 1)).astype(np.float32)
    target += rng.normal(scale=0.002, size=(points, 1)).astype(np.float32)
    size = source.nbytes + target.nbytes
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")  # the peak is that of now
    before = status("VmRSS") - size
    pyemtr.register(source, target)
    return (status("VmHWM") - before) / size


def limits(preset: str, threads: int) -> None:
    pair = shapes.make_pair(seed=1, count=4000)
    used = status("VmSize")
    for megabytes in (*MEGABYTES, None):
        most = resource.RLIM_INFINITY if megabytes is None else used + (megabytes << 20)
        resource.setrlimit(resource.RLIMIT_AS, (most, resource.RLIM_INFINITY))
        try:
            result = pyemtr.register(pair.source, pair.target, preset=preset, threads=threads)
            outcome = {"transformation": result.transformation.ravel().tolist()}
        except MemoryError as error:
            outcome = {"error": str(error)}
        print(json.dumps({"megabytes": megabytes, **outcome}), flush=True)


if sys.argv[1] == "peak":
    print(peak(int(sys.argv[2])))
else:
    limits(sys.argv[2], int(sys.argv[3]))
