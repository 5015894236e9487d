"""Registers a generated pair and prints the bits of the result; run where a wheel is installed.

    python registered_pair.py [PICTURE]   plots the pair too, before and after

The clouds are made by Python's own arithmetic, which is the same everywhere; numpy's sine is not.
"""

import json
import random
import sys

import numpy as np

import pyemtr

COUNT = 6000
ROTATION = ((0.36, 0.48, -0.8), (-0.8, 0.6, 0.0), (0.48, 0.64, 0.6))  # of the target's points
TRANSLATION = (5.0, 6.0, 7.0)


def surface(generator: random.Random) -> "list[float]":
    x, y = generator.uniform(-1, 1), generator.uniform(-1, 1)
    peak = 0.25 / (1 + 25 * ((x - 0.3) * (x - 0.3) + y * y))
    return [x, y, 0.3 * x * x * y + 0.2 * y * y * x + 0.25 * x * x + peak]


def moved(point: "list[float]") -> "list[float]":
    return [
        sum(ROTATION[row][k] * point[k] for k in range(3)) + TRANSLATION[row] for row in range(3)
    ]


def pair() -> "tuple[np.ndarray, np.ndarray]":
    """Returns source and target: 70 % of the one surface each, drawn anew, and the source moved."""
    generator = random.Random(1)
    points = [surface(generator) for _ in range(2 * COUNT)]
    source = [moved(point) for point in points[:COUNT] if point[0] > -0.6]
    target = [point for point in points[COUNT:] if point[0] < 0.6]
    return np.array(source), np.array(target)


def error(transformation: np.ndarray) -> float:
    """Returns the largest difference between the rotation found and the true one."""
    return float(np.abs(transformation[:3, :3] - np.array(ROTATION).T).max())


def main() -> None:
    source, target = pair()
    result = pyemtr.register(source, target, seed=3, threads=2)
    assert result.registered, result.reason
    assert error(result.transformation) < 0.02, result.transformation
    by_pcl = pyemtr.register(source, target, seed=3, features="pcl", threads=2)
    if len(sys.argv) > 1:
        from pyemtr.plot import plot_alignment

        plot_alignment(source, target, result.transformation, sys.argv[1])
    bits = [
        float(number).hex()
        for each in (result, by_pcl)
        for number in [*each.transformation.ravel(), each.confidence, each.score]
    ]
    print(json.dumps({"version": pyemtr.__version__, "kernel": result.kernel, "bits": bits}))


if __name__ == "__main__":
    main()
