"""What is known of the pose, on the command line and in the report."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
from conftest import QUICK, ROOT


@pytest.fixture
def found(run, tmp_path):
    """Returns the report of a run."""

    def call(*arguments) -> dict:
        done = run(*arguments, "--report", "r.json")
        assert done.returncode in (0, 3), done.stderr
        return json.loads((tmp_path / "r.json").read_text())

    return call


def test_unknown_unless_given(found, small):
    report = found(*small, *QUICK)
    assert report["axis"] is None and report["translation_bounds"] is None
    assert report["settings"]["guess_rotation"] == report["settings"]["maximum_rotation"] == 180


def test_the_report_has_what_was_given(found, small):
    given = ["--axis", "0", "-1e-1", "2", "--axis-tilt", "3", "--axis-angle-minimum", "-20"]
    bounds = ["--translation-bounds", "-1", "-2", "-3", "1", "2", "3e0"]
    report = found(*small, *QUICK, *given, *bounds, "--maximum-rotation", "90")
    assert report["axis"] == [0, -0.1, 2]
    assert report["translation_bounds"] == [[-1, -2, -3], [1, 2, 3]]
    assert report["settings"]["axis_tilt"] == 3
    assert report["settings"]["axis_angle_minimum"] == -20
    t = np.array(report["transformation"])[:3, 3]
    assert (np.abs(t) <= [1 + 1e-9, 2 + 1e-9, 3 + 1e-9]).all()


def test_they_act(found, clouds, pair, tmp_path):
    axis = ["--axis", "1", "2", "-1"]  # of the pair's own rotation
    assert found(*clouds, *axis)["registered"]
    R = np.array(found(*clouds, *axis, "--maximum-rotation", "30")["transformation"])[:3, :3]
    assert np.degrees(np.arccos((np.trace(R) - 1) / 2)) <= 30 + 1e-6
    assert not found(*clouds, "--axis", "0", "0", "1")["registered"]

    np.savetxt(tmp_path / "guess.txt", pair.T)
    near = ["--guess", "guess.txt", "--guess-rotation", "10", "--guess-translation", "0.2"]
    assert found(*clouds, *near)["registered"]


@pytest.mark.parametrize(
    ("arguments", "pattern"),
    [
        (["--axis", "0", "0"], "--axis"),
        (["--axis", "0", "0", "up"], "--axis: 'up' is not a finite number, expected X Y Z"),
        (["--axis", "0", "0", "0"], "'axis' is no direction"),
        (["--translation-bounds", "0", "0", "0", "1", "1"], "--translation-bounds"),
        (["--translation-bounds", "0", "0", "0", "1", "inf", "1"], "'inf' is not a finite number"),
        (["--translation-bounds", "0", "0", "2", "1", "1", "1"], "the minimum of z"),
        (["--axis-tilt", "5"], "'axis_tilt' says nothing without 'axis'"),
        (["--guess-rotation", "5"], "'guess_rotation' says nothing without 'guess'"),
        (["--maximum-rotation", "181"], "--maximum-rotation: '181' is not a number from 0 to 180"),
        (
            ["--axis", "0", "0", "1", "--axis-angle-minimum", "60", "--maximum-rotation", "50"],
            "'axis' and 'maximum_rotation' contradict each other",
        ),
    ],
)
def test_refused(refused, small, arguments, pattern):
    assert re.search(pattern, refused(1, *small, *arguments))


def floor_plan(rng: np.random.Generator) -> np.ndarray:
    """Walls of two rooms with a slanted corner and a niche; all z are 0."""
    corners = [[(0, 0), (9, 0), (9, 5), (6, 5), (6, 7), (1, 7), (0, 5.5), (0, 0)], [(4, 0), (4, 4)]]
    walls = [
        np.array(a) + rng.uniform(size=(300, 1)) * (np.array(b) - a)
        for line in corners
        for a, b in zip(line, line[1:])
    ]
    points = np.vstack(walls)
    points += rng.normal(scale=0.005, size=points.shape)
    return np.column_stack([points, np.zeros(len(points))])


def test_two_dimensions_as_the_page_says(found, tmp_path):
    page = (ROOT / "docs" / "PRIORS.md").read_text()
    (line,) = re.findall(r"^pcl_emtr plan1.ply plan2.ply (.*)$", page, re.MULTILINE)
    rng = np.random.default_rng(3)
    angle, move = 2.2, np.array([1.5, -4, 0])
    R = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    plans = floor_plan(rng), floor_plan(rng) @ R.T + move
    for name, plan in zip(("plan1.obj", "plan2.obj"), plans):
        np.savetxt(tmp_path / name, plan, fmt="v %.6f %.6f %.6f")
    report = found("plan1.obj", "plan2.obj", *line.split())
    T = np.array(report["transformation"])
    assert report["registered"]
    np.testing.assert_allclose(T[:3, :3], R, atol=0.01)
    np.testing.assert_allclose(T[:3, 3], move, atol=0.03)
