"""Whatever clouds come in: an honest verdict, or a typed error that names the cloud."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import hostile_rows
import numpy as np
import pytest
from children import environment
from hostile_rows import ROWS, Refused
from hypothesis import HealthCheck, event, given, settings
from hypothesis import strategies as st

import pyemtr

LIBRARY = Path(os.environ.get("EMTR_BUILD_DIR", "build")) / "libemtr" / "libemtr.so"


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory) -> dict[str, dict[str, Any]]:
    """Returns the outcome of each row, in a process with limits of memory and time."""
    library = str(LIBRARY.resolve()) if LIBRARY.is_file() else "-"
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-m", "hostile_child", library],
        cwd=tmp_path_factory.mktemp("hostile"),
        env=environment(),
        text=True,
        capture_output=True,
        timeout=3600,
        check=False,
    )
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    ended = {line["name"]: line for line in lines if "name" in line}
    if done.returncode != 0:
        begun = lines[-1].get("begin", "the end") if lines else "its beginning"
        pytest.fail(f"the process ended with {done.returncode} at '{begun}': {done.stderr[-2000:]}")
    return ended


def rigid(values: list[float]) -> np.ndarray:
    matrix = np.reshape(values, (4, 4))
    assert np.isfinite(matrix).all()
    np.testing.assert_allclose(matrix[:3, :3] @ matrix[:3, :3].T, np.eye(3), atol=1e-9)
    assert np.linalg.det(matrix[:3, :3]) > 0
    return matrix


@pytest.mark.parametrize("name", ROWS)
def test_verdict_or_error(outcomes, name):
    row, found = ROWS[name], outcomes[name]["python"]
    if isinstance(row.expected, Refused):
        assert found.get("error") == row.expected.type, found
        assert re.search(row.expected.pattern, found["message"]), found
        return
    if "error" in found:  # only where the row says so
        assert "downsampled" in row.expected and "downsampled" in found["message"], found
        return
    assert found["reason"] in row.expected, found
    assert found["registered"] == (found["reason"] == "registered")
    assert 0 <= found["confidence"] <= 1
    matrix = rigid(found["transformation"])
    if row.pose is not None:
        np.testing.assert_allclose(matrix[:3, :3], row.pose[:3, :3], atol=0.02)
        np.testing.assert_allclose(matrix[:3, 3], row.pose[:3, 3], atol=0.02 * row.scale)


@pytest.mark.skipif(not LIBRARY.is_file(), reason=f"no {LIBRARY} (build it, or set EMTR_BUILD_DIR)")
def test_the_same_by_the_c_library(outcomes):
    both = {name: o for name, o in outcomes.items() if o["c"]}
    assert len(both) > 40
    for name, outcome in both.items():
        python, c = outcome["python"], outcome["c"]
        if "error" in python:
            assert c["message"] == python["message"] and c["status"] != 0, name
        else:
            assert c["transformation"] == python["transformation"], name
            assert c["registered"] == python["registered"], name


def test_the_table_is_as_long_as_promised():
    assert len(hostile_rows.ROWS) >= 60


RNG = np.random.default_rng(0)
SCENE = RNG.normal(size=(300, 3))
ANY = st.one_of(st.sampled_from([np.nan, np.inf, -np.inf]), st.floats(-3, 3), st.floats())
AXES = st.sampled_from(
    [[1, 1, 1], [1, 1, 0], [5, 1, 0.1], [1, 1e-6, 0], [1e100, 1, 1], [1e-100] * 3]
)


@st.composite
def clouds(draw):
    """Some of the scene, flattened or stretched or moved, with any numbers strewn in."""
    cloud = SCENE[: draw(st.sampled_from([300, 9, 10, 60, 120]))] * draw(AXES)
    cloud = cloud + draw(st.sampled_from([0.0, 1e6, -1e15]))
    for row, number in draw(st.lists(st.tuples(st.integers(0, len(cloud) - 1), ANY), max_size=4)):
        cloud[row, row % 3] = number
    return cloud


def answer(source, target):
    try:
        result = pyemtr.register(source, target, iterations=2, population=4, threads=1)
    except ValueError as error:
        assert "source" in str(error) or "target" in str(error)
        return None
    rotation = result.transformation[:3, :3]
    assert np.isfinite(result.transformation).all()
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-9)
    assert 0 <= result.fitness <= 1
    return result


@settings(max_examples=400, deadline=None, suppress_health_check=list(HealthCheck))
@given(source=clouds(), target=clouds())
def test_any_numbers_strewn_in(source, target):
    event("answered" if answer(source, target) else "refused")
