"""The error metrics against independent oracles."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from pyemtr.metrics import joint_success, rotation_error, translation_error

angles = st.floats(-math.pi, math.pi)
coordinates = st.floats(-100.0, 100.0)
vectors = st.tuples(coordinates, coordinates, coordinates)
rotations = st.builds(lambda a, b, c: Rotation.from_euler("ZYX", [a, b, c]), angles, angles, angles)
directions = rotations.map(lambda r: r.apply([0.0, 0.0, 1.0]))


def pose(rotation, translation=(0.0, 0.0, 0.0)):
    matrix = np.eye(4)
    matrix[:3, :3] = rotation.as_matrix()
    matrix[:3, 3] = translation
    return matrix


@settings(deadline=None)
@given(rotations, rotations, vectors, vectors)
def test_rotation_error_is_the_geodesic_angle(first, second, t1, t2):
    expected = math.degrees((first * second.inv()).magnitude())
    assert rotation_error(pose(first, t1), pose(second, t2)) == pytest.approx(expected, abs=1e-5)


@settings(deadline=None)
@given(rotations, directions, st.floats(0.5, 2.6))
def test_rotation_error_is_the_papers_arccos_at_large_angles(true, axis, angle):
    estimate = Rotation.from_rotvec(angle * axis) * true
    trace = np.trace(true.as_matrix() @ estimate.as_matrix().T)
    expected = math.degrees(math.acos((trace - 1.0) / 2.0))
    assert rotation_error(pose(estimate), pose(true)) == pytest.approx(expected, rel=1e-12)


@settings(deadline=None)
@given(directions, st.floats(1e-9, 1e-3))
def test_tiny_angles_keep_their_digits(axis, angle):
    error = rotation_error(pose(Rotation.from_rotvec(angle * axis)), np.eye(4))
    # Nine decades below one degree, where arccos of the trace returns 0 or 1e-6.
    assert error == pytest.approx(math.degrees(angle), rel=2e-7)


@settings(deadline=None)
@given(rotations, vectors)
def test_no_error_for_the_same_pose(rotation, translation):
    T = pose(rotation, translation)
    assert rotation_error(T, T) == 0.0
    assert translation_error(T, T, [1.0, 2.0, 3.0], 2.0) == 0.0


@settings(deadline=None)
@given(rotations)
def test_rotations_by_180_degrees_do_not_leave_the_domain_of_asin(true):
    for axis in np.eye(3):
        estimate = true * Rotation.from_rotvec(math.pi * axis)
        assert rotation_error(pose(estimate), pose(true)) == pytest.approx(180.0, abs=1e-5)


@settings(deadline=None)
@given(rotations, rotations, vectors, vectors, vectors, st.floats(0.01, 100.0))
def test_translation_error_is_the_displacement_of_the_center(first, second, t1, t2, c, scale):
    a, b = pose(first, t1), pose(second, t2)
    difference = (first.apply(c) + t1) - (second.apply(c) + t2)
    expected = np.linalg.norm(difference) / scale
    assert translation_error(a, b, c, scale) == pytest.approx(expected, rel=1e-9, abs=1e-9)


@settings(deadline=None)
@given(rotations, rotations, vectors, vectors, vectors, vectors, st.floats(0.1, 10.0))
def test_translation_error_is_the_papers_in_the_normalized_frame(
    first, second, t1, t2, source, target, scale
):
    # The paper compares translations after both clouds were centered and divided by scale.
    normalized = [(r.apply(source) + t - target) / scale for r, t in ((first, t1), (second, t2))]
    expected = np.linalg.norm(normalized[0] - normalized[1])
    error = translation_error(pose(first, t1), pose(second, t2), source, scale)
    assert error == pytest.approx(expected, rel=1e-9, abs=1e-9)


@settings(deadline=None)
@given(rotations, vectors, vectors, st.floats(0.001, 1000.0))
def test_translation_error_does_not_depend_on_the_unit(rotation, t, c, unit):
    T, other = pose(rotation, t), pose(rotation, np.add(t, 0.3))
    scaled = pose(rotation, np.multiply(t, unit))
    other_scaled = pose(rotation, np.add(t, 0.3) * unit)
    expected = translation_error(T, other, c, 2.0)
    assert translation_error(scaled, other_scaled, np.multiply(c, unit), 2.0 * unit) == (
        pytest.approx(expected, rel=1e-6)
    )


@pytest.mark.parametrize(
    ("degrees", "translation", "expected"),
    [(4.9, 0.059, True), (5.1, 0.0, False), (0.0, 0.061, False), (6.0, 0.07, False)],
)
def test_joint_success_needs_both(degrees, translation, expected):
    center, scale = np.array([10.0, -5.0, 2.0]), 40.0
    rotation = Rotation.from_euler("Z", degrees, degrees=True)
    # A rotation about the center, then a translation of it: the two errors are independent.
    T = pose(rotation, center - rotation.apply(center) + [translation * scale, 0.0, 0.0])
    assert joint_success(T, np.eye(4), center, scale) is expected
    assert joint_success(T, np.eye(4), center, scale, max_rotation=7.0, max_translation=0.08)


def broken(change):
    matrix = np.eye(4)
    change(matrix)
    return matrix


BAD_MATRICES = {
    "shape": np.eye(3),
    "finite": broken(lambda m: m.__setitem__((0, 3), np.nan)),
    "last row": broken(lambda m: m.__setitem__((3, 0), 0.5)),
    "R\\^T R": broken(lambda m: m.__setitem__((0, 0), 1.1)),
    "reflection": np.diag([1.0, 1.0, -1.0, 1.0]),
    "real numbers": [["a"] * 4] * 4,
}


@pytest.mark.parametrize("message", BAD_MATRICES)
@pytest.mark.parametrize("name", ["T_est", "T_true"])
def test_a_bad_matrix_is_refused_by_name(name, message):
    matrices = {"T_est": np.eye(4), "T_true": np.eye(4), name: BAD_MATRICES[message]}
    with pytest.raises(ValueError, match=f"^{name}: .*{message}"):
        rotation_error(**matrices)
    with pytest.raises(ValueError, match=f"^{name}: .*{message}"):
        translation_error(**matrices, center=[0, 0, 0], scale=1.0)


@pytest.mark.parametrize("scale", [0.0, -1.0, math.nan, math.inf])
def test_a_bad_scale_is_refused(scale):
    with pytest.raises(ValueError, match=r"^scale: "):
        translation_error(np.eye(4), np.eye(4), [0, 0, 0], scale)


@pytest.mark.parametrize("center", [[0, 0], [[0, 0, 0]], [0, 0, math.nan], 1.0])
def test_a_bad_center_is_refused(center):
    with pytest.raises(ValueError, match=r"^center: "):
        translation_error(np.eye(4), np.eye(4), center, 1.0)


def test_float32_matrices_are_rigid_enough():
    T = pose(Rotation.from_euler("ZYX", [0.4, -1.1, 2.0]), [1.0, 2.0, 3.0]).astype(np.float32)
    assert rotation_error(T, T) == 0.0
