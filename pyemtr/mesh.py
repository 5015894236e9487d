"""A mesh is a surface: points spread evenly over its faces, the same every time."""

from __future__ import annotations

import operator
from typing import Any

import numpy as np

from .arrays import Floats, real_array

#: Points taken of a mesh, unless the caller says how many; as many as the command takes.
MESH_POINTS = 100_000

# Inverse powers of the plastic number: their multiples, modulo 1, cover a square evenly.
_STEPS = np.array([0.7548776662466927, 0.5698402909980532])


def sample_mesh(vertices: Any, faces: Any, count: int, name: str) -> Floats:
    """Returns points float64 (count, 3) on a mesh, as many for each area, in the order of faces.

    Point i belongs to the face in which the (i + 1/2) / count share of the area ends; its place
    within the face follows a sequence of low discrepancy. There is no random number in it.
    The command samples a mesh by the same points.

    Args:
        vertices: (V, 3) in any unit.
        faces: integers (F, 3), rows of the vertices.
        count: the number of points, 1 or more.
        name: what error messages call the mesh.

    Raises:
        TypeError: not numbers.
        ValueError: another shape, a face of vertices that are not there, or no area.
    """
    corners = _corners(real_array(vertices, name), np.asarray(faces), name)
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    ends = _area_ends(first, second)
    if not (ends.size and 0.0 < ends[-1] < np.inf):
        raise ValueError(f"{name}: expected a mesh with a surface, got one whose area is 0")
    index = np.arange(count)
    face = np.searchsorted(ends, (index + 0.5) / count * ends[-1], side="right")
    along, across = ((index[:, None] + 1) * _STEPS % 1.0).T
    along = np.sqrt(along)[:, None]  # a triangle is wider towards its far side
    across = across[:, None]
    return np.asarray(
        corners[face, 0] + along * ((1 - across) * first[face] + across * second[face])
    )


def _area_ends(first: Floats, second: Floats) -> Floats:
    """Twice the area of all triangles up to each, by two of their edges (F, 3)."""
    with np.errstate(invalid="ignore", over="ignore"):
        areas = np.linalg.norm(np.cross(first, second), axis=1)
    return np.cumsum(np.where(np.isfinite(areas), areas, 0.0))  # no point has a NaN


def has_area(vertices: Floats, faces: Any) -> bool:
    """Tells whether points can be spread over faces (F, 3), rows of vertices that are there."""
    corners = vertices[faces]
    ends = _area_ends(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return bool(ends.size and 0.0 < ends[-1] < np.inf)


def as_mesh_points(count: Any) -> int:
    """Returns the argument ``mesh_points``.

    Raises:
        TypeError: not an integer.
        ValueError: below 10, with which no cloud can be registered, and not 0.
    """
    if isinstance(count, bool) or not hasattr(count, "__index__"):
        raise TypeError(f"mesh_points: expected an integer, got {count!r}")
    number = operator.index(count)
    if number < 10 and number != 0:
        raise ValueError(f"mesh_points: expected 10 or more, or 0 for the vertices, got {count!r}")
    return number


def mesh_of(thing: Any, name: str) -> tuple[Any, Any] | None:
    """Returns vertices and triangles of a mesh by trimesh, Open3D (of both kinds) or PyVista; None
    for an object without faces.

    Raises:
        ValueError: faces that are no triangles.
    """
    if hasattr(thing, "vertex") and hasattr(thing, "triangle"):  # tensors
        if "indices" not in thing.triangle:
            return None
        found = thing.vertex.positions.cpu().numpy(), thing.triangle.indices.cpu().numpy()
    elif hasattr(thing, "regular_faces") and hasattr(thing, "is_all_triangles"):  # PyVista
        if thing.n_faces_strict == 0:
            return None
        if not thing.is_all_triangles:
            raise ValueError(f"{name}: expected a mesh of triangles: triangulate() it")
        found = thing.points, thing.regular_faces
    else:
        # A trimesh has both: its triangles are corners.
        faces = next((getattr(thing, a) for a in ("faces", "triangles") if hasattr(thing, a)), None)
        if faces is None or not hasattr(thing, "vertices"):
            return None
        found = thing.vertices, faces
    return found if len(found[1]) else None


def triangles(polygons: list[Any]) -> Any:
    """Returns polygons, lists of vertices, as triangles (F, 3) that share the first vertex."""
    if all(len(polygon) == 3 for polygon in polygons):
        return np.array(polygons, dtype=np.int64).reshape(-1, 3)
    return np.array(
        [(p[0], p[i], p[i + 1]) for p in polygons for i in range(1, len(p) - 1)], dtype=np.int64
    ).reshape(-1, 3)


def _corners(vertices: Any, faces: Any, name: str) -> Floats:
    if vertices.ndim != 2 or vertices.shape[1] != 3:
        raise ValueError(f"{name}: expected vertices of shape (V, 3), got {vertices.shape}")
    if faces.ndim != 2 or faces.shape[1] != 3 or faces.dtype.kind not in "iu":
        raise ValueError(
            f"{name}: expected triangles, whole numbers of shape (F, 3), got {faces.dtype}"
            f" {faces.shape}"
        )
    if faces.size and not 0 <= faces.min() <= faces.max() < len(vertices):
        raise ValueError(f"{name}: a face names a vertex that is not among the {len(vertices)}")
    return np.asarray(vertices[faces], dtype=np.float64)
