"""tools/bench/stages: two neighbor structures, run by turns."""

import math

import numpy as np
import shapes
from emtr_bench.stages import limits, measure

import pyemtr


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


def test_limits_count_the_work_and_take_the_stage_that_does_it():
    pair = shapes.make_pair(1, count=2000)
    source, target = pair.source, pair.target
    found = limits.limits(source, target, "fast", 1, limits.machine_rates())
    rows = {row["kind"]: row for row in found["rows"]}
    result = pyemtr.register(source, target, preset="fast", threads=1)
    assert rows["bytes"]["amount"] == 24 * (len(source) + len(target))
    assert rows["descriptor pairs"]["amount"] == result.dense_source * result.dense_target
    assert rows["queries"]["amount"] == sum(result.queries.values())
    for kind, row in rows.items():
        assert row["least"] == row["amount"] / found["per_second"][kind] > 0
        assert 0 < row["reached"] <= found["total"]
