"""Clouds of every dtype and layout: the same values give the same bits; bad ones say why."""

import types

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pyemtr
from pyemtr.points import as_points

QUICK = {"iterations": 3, "threads": 2}


@pytest.fixture(scope="module")
def clouds(pair):
    """Whole numbers of thousandths, exact in float32, and as float64 the same values."""
    return tuple(np.round(cloud * 1000).astype(np.float32) for cloud in (pair.source, pair.target))


@pytest.fixture(scope="module")
def wanted(clouds):
    return run(*clouds)


def run(source, target):
    result = pyemtr.register(source, target, **QUICK)
    return result.transformation.tobytes() + result.history["alpha"].tobytes()


def slice_of_wider(cloud):
    wide = np.full((len(cloud), 7), np.nan, cloud.dtype)
    wide[:, 2:5] = cloud
    return wide[:, 2:5]


def read_only(cloud):
    frozen = cloud.copy()
    frozen.flags.writeable = False
    return frozen


def unaligned(cloud):
    raw = np.empty(cloud.nbytes + 1, np.uint8)
    view = raw[1:].view(cloud.dtype).reshape(cloud.shape)
    view[:] = cloud
    assert not view.flags.aligned
    return view


def every_other_row(cloud):
    twice = np.full((2 * len(cloud), 3), np.nan, cloud.dtype)
    twice[::2] = cloud
    return twice[::2]


LAYOUTS = {
    "float64": lambda c: c.astype(np.float64),
    "longdouble": lambda c: c.astype(np.longdouble),
    "int16": lambda c: c.astype(np.int16),
    "int64": lambda c: c.astype(np.int64),
    "big-endian float32": lambda c: c.astype(">f4"),
    "big-endian float64": lambda c: c.astype(">f8"),
    "big-endian int32": lambda c: c.astype(">i4"),
    "Fortran": np.asfortranarray,
    "Fortran float64": lambda c: np.asfortranarray(c.astype(np.float64)),
    "transposed view": lambda c: np.ascontiguousarray(c.T).T,
    "backward rows": lambda c: c[::-1].copy()[::-1],
    "backward columns": lambda c: c[:, ::-1].copy()[:, ::-1],
    "slice of wider": slice_of_wider,
    "slice of wider float64": lambda c: slice_of_wider(c.astype(np.float64)),
    "every other row": every_other_row,
    "read-only": read_only,
    "unaligned": unaligned,
    "list": lambda c: c.tolist(),
    "tuple of tuples": lambda c: tuple(map(tuple, c.tolist())),
    "object with points": lambda c: types.SimpleNamespace(points=c),
    "object with a list of points": lambda c: types.SimpleNamespace(points=c.tolist()),
    "memoryview": memoryview,
    "masked, nothing masked": np.ma.asarray,
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_the_layout_changes_no_bit(clouds, wanted, layout):
    source, target = (LAYOUTS[layout](cloud) for cloud in clouds)
    assert run(source, clouds[1]) == wanted
    assert run(clouds[0], target) == wanted


def test_float16_and_unsigned_are_taken_at_their_values(clouds):
    halves = [(cloud / 1000).astype(np.float16) for cloud in clouds]
    assert run(*halves) == run(*(half.astype(np.float64) for half in halves))
    whole = [(cloud - cloud.min()).astype(np.uint16) for cloud in clouds]
    assert run(*whole) == run(*(cloud.astype(np.float64) for cloud in whole))


def test_the_input_is_left_alone(clouds):
    copies = [cloud.copy() for cloud in clouds]
    run(*clouds)
    assert all(np.array_equal(a, b) for a, b in zip(copies, clouds))


@pytest.mark.parametrize(
    "layout", ["float64", "slice of wider", "every other row", "read-only", "unaligned"]
)
def test_rows_are_read_in_place(clouds, layout):
    array = LAYOUTS[layout](clouds[0])
    assert np.shares_memory(as_points(array, "source"), array)


@settings(max_examples=150, deadline=None)
@given(
    count=st.integers(2, 9),
    wide=st.integers(3, 6),
    step=st.integers(-3, 3).filter(bool),
    dtype=st.sampled_from(["f2", "f4", "f8", ">f4", ">f8", "g", "i1", "u2", ">i4", "i8"]),
    fortran=st.booleans(),
)
def test_as_points_keeps_values_in_every_layout(count, wide, step, dtype, fortran):
    base = np.arange(abs(step) * count * wide).reshape(-1, wide) % 100
    array = np.array(base, dtype, order="F" if fortran else "C")[::step, wide - 3 :]
    points = as_points(array, "source")
    assert points.dtype in (np.float32, np.float64) and points.dtype.isnative
    assert points.strides[1] == points.itemsize and points.strides[0] >= 3 * points.itemsize
    assert np.array_equal(points, array.astype(np.float64))


def test_rows_on_top_of_each_other_are_not_mistaken_for_packed_ones():
    line = np.arange(40.0)
    overlapping = np.lib.stride_tricks.as_strided(line, (12, 3), (8, 8))
    assert np.array_equal(as_points(overlapping, "source"), overlapping)
    same = np.broadcast_to([1.0, 2.0, 3.0], (12, 3))
    assert np.array_equal(as_points(same, "source"), same)
    with pytest.raises(ValueError, match="target"):  # twelve times one point
        pyemtr.register(np.random.default_rng(0).normal(size=(99, 3)), same)


GOOD = np.random.default_rng(1).normal(size=(200, 3))
BAD = [
    (GOOD.T, ValueError, r"\(N, 3\), got \(3, 200\).*transpose"),
    (GOOD[:, :2], ValueError, r"\(N, 3\), got \(200, 2\)"),
    (np.zeros((200, 4)), ValueError, r"got \(200, 4\)"),
    (GOOD.ravel(), ValueError, r"got \(600,\)"),
    (GOOD[None], ValueError, r"got \(1, 200, 3\)"),
    ([], ValueError, r"got \(0,\)"),
    ([[1, 2, 3], [4, 5]], ValueError, "array of numbers"),
    (GOOD > 0, TypeError, "real numbers, got dtype bool"),
    (GOOD + 1j, TypeError, "complex128"),
    (GOOD.astype(object), TypeError, "object"),
    (GOOD.astype(str), TypeError, "dtype <U"),
    (np.zeros(200, "f4,f4,f4"), TypeError, "dtype"),
    (GOOD.astype("datetime64[s]"), TypeError, "datetime64"),
    (None, TypeError, "NoneType"),
    ("cloud.pcd", FileNotFoundError, ""),
    (types.SimpleNamespace(points=None), TypeError, "NoneType"),
    (np.empty((0, 3)), ValueError, ""),
    (GOOD[:9], ValueError, "10"),
    (np.full((200, 3), np.nan), ValueError, "10"),
    (np.outer(np.arange(200.0), [1, 2, 3]), ValueError, "line"),
    (np.ones((200, 3)), ValueError, ""),
]


@pytest.mark.parametrize("bad, error, text", BAD, ids=range(len(BAD)))
@pytest.mark.parametrize("make", [pyemtr.register, pyemtr.Problem])
def test_bad_clouds_are_refused_by_name(bad, error, text, make):
    named = "" if error is FileNotFoundError else "{}.*"  # the system names the file
    with pytest.raises(error, match=named.format("source") + text):
        make(bad, GOOD)
    with pytest.raises(error, match=named.format("target") + text):
        make(GOOD, bad)
