"""The result does not depend on the order of points, the frames, the unit, or on which cloud is the
source.

The result, taken back to the original clouds, moves by less than a tolerance: that of rounding for
order, that of another voxel grid for another frame and for another unit, whose leaf is another rung
of the ladder. In degrees, and in radii where the source's centroid ends up.
"""

from __future__ import annotations

import functools
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
import shapes
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import pyemtr
from pyemtr.metrics import rotation_error

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from reproducibility_matrix import clouds

ROUNDING = (1e-3, 1e-5)
OTHER_GRID = (0.3, 0.005)
SWAPPED = (0.05, 0.001)
REAL = ["stanford/bunny_045_000", "uwa/trex_03_01", "lidar/kitti_05_00"]
examples = functools.partial(
    settings, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
)
seeds = st.integers(0, 2**32 - 1)


class Case(NamedTuple):
    source: np.ndarray  # float64 (n, 3)
    target: np.ndarray
    result: pyemtr.Result


def case_of(source, target) -> Case:
    source, target = np.asarray(source, float), np.asarray(target, float)
    result = pyemtr.register(source, target)
    assert result.registered and result.confidence > 0.9  # else nothing is promised
    return Case(source, target, result)


@functools.cache
def shape(number: int) -> Case:
    pair = shapes.make_pair(number, count=5000)
    return case_of(pair.source, pair.target)


@pytest.fixture(scope="module", params=REAL)
def real(request, data_dir) -> Case:
    pytest.importorskip("plyfile")
    return case_of(*clouds.load(request.param, data_dir))


cases = st.builds(shape, st.integers(1, 3))


def expect_near(case: Case, transformation, tolerance) -> None:
    angle, offset = tolerance
    wanted = case.result.transformation
    center = np.append(case.result.center_source, 1)
    assert rotation_error(transformation, wanted) < angle  # degrees
    moved = (
        np.linalg.norm(((transformation - wanted) @ center)[:3]) / case.result.normalization_scale
    )
    assert moved < offset


def permuted(case: Case, seed: int) -> None:
    rng = np.random.default_rng(seed)
    result = pyemtr.register(rng.permutation(case.source), rng.permutation(case.target))
    assert result.registered
    expect_near(case, result.transformation, ROUNDING)


def moved(case: Case, seed: int) -> None:
    rng = np.random.default_rng(seed)
    reach = 3 * case.result.normalization_scale
    A, B = shapes.random_transformation(rng, reach), shapes.random_transformation(rng, reach)
    result = pyemtr.register(shapes.apply(A, case.source), shapes.apply(B, case.target))
    assert result.registered
    expect_near(case, np.linalg.inv(B) @ result.transformation @ A, OTHER_GRID)


def in_another_unit(case: Case, unit: float, tolerance=OTHER_GRID) -> None:
    result = pyemtr.register(case.source * unit, case.target * unit)
    transformation = result.transformation.copy()
    transformation[:3, 3] /= unit
    assert result.registered
    expect_near(case, transformation, tolerance)


def far_away(case: Case, offset: float) -> None:
    result = pyemtr.register(case.source + offset, case.target + offset)
    translation = np.eye(4)
    translation[:3, 3] = offset
    assert result.registered
    expect_near(case, np.linalg.inv(translation) @ result.transformation @ translation, ROUNDING)


def swapped(case: Case) -> None:
    result = pyemtr.register(case.target, case.source)
    assert result.registered
    expect_near(case, np.linalg.inv(result.transformation), SWAPPED)


@examples(max_examples=6)
@given(cases, seeds)
def test_the_order_of_the_points(case, seed):
    permuted(case, seed)


@examples(max_examples=10)
@given(cases, seeds)
def test_the_frames_of_the_clouds(case, seed):
    moved(case, seed)


@examples(max_examples=6)
@given(cases, st.floats(-3, 3))
def test_the_unit(case, power):
    in_another_unit(case, 10.0**power)


@examples(max_examples=4)
@given(cases, st.integers(-30, 30))
def test_a_unit_with_the_same_rungs(case, octaves):
    in_another_unit(case, 2.0**octaves, ROUNDING)


@examples(max_examples=4)
@given(cases, st.sampled_from([5e5, -5e5, 1e4]))
def test_coordinates_far_from_the_origin(case, offset):
    far_away(case, offset)


@pytest.mark.parametrize("number", [1, 2, 3])
def test_which_cloud_is_the_source(number):
    swapped(shape(number))


def test_real_clouds(real):
    permuted(real, 1)
    moved(real, 2)
    in_another_unit(real, 1e-3)
    in_another_unit(real, 1e3)
    far_away(real, 5e5)
    swapped(real)
