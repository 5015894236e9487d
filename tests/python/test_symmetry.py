"""The symmetry of made shapes, which is known, and the verdict that goes with it."""

import numpy as np
import pytest
import shapes
from scipy.spatial.transform import Rotation

import pyemtr

COUNT = 12000


def box(rng, low, high, count=COUNT):
    low, high = np.array(low, float), np.array(high, float)
    x, y, z = high - low
    areas = np.repeat([y * z, x * z, x * y], 2)
    face = rng.choice(6, count, p=areas / areas.sum())
    unit = rng.uniform(size=(count, 3))
    unit[np.arange(count), face // 2] = face % 2
    return low + unit * (high - low)


def gear(rng, teeth=8):
    angle, height = rng.uniform(0, 2 * np.pi, COUNT), rng.uniform(0, 0.3, COUNT)
    radius = 1 + 0.25 * (np.sin(teeth * angle) > 0)
    side = rng.random(COUNT) < 0.6
    radius = np.where(side, radius, radius * np.sqrt(rng.uniform(0.09, 1, COUNT)))
    height = np.where(side, height, 0)  # open above: it cannot be laid upside down
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), height])


def facade(rng, door=False):
    """A wall with a cornice and eight windows that are 0.4 deep, and a porch before it."""
    wall = np.column_stack([rng.uniform(0, 20, COUNT), np.zeros(COUNT), rng.uniform(0, 9, COUNT)])
    across = wall[:, 0] % 2.5
    wall = wall[~((across > 0.7) & (across < 1.8) & (wall[:, 2] > 1) & (wall[:, 2] < 5))]
    windows = [
        box(rng, (2.5 * k + 0.7, 0, 1), (2.5 * k + 1.8, 0.4, 5), COUNT // 20) for k in range(8)
    ]
    windows = np.vstack(windows)
    windows = windows[windows[:, 1] > 0.001]  # open in front
    cornice = box(rng, (0, -0.6, 8.5), (20, 0, 9), COUNT // 6)
    porch = box(rng, (8, -3, 0), (11, 0, 6), COUNT // 5) if door else wall[:0]
    return np.vstack([wall, windows, cornice, porch])


def prism(rng, sides):
    """A tray with a floor and equal sides."""
    angle = 2 * np.pi * np.arange(sides) / sides
    corners = np.column_stack([np.cos(angle), np.sin(angle)])
    side, along = rng.integers(0, sides, COUNT), rng.random((COUNT, 1))
    rim = (1 - along) * corners[side] + along * corners[(side + 1) % sides]
    floor = rng.random(COUNT) < 0.4
    rim[floor] *= np.sqrt(rng.random((floor.sum(), 1)))
    return np.column_stack([rim, np.where(floor, 0, rng.uniform(0, 0.8, COUNT))])


def cup(rng):
    angle, height = rng.uniform(0, 2 * np.pi, COUNT), rng.uniform(0, 2, COUNT)
    radius = 1 + 0.2 * height
    floor = rng.random(COUNT) < 0.25
    radius[floor] *= np.sqrt(rng.uniform(size=COUNT))[floor]
    height[floor] = 0
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), height])


def register(source, target, seed):
    rng = np.random.default_rng(seed)
    T = np.eye(4)
    T[:3, :3] = Rotation.random(random_state=seed).as_matrix()
    T[:3, 3] = rng.uniform(-5, 5, 3)
    noise = 0.001 * np.ptp(target, axis=0).max()
    source, target = (c + rng.normal(scale=noise, size=c.shape) for c in (source, target))
    return pyemtr.register(shapes.apply(np.linalg.inv(T), source), target, seed=seed, threads=2), T


def two(shape, seed, **words):
    return (shape(np.random.default_rng([seed, part]), **words) for part in (0, 1))


@pytest.mark.parametrize("seed", range(2))
def test_a_gear_has_as_many_folds_as_teeth(seed):
    result, _ = register(*two(gear, seed), seed)
    assert not result.registered and result.symmetry == "rotational"
    assert result.symmetry_order == 8 and abs(result.symmetry_axis[2]) > 0.99


def test_a_box_is_twofold():
    source, target = two(lambda rng: box(rng, (0, 0, 0), (3, 2, 1)), 3)
    result, _ = register(source, target, 3)
    assert result.reason == "ambiguous" and result.symmetry == "rotational"
    assert result.symmetry_order == 2 and np.abs(result.symmetry_axis).max() > 0.99


@pytest.mark.parametrize("sides, seed", [(3, 0), (3, 2), (5, 0)])
def test_views_of_a_tray_from_two_sides_do_not_tell_its_sides_apart(sides, seed):
    """A wrong rotation overlaps more than the right one, and fits as well."""
    rng = np.random.default_rng(seed)
    views = []
    for cloud in two(prism, seed, sides=sides):
        height = cloud @ shapes.directions(rng, 1)[0]
        views.append(cloud[height < np.quantile(height, 0.8)])
    result, _ = register(*views, seed)
    assert result.reason == "ambiguous" and result.confidence < 0.5


def test_a_facade_has_the_period_of_its_windows():
    """None is taken for certain. The period is told where enough of its poses were found."""
    told = 0
    for seed in range(6):
        source, target = two(facade, seed)
        result, _ = register(source[source[:, 0] < 15], target[target[:, 0] > 5], seed)
        assert result.reason == "ambiguous" and result.symmetry in ("translational", "none")
        if result.symmetry == "none":
            continue
        told += 1
        assert abs(result.symmetry_axis[0]) > 0.98
        periods = result.symmetry_period / 2.5
        assert abs(periods - round(periods)) < 0.1 and round(periods) >= 1
    assert told >= 1


def test_one_distinct_detail_decides_a_facade():
    """In most of them: it is a twelfth of the points. The best pose is right in all."""
    decided = 0
    for seed in range(6):
        source, target = two(facade, seed, door=True)
        result, T = register(source[source[:, 0] < 17], target[target[:, 0] > 3], seed)
        assert shapes.rotation_error(result.transformation, T) < 1
        if not result.registered:
            continue
        decided += 1
        assert result.symmetry == "none" and result.symmetry_order == 0
        assert np.isnan(result.symmetry_axis).all() and np.isnan(result.symmetry_period)
    assert decided >= 3


def test_a_cup_can_be_rotated_by_any_angle():
    result, T = register(*two(cup, 6), 6)
    assert result.reason == "degenerate" and result.symmetry == "continuous"
    assert abs(result.symmetry_axis[2]) > 0.99 and result.confidence > 0.9
    up = result.transformation[:3, :3] @ T[:3, :3].T @ [0, 0, 1]
    assert up[2] > 0.999  # right but for the rotation


def test_without_candidates_it_is_unknown():
    source, target = two(lambda rng: box(rng, (0, 0, 0), (3, 2, 1), 3000), 7)
    result = pyemtr.register(source, target, preset="paper", iterations=3)
    assert result.symmetry == "unknown" and result.symmetry_order == 0
