"""The solids that virtual sensors look at, against points that are known to lie on them."""

import sys

import numpy as np
import pytest
from accuracy_fakes import REPOSITORY

sys.path.insert(0, str(REPOSITORY / "tools"))

from virtual_scan import rays
from virtual_scan.solids import Ball, Box, Cylinder, first_ranges

EYE = np.array([4.0, -3.0, 2.0])


def towards(points, eye=EYE):
    away = points - eye
    ranges = np.linalg.norm(away, axis=1)
    return away / ranges[:, None], ranges


def box_surface(size, base, yaw, count, rng):
    points = rng.uniform(-0.5, 0.5, (count, 3))
    axis = rng.integers(0, 3, count)
    points[np.arange(count), axis] = rng.choice([-0.5, 0.5], count)
    points = points * size + [0, 0, size[2] / 2]
    c, s = np.cos(np.radians(yaw)), np.sin(np.radians(yaw))
    return points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + base


def cylinder_surface(radius, height, base, count, rng):
    angle = rng.uniform(0, 2 * np.pi, count)
    out, up = radius * np.sqrt(rng.uniform(0, 1, count)), np.full(count, height)
    side = rng.random(count) < 0.5
    out[side], up[side] = radius, rng.uniform(0, height, side.sum())
    return np.column_stack([out * np.cos(angle), out * np.sin(angle), up]) + base


def ball_surface(radius, center, count, rng):
    away = rng.normal(size=(count, 3))
    return radius * away / np.linalg.norm(away, axis=1, keepdims=True) + center


@pytest.mark.parametrize(
    ("solid", "surface"),
    [
        (Box((0.5, 1.0, -0.2), (1.0, 2.0, 0.7), 25.0),
         lambda rng: box_surface((1.0, 2.0, 0.7), (0.5, 1.0, -0.2), 25.0, 500, rng)),
        (Cylinder((0.5, 0.0, -0.4), 0.6, 1.1),
         lambda rng: cylinder_surface(0.6, 1.1, (0.5, 0.0, -0.4), 500, rng)),
        (Ball((-0.3, 0.2, 0.1), 0.8), lambda rng: ball_surface(0.8, (-0.3, 0.2, 0.1), 500, rng)),
    ],
)  # fmt: skip
def test_a_ray_to_a_point_of_the_surface_ends_there_or_before(solid, surface):
    points = surface(np.random.default_rng(1))
    sight, ranges = towards(points)
    found = solid.ranges(EYE, sight)
    assert (found <= ranges + 1e-9).all()
    seen = found > ranges - 1e-9
    assert 0.2 < seen.mean() < 0.8  # the far side is hidden by the near one
    away = towards(EYE + (EYE - points))[0]
    assert np.isinf(solid.ranges(EYE, away)).all()


def test_a_box_from_inside_is_a_room():
    eye = np.array([0.3, -0.2, 1.1])
    room = Box((0.0, 0.0, 0.0), (4.0, 3.0, 2.5))
    points = box_surface((4.0, 3.0, 2.5), (0.0, 0.0, 0.0), 0.0, 300, np.random.default_rng(2))
    sight, ranges = towards(points, eye)
    np.testing.assert_allclose(room.ranges(eye, sight), ranges, atol=1e-9)


def test_the_nearest_of_several_solids_is_met():
    near, far = Ball((0.0, 0.0, 0.0), 1.0), Box((-3.0, 0.0, -1.0), (1.0, 9.0, 2.0))
    ray = np.array([[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]])
    eye = np.array([5.0, 0.0, 0.0])
    np.testing.assert_allclose(first_ranges([far, near], eye, ray), [4.0, np.inf, 4.0])


def test_rays_are_unit_and_point_where_they_should():
    sight = rays.camera(EYE, np.zeros(3), half_angle=30.0, columns=40, rows=30)
    np.testing.assert_allclose(np.linalg.norm(sight, axis=1), 1.0)
    middle = -EYE / np.linalg.norm(EYE)
    np.testing.assert_allclose(sight.mean(axis=0) / np.linalg.norm(sight.mean(axis=0)), middle)
    image = sight.reshape(30, 40, 3)
    assert image[0, 20, 2] > image[-1, 20, 2]  # the first row is the upper one
    spun = rays.spinning(-20.0, 10.0, beams=4, steps=36, start=15.0)
    np.testing.assert_allclose(np.linalg.norm(spun, axis=1), 1.0)
    np.testing.assert_allclose(np.degrees(np.arcsin(spun[[0, -1], 2])), [-20.0, 10.0])
    assert np.degrees(np.arctan2(spun[0, 1], spun[0, 0])) == pytest.approx(15.0)


def test_noise_is_along_the_rays_and_what_is_far_is_not_seen():
    ball = [Ball((0.0, 0.0, 0.0), 1.0)]
    sight, _ = towards(ball_surface(1.0, (0.0, 0.0, 0.0), 4000, np.random.default_rng(3)))
    points = rays.see(ball, EYE, sight, 0.01, 50.0, np.random.default_rng(4))
    off = np.linalg.norm(points - EYE, axis=1) - ball[0].ranges(EYE, sight)
    assert off.std() == pytest.approx(0.01, rel=0.05) and abs(off.mean()) < 0.001
    assert len(rays.see(ball, EYE, sight, 0.01, 2.0, np.random.default_rng(4))) == 0
