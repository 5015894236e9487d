"""The fraction of a run that is done: from 0 on, never back, whatever the settings skip."""

from __future__ import annotations

import pytest
from stages import STAGES

import pyemtr
from pyemtr.options import make_settings, settings_used
from pyemtr.progress import as_raw_callback


def fractions(steps, **changes) -> list[float]:
    seen: list[pyemtr.Progress] = []
    settings = settings_used(make_settings(changes.pop("preset", "default"), changes))
    raw = as_raw_callback(seen.append, settings)
    for stage, iteration in steps:
        raw(stage, iteration, 10, 0.0, 0.0)
    return [step.fraction for step in seen]


def in_order(absent=()) -> list[tuple[str, int]]:
    steps = []
    for stage in STAGES:
        if stage not in absent:
            steps += [(stage, i) for i in range(11)] if stage == "evolution" else [(stage, 0)]
    return steps


@pytest.mark.parametrize(
    "changes, absent",
    [
        ({}, {"fallback_search"}),
        ({"preset": "paper"}, {"seeds", "candidates", "fallback_search", "refinement"}),
        ({"preset": "thorough"}, set()),
        ({"refine": False}, {"fallback_search", "refinement"}),
        ({"candidates": 0}, {"candidates", "fallback_search"}),
    ],
)
def test_it_grows_from_0_to_nearly_1_in_steps_that_are_not_large(changes, absent) -> None:
    found = fractions(in_order(absent), **changes)
    assert found[0] == 0 and found == sorted(found) and 0.9 < found[-1] < 1
    largest = max(b - a for a, b in zip(found, found[1:]))
    assert largest < (0.9 if changes.get("preset") == "thorough" else 0.4)


def test_each_iteration_counts() -> None:
    found = fractions([("normalization", 0), *[("evolution", i) for i in range(11)]])
    assert len(set(found)) == 12


def test_a_fallback_search_and_a_second_look_do_not_go_back() -> None:
    again = [("fallback_search", 0), ("refinement", 0), ("verdict", 0)]
    found = fractions([*in_order(), *again])
    assert found == sorted(found) and found[-1] < 1


def test_a_problem_begins_at_0_though_stages_are_behind_it() -> None:
    steps = in_order(STAGES[:4])
    assert steps[0] == ("seeds", 0)
    found = fractions(steps)
    assert found[0] == 0 and found == sorted(found) and 0.9 < found[-1] < 1


def test_a_run_tells_it(pair) -> None:
    quick = {"iterations": 8, "threads": 2}
    problem = pyemtr.Problem(pair.source, pair.target, **quick)
    for run in (lambda c: pyemtr.register(pair.source, pair.target, callback=c, **quick),
                problem.solve):  # fmt: skip
        seen: list[pyemtr.Progress] = []
        run(seen.append)
        found = [step.fraction for step in seen]
        assert found[0] == 0 and found == sorted(found) and 0.5 < found[-1] < 1
