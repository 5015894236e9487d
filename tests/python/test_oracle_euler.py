"""Angles, matrices and the user's frame against R = Rz(t1) Ry(t2) Rx(t3)."""

import numpy as np
import oracles
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

angle = st.floats(-10, 10)
translation = st.floats(-2, 2)


def expected(problem, particle):
    return oracles.transformation(
        particle, problem.normalization_scale, problem.center_source, problem.center_target
    )


@settings(max_examples=200, deadline=None)
@given(particle=st.tuples(angle, angle, angle, translation, translation, translation))
def test_a_particle_becomes_its_matrix(problem, particle):
    found = problem.to_transformation(particle)
    np.testing.assert_allclose(found, expected(problem, np.array(particle)), atol=1e-12)


@settings(max_examples=200, deadline=None)
@given(particle=st.tuples(angle, angle, angle, translation, translation, translation))
def test_there_and_back_is_the_same_pose(problem, particle):
    matrix = problem.to_transformation(particle)
    back = problem.to_particle(matrix)
    np.testing.assert_allclose(problem.to_transformation(back), matrix, atol=1e-7)
    assert np.all(np.abs(back[:3]) <= [np.pi + 1e-12, np.pi / 2 + 1e-12, np.pi + 1e-12])


def test_back_gives_the_angles_within_their_ranges(problem):
    particle = np.array([2.9, -1.2, -2.1, 0.3, -0.2, 0.1])
    back = problem.to_particle(problem.to_transformation(particle))
    np.testing.assert_allclose(back, particle, atol=1e-9)


@pytest.mark.parametrize("pole", [np.pi / 2, -np.pi / 2])
@pytest.mark.parametrize("roll", [-2.5, 0.0, 1.3])
def test_gimbal_lock_keeps_the_pose(problem, pole, roll):
    matrix = expected(problem, np.array([0.7, pole, roll, 0.1, 0.2, 0.3]))
    back = problem.to_particle(matrix)
    assert np.isfinite(back).all()
    np.testing.assert_allclose(problem.to_transformation(back), matrix, atol=1e-7)


def test_the_identity_in_the_user_frame_is_not_zero_translation(problem):
    particle = problem.to_particle(np.eye(4))
    gap = (problem.center_source - problem.center_target) / problem.normalization_scale
    np.testing.assert_allclose(particle, [0, 0, 0, *gap], atol=1e-12)


@pytest.mark.parametrize(
    "spoil",
    [
        lambda t: np.diag([1.0, 1, -1, 1]),  # a mirror
        lambda t: np.diag([2.0, 2, 2, 1]),  # a scale
        lambda t: np.ones((4, 4)),
        lambda t: np.full((4, 4), np.nan),
        lambda t: t[:3],
        lambda t: t.reshape(16),
    ],
)
def test_what_is_not_rigid_is_refused(problem, spoil):
    with pytest.raises(ValueError):
        problem.to_particle(spoil(np.eye(4)))
