"""No call keeps memory: a thousand registrations in one process leave it as large as it was."""

from __future__ import annotations

import os

import numpy as np
import pytest
import shapes

import pyemtr

PAGE = os.sysconf("SC_PAGE_SIZE")
QUICK = {"iterations": 2, "population": 4, "threads": 1}
LEAK = 200  # bytes a call; a transformation and its information are 416


def resident() -> int:
    """Bytes of this process that are in memory now."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * PAGE


class Stop(Exception):
    """Thrown out of a callback."""


def throw(_progress):
    raise Stop


@pytest.fixture(scope="module")
def tiny():
    pair = shapes.make_pair(seed=4)
    return pair.source[::60].copy(), pair.target[::60].copy()


def register(source, target):
    assert np.isfinite(pyemtr.register(source, target, **QUICK).transformation).all()


def preprocessed(source, target):
    clouds = pyemtr.Cloud(source), pyemtr.Cloud(target)
    for settings in (QUICK, {**QUICK, "preset": "fast"}):
        pyemtr.register(*clouds, **settings)


def stages(source, target):
    problem = pyemtr.Problem(source, target, **QUICK)
    assert np.isfinite(problem.evaluate_alpha(np.zeros((5, 6)))).all()
    problem.solve()


def user_provided(source, target):
    given = {
        "source_normals": source,
        "target_normals": target,
        "source_features": np.sin(source),
        "target_features": np.sin(target),
    }
    pyemtr.register(source, target, **given, **QUICK)
    rows = np.arange(20)
    for known in ({"axis": (0, 0, 1), "axis_tilt": 5}, {"guess": np.eye(4), "guess_rotation": 9}):
        pyemtr.register(
            source, target, correspondences=np.column_stack([rows, rows]), **known, **QUICK
        )


def residuals(source, target):
    result = pyemtr.register(source, target, **QUICK)
    for of in ("source", "target"):
        assert np.isfinite(result.residuals(source, target, of=of, threads=1)).all()


def refused(source, target):
    for clouds, settings in [
        ((source[:5], target), {}),
        ((source, target * np.nan), {}),
        ((source, target), {"population": -1}),
        ((source, target), {"source_features": source}),
        ((source, target), {"correspondences": [[0, 0]]}),
        ((source, target), {"axis": (0, 0, 0)}),
    ]:
        with pytest.raises(ValueError):
            pyemtr.register(*clouds, **{**QUICK, **settings})


def interrupted(source, target):
    pyemtr.register(source, target, callback=lambda p: p.stage == "evolution", **QUICK)
    with pytest.raises(Stop):
        pyemtr.register(source, target, callback=throw, **QUICK)


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="needs Linux's /proc")
@pytest.mark.parametrize(
    ("call", "calls"),
    [
        (register, 1000),
        (preprocessed, 250),
        (stages, 250),
        (user_provided, 350),
        (residuals, 500),
        (refused, 1000),
        (interrupted, 500),
    ],
)
def test_no_growth(tiny, call, calls):
    # The allocator's own pools and whatever is made once are there after the first tenth. What is
    # left is counted in quarters: fragmentation comes in jumps, a leak in each of them.
    for _ in range(max(20, calls // 10)):
        call(*tiny)
    growth = []
    for _ in range(4):
        before = resident()
        for _ in range(calls // 4):
            call(*tiny)
        growth.append((resident() - before) / (calls // 4))
    assert min(growth) < LEAK, f"bytes a call in four quarters: {growth}"
