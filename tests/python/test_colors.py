"""Colors and intensities: what is taken for them, and that they register a flat wall."""

from __future__ import annotations

import pickle
from types import SimpleNamespace

import numpy as np
import pytest
from emtr_bench.colors.cases import case_of

import pyemtr
from pyemtr.cloud import Beside, _Rows
from pyemtr.colors import as_colors, as_intensity, brought_along
from pyemtr.metrics import rotation_error

RNG = np.random.default_rng(1)
COLORS = RNG.uniform(0, 1, (50, 3))
POINTS = RNG.normal(size=(50, 3))


def test_whole_numbers_count_to_their_largest() -> None:
    np.testing.assert_allclose(as_colors(COLORS, "c", 50), COLORS, atol=1e-6)
    np.testing.assert_allclose(as_colors((255 * COLORS).astype("u1"), "c", 50), COLORS, atol=0.005)
    np.testing.assert_allclose(as_colors((65535 * COLORS).astype("u2"), "c", 50), COLORS, atol=1e-4)
    taken = as_colors(COLORS.tolist(), "c", 50)
    assert taken.dtype == np.float32 and taken.shape == (50, 3)


@pytest.mark.parametrize("bad", [COLORS[:, :2], COLORS[:49], COLORS[0], 2 * COLORS, COLORS - 1])
def test_other_colors_are_refused_by_name(bad: object) -> None:
    with pytest.raises(ValueError, match=r"^source_colors: expected"):
        as_colors(bad, "source_colors", 50)
    with pytest.raises(ValueError, match="source_colors: expected"):
        pyemtr.register(POINTS, POINTS, source_colors=bad)


def test_intensities_are_one_a_point_and_not_below_zero() -> None:
    assert as_intensity(COLORS[:, 0], "i", 50).shape == (50, 1)
    for bad in (COLORS[:, :1], COLORS[:40, 0], -COLORS[:, 0]):
        with pytest.raises(ValueError, match=r"^target_intensity: expected"):
            as_intensity(bad, "target_intensity", 50)
    with pytest.raises(TypeError, match="target_intensity: expected"):
        as_intensity(["a"] * 50, "target_intensity", 50)


def packed(colors: np.ndarray) -> np.ndarray:
    r, g, b = (255 * colors).astype("u4").T
    return r << 16 | g << 8 | b


@pytest.mark.parametrize(
    ("names", "values"),
    [
        (("red", "green", "blue"), (255 * COLORS).astype("u1").T),
        (("R", "G", "B"), COLORS.T),
        (("rgb",), [packed(COLORS).view("f4")]),
        (("rgba",), [packed(COLORS) | 255 << 24]),
    ],
)
def test_columns_of_a_table_are_colors(names: tuple[str, ...], values: object) -> None:
    columns = dict(zip(names, values))  # type: ignore[call-overload]
    layout = [(axis, "f8") for axis in "xyz"] + [(k, v.dtype.str) for k, v in columns.items()]
    table = np.zeros(50, layout)
    for name, column in (columns | dict(zip("xyz", POINTS.T))).items():
        table[name] = column
    colors, intensity = brought_along(table, "source", 50)
    assert colors is not None and intensity is None
    np.testing.assert_allclose(colors, COLORS, atol=0.005)
    rows = _Rows.of(table, "source", Beside(), "source_", 100)
    np.testing.assert_allclose(rows.colors, COLORS, atol=0.005)


def test_objects_bring_their_colors_along() -> None:
    opaque = np.column_stack([255 * COLORS, np.full(50, 255)]).astype("u1")
    colors, intensity = brought_along(
        SimpleNamespace(points=POINTS, colors=opaque, intensity=COLORS[:, 0]), "source", 50
    )
    assert colors is not None and intensity is not None
    np.testing.assert_allclose(colors, COLORS, atol=0.005)
    empty = SimpleNamespace(points=POINTS, colors=np.zeros((0, 3)))
    assert brought_along(empty, "source", 50) == (None, None)
    assert brought_along(POINTS, "source", 50) == (None, None)


def test_clouds_of_open3d_bring_theirs() -> None:
    open3d = pytest.importorskip("open3d")
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(POINTS))
    assert brought_along(cloud, "source", 50) == (None, None)
    cloud.colors = open3d.utility.Vector3dVector(COLORS)
    colors, _ = brought_along(cloud, "source", 50)
    np.testing.assert_allclose(colors, COLORS, atol=1e-6)


def test_a_cloud_keeps_them() -> None:
    cloud = pyemtr.Cloud(POINTS, colors=COLORS)
    assert cloud.has_colors and not cloud.has_intensity and "colors" in repr(cloud)
    again = pickle.loads(pickle.dumps(cloud))
    assert again.has_colors and again.nbytes == cloud.nbytes
    assert pyemtr.Cloud(POINTS, intensity=COLORS[:, 0]).has_intensity
    assert cloud.nbytes > pyemtr.Cloud(POINTS).nbytes
    with pytest.raises(TypeError, match=r"source_colors: a pyemtr.Cloud has its own"):
        pyemtr.register(cloud, cloud, source_colors=COLORS)


@pytest.mark.parametrize("scene", ["wall", "intensity", "box"])
def test_what_shape_leaves_open_is_registered_by_colors(scene: str) -> None:
    case = case_of(scene, 0)
    clouds = [
        pyemtr.Cloud(case.source, colors=case.source_colors, intensity=case.source_intensity),
        pyemtr.Cloud(case.target, colors=case.target_colors, intensity=case.target_intensity),
    ]
    off = pyemtr.register(*clouds, preset="fast", use_colors="off")
    assert not off.registered and not off.used_colors and np.isnan(off.color_evidence)
    result = pyemtr.register(*clouds, preset="fast")
    assert result.registered and result.used_colors and result.color_evidence > 20
    assert result.unconstrained_directions == 0 and not result.alternatives
    assert rotation_error(result.transformation, case.truth) < 1
    moved, expected = result.apply(case.source), case.source @ case.truth[:3, :3].T
    np.testing.assert_allclose(moved, expected + case.truth[:3, 3], atol=0.05)


def test_colors_of_another_wall_register_nothing() -> None:
    case = case_of("unrelated", 0)
    result = pyemtr.register(
        case.source,
        case.target,
        source_colors=case.source_colors,
        target_colors=case.target_colors,
        preset="fast",
    )
    assert not result.registered and not result.used_colors


def test_where_the_shape_is_enough_auto_changes_no_bit() -> None:
    rng = np.random.default_rng(2)
    directions = rng.normal(size=(6000, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    bumps = 1 + 0.3 * np.sin(3 * directions @ rng.normal(size=(3, 5))).prod(axis=1, keepdims=True)
    points = bumps * directions
    rotation = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    rotation *= np.sign(np.linalg.det(rotation))
    one, other = points[:4500], points[1500:] @ rotation.T
    shade = 0.5 + 0.5 * np.sin(4 * directions)
    bare = pyemtr.register(one, other, preset="fast")
    assert bare.registered
    colored = pyemtr.register(
        one, other, source_colors=shade[:4500], target_colors=shade[1500:], preset="fast"
    )
    assert np.array_equal(bare.transformation, colored.transformation)
    assert bare.confidence == colored.confidence and not colored.used_colors
    asked = pyemtr.register(
        one, other, source_colors=shade[:4500], target_colors=shade[1500:], preset="fast",
        use_colors="on",
    )  # fmt: skip
    assert asked.registered and asked.used_colors
    assert rotation_error(asked.transformation, bare.transformation) < 0.5


@pytest.mark.parametrize("call", [pyemtr.register, pyemtr.Problem])
def test_asked_for_colors_must_be_there(call) -> None:
    with pytest.raises(ValueError, match="source cloud: has neither colors nor intensities"):
        call(POINTS, POINTS, use_colors="on")
    with pytest.raises(ValueError, match="one has colors and the other intensities"):
        call(POINTS, POINTS, source_colors=COLORS, target_intensity=COLORS[:, 0], use_colors="on")


def test_outlines_have_no_colors() -> None:
    flat = np.column_stack([POINTS[:, :2], np.zeros(50)])
    with pytest.raises(ValueError, match="flat across the axis"):
        pyemtr.register(
            flat, flat, source_colors=COLORS, target_colors=COLORS, axis=(0, 0, 1), use_colors="on"
        )


def test_a_problem_uses_them_as_a_registration_does() -> None:
    case = case_of("box", 1)
    given = {"source_colors": case.source_colors, "target_colors": case.target_colors}
    problem = pyemtr.Problem(case.source, case.target, **given, preset="fast", use_colors="on")
    result = problem.solve()
    other = pyemtr.register(case.source, case.target, **given, preset="fast", use_colors="on")
    assert result.used_colors and result.registered
    assert np.array_equal(result.transformation, other.transformation)
    assert result.color_evidence == other.color_evidence


def test_a_refinement_must_not_be_off() -> None:
    with pytest.raises(ValueError, match="use_colors"):
        pyemtr.register(POINTS, POINTS, source_colors=COLORS, use_colors="on", refine=False)


def test_numbers_beside_the_points_that_are_no_colors_are_none():
    """Nobody asked for them: they change nothing and are no error."""
    rng = np.random.default_rng(0)
    points = rng.uniform(size=(300, 3))
    table = {
        "x": points[:, 0], "y": points[:, 1], "z": points[:, 2],
        "r": rng.normal(size=300), "g": rng.normal(size=300), "b": rng.normal(size=300),
        "intensity": rng.integers(-2048, 2048, 300),
    }  # fmt: skip
    array = np.zeros(300, dtype=[(name, "f8") for name in table])
    for name, values in table.items():
        array[name] = values
    np.testing.assert_array_equal(pyemtr.Cloud(array).points, points)
