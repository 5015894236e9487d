"""Registers by pyemtr and prints the fields as JSON; runs as a program with the arguments
SOURCE.pcd TARGET.pcd THREADS SEED PRESET."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np

import pyemtr

from .clouds import Points
from .fields import Fields, of_result


def read_pcd(path: str) -> Points:
    _header, data = Path(path).read_bytes().split(b"DATA binary\n", 1)
    return np.frombuffer(data, "<f4").reshape(-1, 3)


def run(source: str, target: str, threads: int, seed: int, preset: str) -> Fields:
    clouds = read_pcd(source), read_pcd(target)
    result = pyemtr.register(*clouds, threads=threads, seed=seed, preset=preset)
    return of_result(result, result.residuals(*clouds))


if __name__ == "__main__":
    source, target, threads, seed, preset = sys.argv[1:]
    json.dump(run(source, target, int(threads), int(seed), preset), sys.stdout)
