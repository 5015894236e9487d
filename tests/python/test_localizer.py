"""Scans against a map: near the last pose, by a search when that does not convince."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from shapes import apply

import pyemtr
from pyemtr import Cloud

RNG = np.random.default_rng(5)
HILLS = RNG.uniform(-10, 10, (60, 2))
HEIGHTS = RNG.uniform(0.3, 1.6, 60)
WIDTHS = RNG.uniform(0.4, 1.2, 60)


def land(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Points (N, 3) of a hilly ground."""
    away = (x[:, None] - HILLS[:, 0]) ** 2 + (y[:, None] - HILLS[:, 1]) ** 2
    return np.column_stack([x, y, (HEIGHTS * np.exp(-away / WIDTHS**2)).sum(axis=1)])


def pose_at(x: float, y: float, heading: float) -> np.ndarray:
    """A level sensor 2 above the ground, (4, 4), sensor -> map."""
    c, s = np.cos(heading), np.sin(heading)
    pose = np.eye(4)
    pose[:2, :2] = [[c, -s], [s, c]]
    pose[:3, 3] = x, y, 2.0
    return pose


def scan_at(pose: np.ndarray, seed: int, reach: float = 4.0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    offset = rng.uniform(-reach, reach, (6000, 2))
    offset = offset[np.linalg.norm(offset, axis=1) < reach]
    points = land(*(pose[:2, 3] + offset).T)
    return apply(np.linalg.inv(pose), points + rng.normal(scale=0.01, size=points.shape))


@pytest.fixture(scope="module")
def ground() -> np.ndarray:
    return land(*np.random.default_rng(0).uniform(-10, 10, (2, 40_000)))


def localizer(ground: np.ndarray, **more) -> pyemtr.Localizer:
    """The sensor sees all around it, through hills too, so its place tells nothing."""
    return pyemtr.Localizer(
        ground, **{"axis": (0, 0, 1), "axis_tilt": 2, "sensor": None, "threads": 2, **more}
    )


def off(location: pyemtr.Location, pose: np.ndarray) -> float:
    return float(np.abs(location.pose - pose).max())


def test_a_drive_is_followed_from_pose_to_pose(ground) -> None:
    found = localizer(ground, radius=1.5)
    assert found.last_pose is None
    poses = [pose_at(-4 + 0.8 * i, 0.5 * i, 0.1 * i) for i in range(4)]
    locations = [found.localize(scan_at(pose, i)) for i, pose in enumerate(poses)]
    assert [one.by for one in locations] == ["search"] + ["last pose"] * 3
    for location, pose in zip(locations, poses):
        assert location.registered and off(location, pose) < 0.05
        assert location.pose is location.result.transformation
        assert location.confidence == location.result.confidence > 0.5
    assert np.array_equal(found.last_pose, locations[-1].pose)


def test_one_who_was_carried_away_is_searched_for(ground) -> None:
    found = localizer(ground, radius=1.0)
    found.localize(scan_at(pose_at(-5, -5, 0), 1))
    away = pose_at(5, 4, 2.5)
    location = found.localize(scan_at(away, 2))
    assert location.by == "search" and location.registered and off(location, away) < 0.05
    assert np.array_equal(found.last_pose, location.pose)


@pytest.mark.parametrize(
    ("near", "whole", "by"),
    [
        ((True, 0.999), (True, 1.0), "last pose"),  # sure enough, so the map is not searched
        ((True, 0.9), (True, 0.95), "search"),
        ((True, 0.9), (True, 0.8), "last pose"),
        ((True, 0.9), (False, 0.95), "last pose"),
        ((False, 0.4), (True, 0.6), "search"),
        ((False, 0.4), (False, 0.3), "search"),
    ],
)
def test_a_doubtful_pose_near_the_last_one_is_compared_with_the_map(
    ground, monkeypatch, near, whole, by
) -> None:
    found = localizer(ground, radius=1.0)
    first = found.localize(scan_at(pose_at(0, 0, 0), 3))
    calls = []

    def register(scan, target, **settings):
        kind = "near" if "guess" in settings else "whole"
        calls.append(kind)
        registered, confidence = near if kind == "near" else whole
        pose = first.pose @ pose_at(0.1 if kind == "near" else 5.0, 0, 0)
        return SimpleNamespace(registered=registered, confidence=confidence, transformation=pose)

    monkeypatch.setattr("pyemtr.localizer.register", register)
    location = found.localize(scan_at(pose_at(0, 0, 0), 4))
    assert location.by == by
    assert (location.registered, location.confidence) == (near if by == "last pose" else whole)
    assert calls == (["near"] if near[1] > 0.99 else ["near", "whole"])
    moved = not np.array_equal(found.last_pose, first.pose)
    assert moved is location.registered
    calls.clear()
    located = found.localize(scan_at(pose_at(0, 0, 0), 4), guess=first.pose)
    assert (calls, located.by) == (
        (["near"], "guess") if near[0] else (["near", "whole"], "search")
    )


def test_what_is_not_registered_leaves_the_last_pose(ground) -> None:
    found = localizer(ground, radius=1.0)
    here = found.localize(scan_at(pose_at(0, 0, 0), 3))
    rng = np.random.default_rng(9)
    elsewhere = np.column_stack([rng.uniform(-4, 4, (4000, 2)), 0.01 * rng.normal(size=4000)])
    lost = found.localize(elsewhere)
    assert not lost.registered and lost.by == "search"
    assert np.array_equal(found.last_pose, here.pose)
    found.forget()
    assert found.last_pose is None


def test_a_guess_counts_more_than_the_last_pose(ground) -> None:
    found = localizer(ground)
    found.localize(scan_at(pose_at(-5, -5, 0), 1))
    pose = pose_at(4, 4, 1)
    guess = pose.copy()
    guess[:3, 3] += 0.3, -0.3, 0
    location = found.localize(scan_at(pose, 4), guess, radius=1.0, degrees=10)
    assert location.by == "guess" and location.registered and off(location, pose) < 0.05


def test_a_wrong_guess_and_one_off_the_map_do_no_harm(ground) -> None:
    found = localizer(ground)
    pose = pose_at(4, -3, 1)
    scan = scan_at(pose, 5)
    for guess in (pose_at(-6, 6, 0), pose_at(500, 500, 0)):
        location = found.localize(scan, guess, radius=1.0)
        assert location.by == "search" and location.registered and off(location, pose) < 0.05


def test_the_part_of_the_map_does_not_depend_on_what_was_asked_before(ground) -> None:
    pose = pose_at(2, 2, 0.3)
    scan, guess = scan_at(pose, 6), pose_at(2.2, 1.9, 0.3)
    fresh, used = localizer(ground, threads=1), localizer(pyemtr.Cloud(ground))
    used.localize(scan_at(pose_at(1.5, 2, 0.2), 7))
    first, second = (one.localize(scan, guess, radius=1.0) for one in (fresh, used))
    assert np.array_equal(first.pose, second.pose) and first.confidence == second.confidence


def test_a_scan_may_be_preprocessed_and_a_map_a_file(ground, tmp_path) -> None:
    np.save(tmp_path / "map.npy", ground)
    pose = pose_at(1, 1, 0)
    scan = scan_at(pose, 8)
    found = localizer(str(tmp_path / "map.npy"))
    by_cloud = found.localize(pyemtr.Cloud(scan), pose, radius=1.0)
    by_array = found.localize(scan, pose, radius=1.0)
    assert np.array_equal(by_cloud.pose, by_array.pose) and by_cloud.registered


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"radius": 0}, ValueError, "radius: expected a number above 0"),
        ({"degrees": -1}, ValueError, "degrees: expected"),
        ({"axis": (0, 0)}, ValueError, "axis: "),
        ({"guess_rotation": 5}, TypeError, "give radius= and degrees="),
        ({"iteratons": 5}, TypeError, "did you mean iterations"),
        ({"preset": "quick"}, ValueError, "preset"),
    ],
)
def test_wrong_arguments_are_named(ground, arguments, error, message) -> None:
    with pytest.raises(error, match=message):
        localizer(ground, **arguments)


def test_wrong_scans_and_guesses_are_named(ground) -> None:
    found = localizer(ground)
    with pytest.raises(ValueError, match="scan: "):
        found.localize([[1, 2, 3]])
    with pytest.raises(ValueError, match="guess: "):
        found.localize(ground[:500], np.eye(3))
    with pytest.raises(ValueError, match="radius: "):
        found.localize(ground[:500], np.eye(4), radius=-1)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"scale": "free"}, "scale: expected"),
        ({"use_colors": "on"}, "map: has neither colors nor intensities"),
    ],
)
def test_settings_that_a_map_cannot_have_are_refused(settings, words):
    with pytest.raises(ValueError, match=words):
        pyemtr.Localizer(np.random.default_rng(0).uniform(size=(100, 3)), **settings)


def painted(points: np.ndarray) -> np.ndarray:
    """Colors (N, 3) of places on a floor: those of the nearest of some marks."""
    rng = np.random.default_rng(3)
    marks, colors = rng.uniform(-10, 10, (500, 2)), rng.uniform(0.1, 0.9, (500, 3))
    away = ((points[:, None, :2] - marks) ** 2).sum(axis=2)
    return colors[away.argmin(axis=1)]


@pytest.mark.parametrize("what", ["colors", "intensity"])
def test_a_flat_floor_is_known_by_what_is_painted_on_it(what) -> None:
    rng = np.random.default_rng(7)

    def cloud(center: tuple[float, float], reach: float, count: int, pose: np.ndarray) -> Cloud:
        places = np.column_stack([rng.uniform(-reach, reach, (count, 2)) + center, np.zeros(count)])
        looks = painted(places)
        points = apply(pose, places + rng.normal(scale=0.005, size=places.shape))
        return Cloud(points, **{what: looks if what == "colors" else looks.mean(axis=1)})

    floor = cloud((0, 0), 10, 40_000, np.eye(4))
    pose = pose_at(2, -1, 0.7)
    scan = cloud((2, -1), 3, 11_000, np.linalg.inv(pose))
    guess = pose_at(2.4, -1.3, 0.8)

    def located(use_colors: str) -> pyemtr.Location:
        found = pyemtr.Localizer(floor, radius=1.0, preset="fast", use_colors=use_colors)
        return found.localize(scan, guess)

    location = located("on")
    assert location.registered and location.by == "guess" and location.result.used_colors
    assert off(location, pose) < 0.05
    assert not located("off").registered


def test_the_scans_must_have_colors_that_are_asked_for(ground) -> None:
    colored = Cloud(ground, colors=painted(ground))
    with pytest.raises(ValueError, match="source cloud: has neither colors"):
        localizer(colored, use_colors="on").localize(scan_at(pose_at(0, 0, 0), 3))
