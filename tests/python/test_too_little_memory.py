"""Memory: how much a registration needs, and that too little of it is an error."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest
import shapes
from children import environment

import pyemtr


def child(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "memory_child", *arguments],
        cwd="/",
        env=environment(),
        text=True,
        capture_output=True,
        timeout=1800,
        check=False,
    )


@pytest.mark.parametrize("points, most", [(1500000, 7.0), (4000000, 3.0)])
def test_large_clouds_need_little_beside_themselves(points, most):
    """The search's own memory hardly grows with the input: below it only small clouds are."""
    done = child("peak", str(points))
    assert done.returncode == 0, done.stderr
    assert 1 <= float(done.stdout) < most


@pytest.mark.parametrize("threads", [1, 2, 32])
@pytest.mark.parametrize("preset", ["default", "paper"])
def test_too_little_memory_is_an_error_and_no_end(preset, threads):
    """`paper` computes its features by PCL; the stacks of 32 threads are beyond the limits."""
    done = child("limits", preset, str(threads))
    assert done.returncode == 0, (done.stdout, done.stderr)
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    failed = [line["megabytes"] for line in lines if "error" in line]
    assert 0 in failed and None not in failed
    assert all("memory" in line["error"] for line in lines if "error" in line)
    pair = shapes.make_pair(seed=1, count=4000)
    result = pyemtr.register(pair.source, pair.target, preset=preset, threads=2)
    for line in lines:  # however many threads there could be
        if "error" not in line:
            assert line["transformation"] == result.transformation.ravel().tolist()


def test_matches_beyond_the_cap_are_counted():
    pair = shapes.make_pair(seed=1, count=4000)
    few = pyemtr.register(pair.source, pair.target, preset="fast", max_correspondences=30)
    all_of_them = pyemtr.register(pair.source, pair.target, preset="fast")
    assert few.correspondences == 30 < few.correspondences_found
    assert few.correspondences_found == all_of_them.correspondences_found
    assert all_of_them.correspondences == all_of_them.correspondences_found
    pairs = few.correspondences * (few.correspondences - 1) // 2
    assert few.tims == pairs
    capped = pyemtr.register(pair.source, pair.target, preset="fast", max_tims=100)
    assert capped.tims == 91  # of 14 correspondences, as 15 would have 105
