"""Points of a mesh: even over the area, the same every time, and nothing of its vertices."""

from __future__ import annotations

import types
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pyemtr
from pyemtr.mesh import mesh_of, sample_mesh, triangles


def grid(cuts_x: np.ndarray, cuts_y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A rectangle, cut unevenly into pairs of triangles."""
    x, y = np.meshgrid(cuts_x, cuts_y, indexing="ij")
    vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    corner = np.arange(x.size).reshape(x.shape)[:-1, :-1].ravel()
    right, up = corner + x.shape[1], corner + 1
    faces = np.concatenate(
        [np.column_stack([corner, right, up]), np.column_stack([right, right + 1, up])]
    )
    return vertices, faces


SQUARE = grid(np.array([0.0, 1.0]), np.array([0.0, 1.0]))


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 2**32 - 1), cuts=st.integers(2, 30), count=st.integers(3000, 9000))
def test_equal_areas_have_equally_many_points_however_they_are_cut(seed, cuts, count):
    rng = np.random.default_rng(seed)
    lines = [np.sort(np.append(rng.uniform(0, 1, cuts) ** 3, [0, 1])) for _ in range(2)]
    points = sample_mesh(*grid(*lines), count, "source")
    assert points.shape == (count, 3) and not points[:, 2].any()
    assert (points[:, :2] >= 0).all() and (points[:, :2] <= 1).all()
    shares = np.histogram2d(points[:, 0], points[:, 1], bins=4, range=[[0, 1], [0, 1]])[0] * 16
    assert abs(shares / count - 1).max() < 0.15


def test_points_keep_apart_better_than_random_ones():
    def nearest(points: np.ndarray) -> float:
        squares = ((points[:, None] - points[None]) ** 2).sum(axis=2) + np.eye(len(points)) * 9
        return float(np.sqrt(squares.min(axis=1)).mean())

    even = sample_mesh(*SQUARE, 1000, "source")
    random = np.random.default_rng(0).uniform(size=(1000, 2))
    assert nearest(even[:, :2]) > 1.2 * nearest(random)


def test_the_same_mesh_gives_the_same_points():
    first, second = (sample_mesh(*SQUARE, 777, "source") for _ in range(2))
    assert first.tobytes() == second.tobytes()


def test_points_are_spread_over_the_order_too():
    """So that every tenth of them is a sample of the whole."""
    points = sample_mesh(*grid(np.linspace(0, 1, 20), np.linspace(0, 1, 20)), 5000, "source")[::10]
    assert abs(np.histogram(points[:, 0], 4, (0, 1))[0] / 125 - 1).max() < 0.15


def test_faces_without_area_and_vertices_without_a_face_have_no_points():
    vertices = np.vstack([SQUARE[0], [[50.0, 50, 50], [np.nan, 0, 0]]])
    faces = np.vstack([[[0, 0, 1], [0, 4, 4], [0, 1, 5]], SQUARE[1]])
    points = sample_mesh(vertices, faces, 100, "source")
    assert np.array_equal(points, sample_mesh(*SQUARE, 100, "source"))


@pytest.mark.parametrize(
    "vertices, faces, text",
    [
        (SQUARE[0][:, :2], SQUARE[1], r"vertices of shape \(V, 3\), got \(4, 2\)"),
        (SQUARE[0], [[0, 1, 2, 3]], r"triangles.*\(1, 4\)"),
        (SQUARE[0], [[0.0, 1.0, 2.0]], "whole numbers.*float64"),
        (SQUARE[0], [[0, 1, 4]], "vertex that is not among the 4"),
        (SQUARE[0], [[0, 1, -1]], "vertex that is not among the 4"),
        (SQUARE[0], [[0, 1, 1]], "area is 0"),
        (np.full((4, 3), np.nan), SQUARE[1], "area is 0"),
    ],
)
def test_a_bad_mesh_is_refused_by_name(vertices: Any, faces: Any, text: str):
    mesh = types.SimpleNamespace(vertices=vertices, faces=faces)
    with pytest.raises(ValueError, match=f"^source: .*{text}"):
        pyemtr.register(mesh, np.random.default_rng(0).normal(size=(50, 3)))


def test_faces_are_found_where_each_library_has_them():
    vertices, faces = SQUARE
    corners = vertices[faces]  # what trimesh calls triangles
    bag = types.SimpleNamespace
    tensor = bag(cpu=lambda: bag(numpy=lambda: faces)), bag(cpu=lambda: bag(numpy=lambda: vertices))

    class Map(dict):
        indices = tensor[0]

    for mesh in (
        bag(vertices=vertices, faces=faces, triangles=corners),
        bag(vertices=vertices, triangles=faces),
        bag(vertex=bag(positions=tensor[1]), triangle=Map(indices=0)),
        bag(points=vertices, regular_faces=faces, is_all_triangles=True, n_faces_strict=2),
    ):
        found = mesh_of(mesh, "source")
        assert found is not None
        assert np.array_equal(sample_mesh(*found, 9, "source"), sample_mesh(*SQUARE, 9, "source"))
    quads = bag(points=vertices, regular_faces=None, is_all_triangles=False, n_faces_strict=1)
    with pytest.raises(ValueError, match=r"source: .*triangulate"):
        mesh_of(quads, "source")


def test_polygons_become_triangles():
    assert triangles([[0, 1, 2]]).tolist() == [[0, 1, 2]]
    assert triangles([[0, 1, 2], [4, 5, 6, 7]]).tolist() == [[0, 1, 2], [4, 5, 6], [4, 6, 7]]
    assert triangles([[0, 1]]).shape == (0, 3)


def bumpy(cuts: int) -> types.SimpleNamespace:
    vertices, faces = grid(np.linspace(-1, 1, cuts), np.linspace(-1, 1, cuts))
    x, y = vertices[:, 0], vertices[:, 1]
    vertices[:, 2] = 0.3 * np.sin(3 * x + y) * np.cos(2 * y) + 0.2 * x * y
    return types.SimpleNamespace(vertices=vertices, faces=faces)


@pytest.fixture(scope="module")
def scan() -> np.ndarray:
    x, y = np.random.default_rng(2).uniform(-0.8, 1, (2, 5000))
    z = 0.3 * np.sin(3 * x + y) * np.cos(2 * y) + 0.2 * x * y
    return np.column_stack([z + 3, x, y])


def test_a_scan_is_registered_to_a_mesh_of_few_vertices(scan):
    mesh = bumpy(24)
    result = pyemtr.register(scan, mesh, preset="fast", threads=2)
    assert result.registered and result.points_target == 100_000
    wanted = np.array([[0.0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, -3], [0, 0, 0, 1]])
    np.testing.assert_allclose(result.transformation, wanted, atol=0.01)


def test_mesh_points_reach_every_call(scan):
    mesh = bumpy(8)
    assert len(pyemtr.Cloud(mesh, mesh_points=3000)) == 3000
    quick = {"iterations": 2, "preset": "fast", "threads": 2, "mesh_points": 4000}
    result = pyemtr.register(scan, mesh, **quick)
    assert result.points_target == 4000 and result.settings["mesh_points"] == 4000
    again = pyemtr.register(scan, mesh, **result.settings)
    assert again.transformation.tobytes() == result.transformation.tobytes()
    assert pyemtr.Problem(scan, mesh, **quick).settings["mesh_points"] == 4000
    assert result.residuals(scan, mesh, of="target", mesh_points=4000).shape == (4000,)


@pytest.mark.parametrize(
    "count, error, text",
    [(9, ValueError, "10 or more"), (1e5, TypeError, "integer"), (True, TypeError, "integer")],
)
def test_bad_mesh_points_are_refused(scan, count, error, text):
    for call in (pyemtr.register, pyemtr.Problem, pyemtr.residuals):
        with pytest.raises(error, match=f"^mesh_points: .*{text}"):
            call(scan, scan, mesh_points=count)
    with pytest.raises(error, match=f"^mesh_points: .*{text}"):
        pyemtr.Cloud(scan, mesh_points=count)
