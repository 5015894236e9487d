"""Settings by name: listed, checked, and none ignored in silence."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pyemtr
from pyemtr.options import make_settings, settings_used

ALL = pyemtr.settings()
CLOUD = np.random.default_rng(1).normal(size=(200, 3))
ROTATION = np.array([[0.0, 1.0, 0.0], [-0.6, 0.0, 0.8], [0.8, 0.0, 0.6]])


def used(**changes):
    return settings_used(make_settings("default", changes))


def test_every_setting_is_described():
    assert {"seed", "threads", "dense_points", "neighbors", "transfer"} <= set(ALL)
    for name, setting in ALL.items():
        assert setting.name == name and setting.text
        assert setting.type in ("integer", "real", "switch", "choice")
        assert setting.minimum <= setting.maximum
    assert isinstance(ALL["transfer"].default, bool)
    assert ALL["neighbors"].default in ALL["neighbors"].choices
    assert ALL["population"].default == 50 and isinstance(ALL["population"].default, int)


def test_the_defaults_are_the_default_preset():
    assert pyemtr.presets() == ["default", "fast", "thorough", "paper"]
    own = {
        "guess": None,
        "source_viewpoint": None,
        "target_viewpoint": None,
        "axis": None,
        "translation_bounds": None,
    }
    assert used() == {**{name: setting.default for name, setting in ALL.items()}, **own}
    problem = pyemtr.Problem(CLOUD, CLOUD)
    assert problem.settings == {**used(), "mesh_points": 100_000}


def test_the_paper_preset_is_the_method_as_published():
    paper = settings_used(make_settings("paper", {}))
    assert (paper["iterations"], paper["dense_points"], paper["sparse_points"]) == (100, 4000, 600)
    assert paper["seeds"] == paper["injected_seeds"] == paper["candidates"] == 0
    assert paper["fallback_search"] == "off" and paper["features"] == "pcl"
    assert paper["rotation_vector_steps"] == paper["arc_transfer"] == "off"
    assert paper["refine"] is paper["free_space"] is False


def test_swarms_step_in_their_own_way_where_no_particle_starts_at_a_seed():
    def pose(**changes):
        few = {"population": 8, "iterations": 12, "candidates": 0, "refine": False}
        options = {"fallback_search": "off", **few, **changes}
        return pyemtr.register(CLOUD, CLOUD[:150] @ ROTATION, seed=2, **options).transformation

    angles = {"rotation_vector_steps": "off", "arc_transfer": "off"}
    assert np.array_equal(pose(), pose(**angles))
    alone = pose(seeds=0)
    assert not np.array_equal(alone, pose(seeds=0, **angles))
    assert np.array_equal(
        alone, pose(seeds=0, rotation_vector_steps="always", arc_transfer="always")
    )
    for one in angles:
        assert not np.array_equal(alone, pose(seeds=0, **{one: "off"}))


@settings(max_examples=300, deadline=None)
@given(data=st.data(), name=st.sampled_from(sorted(set(ALL) - {"seed", "threads", "scale"})))
def test_a_value_in_range_is_kept_and_one_outside_is_refused(
    data, name
):  # a number for the scale is a factor
    setting = ALL[name]
    low, high = setting.minimum, setting.maximum
    if setting.type == "real":
        value = data.draw(st.floats(low, high))
        outside = [
            math.nextafter(low, -math.inf),
            math.nextafter(high, math.inf),
            math.nan,
            math.inf,
            -math.inf,
        ]
    else:
        value = data.draw(st.integers(int(low), int(high)))
        outside = [int(low) - 1, int(high) + 1, 2**63, -(2**40)]
    found = make_settings("default", {name: value}).get(name)
    assert found == value
    with pytest.raises(ValueError, match=name):
        used(**{name: data.draw(st.sampled_from(outside))})


@pytest.mark.parametrize(
    "name, value, stored",
    [
        ("neighbors", "kdtree", "kdtree"),
        ("neighbors", 2, "brute"),
        ("transfer", False, False),
        ("transfer", np.bool_(False), False),
        ("transfer", 0, False),
        ("population", np.int16(20), 20),
        ("tau_factor", np.float32(0.25), 0.25),
        ("tau_factor", 2, 2.0),
    ],
)
def test_python_values(name, value, stored):
    assert used(**{name: value})[name] == stored


@pytest.mark.parametrize(
    "name, value, error",
    [
        ("neighbors", "octree", ValueError),
        ("transfer", 2, ValueError),
        ("population", True, TypeError),
        ("tau_factor", True, TypeError),
        ("population", 20.5, TypeError),
        ("population", "20", TypeError),
        ("tau_factor", "0.5", TypeError),
        ("tau_factor", None, TypeError),
        ("tau_factor", 1j, TypeError),
        ("tau_factor", 10**400, ValueError),
        ("population", 10**400, ValueError),
        ("transfer", "yes", TypeError),
    ],
)
def test_bad_values_name_the_setting(name, value, error):
    with pytest.raises(error, match=name):
        pyemtr.register(CLOUD, CLOUD, **{name: value})


def test_an_unknown_setting_lists_close_ones():
    with pytest.raises(TypeError, match=r"populaton.*population"):
        pyemtr.register(CLOUD, CLOUD, populaton=20)
    with pytest.raises(TypeError, match=r"pyemtr.settings"):
        pyemtr.Problem(CLOUD, CLOUD, xyzzy=1)
    with pytest.raises(TypeError, match="did you mean source_viewpoint"):
        pyemtr.register(CLOUD, CLOUD, source_viewpiont=[0, 0, 0])


@pytest.mark.parametrize(
    "arguments, error, text",
    [
        ({"seed": -1}, ValueError, "seed"),
        ({"seed": 2**64}, ValueError, "seed"),
        ({"seed": 1.0}, TypeError, "seed"),
        ({"seed": "1"}, TypeError, "seed"),
        ({"seed": True}, TypeError, "seed"),
        ({"seed": None}, TypeError, "seed"),
        ({"threads": -1}, ValueError, "threads"),
        ({"threads": 1.5}, TypeError, "threads"),
        ({"threads": 2**40}, ValueError, "threads"),
        ({"preset": "papers"}, ValueError, "papers"),
        ({"preset": 3}, TypeError, "preset"),
        ({"guess": np.eye(3)}, ValueError, r"guess.*\(4, 4\).*\(3, 3\)"),
        ({"guess": np.full((4, 4), np.nan)}, ValueError, "guess"),
        ({"guess": 2 * np.eye(4)}, ValueError, "guess"),
        ({"guess": "identity"}, TypeError, "guess"),
        ({"source_viewpoint": [1, 2]}, ValueError, r"source_viewpoint.*\(3,\).*\(2,\)"),
        ({"target_viewpoint": np.zeros((1, 3))}, ValueError, r"target_viewpoint.*\(1, 3\)"),
        ({"source_viewpoint": [0, np.nan, 0]}, ValueError, "source_viewpoint.*NaN"),
        ({"target_viewpoint": [np.inf, 0, 0]}, ValueError, "target_viewpoint.*infinity"),
        ({"source_viewpoint": "here"}, TypeError, "source_viewpoint"),
        ({"target_viewpoint": [1j, 0, 0]}, TypeError, "target_viewpoint.*complex"),
        ({"source_viewpoint": True}, TypeError, "source_viewpoint.*bool"),
        ({"callback": 3}, TypeError, "callback"),
    ],
)
def test_bad_arguments_are_named(arguments, error, text):
    with pytest.raises(error, match=text):
        pyemtr.register(CLOUD, CLOUD, **arguments)


def test_contradictions_are_refused():
    with pytest.raises(ValueError, match="complement_scale"):
        pyemtr.register(CLOUD, CLOUD, complement_scale_start=0.1, complement_scale_end=0.2)
