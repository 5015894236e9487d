"""python -m bit_table.python_run SOURCE.pcd TARGET.pcd THREADS SEED PRESET: fields as JSON."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np

import pyemtr

from .clouds import Points
from .fields import of_result


def read_pcd(path: str) -> Points:
    _header, data = Path(path).read_bytes().split(b"DATA binary\n", 1)
    return np.frombuffer(data, "<f4").reshape(-1, 3)


if __name__ == "__main__":
    source, target, threads, seed, preset = sys.argv[1:]
    result = pyemtr.register(
        read_pcd(source), read_pcd(target), threads=int(threads), seed=int(seed), preset=preset
    )
    json.dump(of_result(result), sys.stdout)
