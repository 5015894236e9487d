"""What this machine does at most on one thread, as JSON on standard output: the best of several
runs of the plainest program of each kind, by numpy alone. A program of its own, because the
variables that keep numpy to one thread are read when numpy is loaded."""

from __future__ import annotations

import json
import time
from collections.abc import Callable

import numpy as np

REPETITIONS = 9
ROWS, BINS = 4500, 33  # descriptors of the dense clouds
GRID = 1 << 18  # entries of four bytes, as large as a second-level cache


def _best(job: Callable[[], object]) -> float:
    seconds = []
    for _ in range(REPETITIONS):
        start = time.perf_counter()
        job()
        seconds.append(time.perf_counter() - start)
    return min(seconds)


def rates() -> dict[str, float]:
    """Bytes read, descriptor pairs and nearest-neighbor queries a second."""
    random = np.random.default_rng(0)
    stream = random.random(1 << 23, dtype=np.float32)
    rows = random.random((2, ROWS, BINS), dtype=np.float32)
    product = np.empty((ROWS, ROWS), np.float32)
    table = random.random(GRID, dtype=np.float32)
    places = random.integers(0, GRID, 1 << 20)
    found = np.empty(places.size, np.float32)
    return {
        "bytes": stream.nbytes / _best(stream.max),
        "descriptor pairs": product.size
        / _best(lambda: np.matmul(rows[0], rows[1].T, out=product)),
        "queries": places.size / _best(lambda: table.take(places, out=found, mode="clip")),
    }


if __name__ == "__main__":
    print(json.dumps(rates()))
