"""Whatever cloud comes in: a finite pose, or a ValueError that names the cloud."""

import numpy as np
import pytest
from hypothesis import HealthCheck, event, given, settings
from hypothesis import strategies as st

import pyemtr

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


ODD = {
    "ten points": SCENE[:10],
    "a plane": SCENE * [1, 1, 0],
    "nearly a line": SCENE * [1, 1e-9, 1e-9],
    "two far clusters": np.vstack([SCENE[:150] * 1e-6, SCENE[150:] * 1e-6 + 1e6]),
    "one point far out": np.vstack([SCENE, [[1e9, 0, 0]]]),
    "all points twice": np.vstack([SCENE, SCENE]),
    "a lattice": np.stack(np.meshgrid(*[np.arange(7)] * 3), -1).reshape(-1, 3),
    "largest doubles": SCENE * 1e307,
    "thirty points": SCENE[:30],
    "small doubles": SCENE * 1e-100,
    "tiny doubles": SCENE * 1e-300,
    "denormals": SCENE * 1e-310,
    "far from the origin": SCENE + 1e12,
    "mostly NaN": np.vstack([SCENE[:40], np.full((4000, 3), np.nan)]),
}


@pytest.mark.parametrize("odd", ODD)
def test_odd_clouds(odd):
    answer(ODD[odd], ODD[odd])
    answer(ODD[odd], SCENE)
    answer(SCENE, ODD[odd])


@pytest.mark.parametrize(
    "odd",
    [
        "thirty points",
        "a plane",
        "all points twice",
        "a lattice",
        "far from the origin",
        "mostly NaN",
        "small doubles",
    ],
)
def test_some_odd_clouds_are_no_error(odd):
    assert answer(ODD[odd], ODD[odd]) is not None
