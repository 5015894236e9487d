"""tools/bench/stages: two neighbor structures, run by turns."""

import math

import numpy as np
from emtr_bench.stages import measure


def test_stages_alternate_and_tell_whether_the_bits_agree(monkeypatch):
    class Result:
        def __init__(self, seconds, x):
            self.timings = {"evolution": seconds}
            self.transformation = np.full((4, 4), x)

    seen = []

    def register(source, target, *, preset, threads, neighbors="grid"):
        seen.append(neighbors)
        slow = neighbors == "kdtree"
        return Result(2.0 * len(seen) if slow else 0.5, 1.0 + (1e-16 if slow else 0.0) + off)

    monkeypatch.setattr(measure.pyemtr, "register", register)
    off = 0.0
    found = measure.compare_structures(None, None, "paper", 2, 3)
    assert seen == ["grid", "kdtree"] * 3 and found["same_bits"]
    assert found["ratio"] == 16.0 and found["evolution"]["grid"]["median"] == 0.5
    seen.clear()
    pose_values = {"grid": 1.0, "kdtree": math.nextafter(1.0, 2.0)}
    monkeypatch.setattr(
        measure.pyemtr, "register",
        lambda *a, neighbors, **k: Result(1.0, pose_values[neighbors]),
    )  # fmt: skip
    assert not measure.compare_structures(None, None, "paper", 2, 1)["same_bits"]
