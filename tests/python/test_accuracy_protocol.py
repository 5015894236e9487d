"""The protocol's motions: classes, ranges, the same everywhere, and the truth they imply."""

import math

import accuracy_fakes  # noqa: F401  (puts the benchmark on the path)
import numpy as np
import pytest
from emtr_bench import protocol
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

CLOUD = np.random.default_rng(3).normal(size=(200, 3)) * [4.0, 2.0, 1.0] + [30.0, -7.0, 1.0]
DIAGONAL = float(np.linalg.norm(CLOUD.max(axis=0) - CLOUD.min(axis=0)))
HALF_PI, QUARTER_PI = math.pi / 2, math.pi / 4

# Motion 0 of bunny_045_000, drawn once with numpy 2.4: comparisons over time need it to stay.
PINNED_ANGLES = [0.11609418654154212, 0.13633164556751282, 0.5992331118540006]
PINNED_TRANSLATION = [-0.014412486004412249, -0.29498340877178003, -0.19101443557912834]

names = st.text(min_size=1, max_size=30)
indices = st.integers(0, 1000)


def test_twenty_motions_hold_four_of_each_class():
    kinds = [protocol.motion("hare", i, CLOUD).kind for i in range(20)]
    assert {kind: kinds.count(kind) for kind in protocol.CLASSES} == dict.fromkeys(
        ["SRxST", "SRxLT", "LRxST", "LRxLT", "any"], 4
    )


@settings(deadline=None)
@given(names, indices)
def test_each_motion_lies_in_the_range_of_its_class(name, index):
    motion = protocol.motion(name, index, CLOUD)
    alpha, beta, gamma = np.abs(motion.angles)
    translation = np.abs(motion.translation)
    assert max(alpha, gamma) <= math.pi and beta <= HALF_PI and translation.max() <= DIAGONAL
    if motion.kind.startswith("SR"):
        assert max(alpha, gamma) <= HALF_PI and beta <= QUARTER_PI
    if motion.kind.startswith("LR"):
        assert min(alpha, gamma) >= HALF_PI and beta >= QUARTER_PI
    if motion.kind.endswith("ST"):
        assert translation.max() <= DIAGONAL / 2
    if motion.kind.endswith("LT"):
        assert translation.min() >= DIAGONAL / 2


def test_motions_fill_their_ranges_with_either_sign():
    motions = [protocol.motion("hare", i, CLOUD) for i in range(3000)]
    for kind in protocol.CLASSES:
        angles = np.array([m.angles for m in motions if m.kind == kind])
        translation = np.array([m.translation for m in motions if m.kind == kind]) / DIAGONAL
        small = kind.startswith("SR")
        top = protocol.SMALL_ANGLES if small else protocol.LARGE_ANGLES
        assert (np.abs(angles).max(axis=0) > 0.97 * top).all(), kind
        assert (np.abs(translation).max(axis=0) > (0.48 if kind.endswith("ST") else 0.97)).all(), (
            kind
        )
        for column in (*angles.T, *translation.T):
            assert 0.4 < np.mean(column > 0.0) < 0.6, kind


@settings(deadline=None)
@given(names, indices)
def test_the_truth_maps_the_moved_source_onto_the_aligned_one(name, index):
    motion = protocol.motion(name, index, CLOUD)
    moved = protocol.apply(motion.matrix, CLOUD)
    np.testing.assert_allclose(protocol.apply(motion.T_true, moved), CLOUD, atol=1e-10)
    # The centroid moves by the translation, whatever the rotation.
    np.testing.assert_allclose(
        moved.mean(axis=0) - CLOUD.mean(axis=0), motion.translation, atol=1e-10
    )


@settings(deadline=None)
@given(st.lists(st.floats(-math.pi, math.pi), min_size=3, max_size=3))
def test_euler_angles_are_z_y_x_about_fixed_axes(angles):
    expected = Rotation.from_euler("ZYX", angles).as_matrix()
    np.testing.assert_allclose(protocol.euler_zyx(np.array(angles)), expected, atol=1e-12)


def test_motions_depend_on_name_and_index_alone():
    first = protocol.motion("hare", 7, CLOUD)
    again = protocol.motion("hare", 7, CLOUD)
    np.testing.assert_array_equal(first.matrix, again.matrix)
    assert not np.allclose(first.angles, protocol.motion("hare", 12, CLOUD).angles)
    assert not np.allclose(first.angles, protocol.motion("duck", 7, CLOUD).angles)


def test_a_motion_is_the_same_on_every_machine_and_in_every_release():
    motion = protocol.motion("bunny_045_000", 0, CLOUD)
    np.testing.assert_allclose(motion.angles, PINNED_ANGLES, rtol=1e-12)
    np.testing.assert_allclose(motion.translation / DIAGONAL, PINNED_TRANSLATION, rtol=1e-12)


@pytest.mark.parametrize("unit", [0.001, 1.0, 1000.0])
def test_frame_scale_is_the_larger_radius(unit):
    small, large = np.array([[0.0, 0, 0], [2, 0, 0]]), np.array([[9.0, 9, 3], [9, 9, 13]])
    assert protocol.frame_scale(small * unit, large * unit) == pytest.approx(5.0 * unit)
    assert protocol.frame_scale(large * unit, small * unit) == pytest.approx(5.0 * unit)
