"""ModelNet: meshes of CAD shapes, of which two partial clouds are drawn.

As the RPM-Net paper does it: 1024 points of each of two independent samples, the shape scaled into
the unit ball, noise of 0.01 cut at 0.05, and a half-space that leaves 70 % of each. The pose is
known by making: the target is rotated by up to 45 degrees about each axis and moved by up to 0.5.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from ..pairs import Array, DataError
from ..protocol import apply, euler_zyx
from .found import Found

GROUP, TIER = "modelnet", "cad"
POINTS, KEPT = 1024, 0.7
NOISE, MOST_NOISE = 0.01, 0.05
ANGLE, DISTANCE = np.radians(45.0), 0.5


def pairs(folders: Sequence[Path], per_category: int) -> Iterator[Found]:
    """The first test shapes of each category, or the first shapes where none is for tests."""
    categories: dict[str, list[Path]] = {}
    for folder in folders:
        for path in sorted(folder.rglob("*.off")):
            categories.setdefault(path.stem.rpartition("_")[0] or path.stem, []).append(path)
    for shapes in categories.values():
        tests = [path for path in shapes if path.parent.name == "test"]
        for path in (tests or shapes)[:per_category]:
            source, target, T = two_samples(*read_off(path), zlib.crc32(path.stem.encode()))
            name = f"{path.stem}_crop"
            yield Found(GROUP, name, lambda c=source: c, lambda c=target: c, T, TIER)


def two_samples(vertices: Array, faces: Array, seed: int) -> tuple[Array, Array, Array]:
    """Source (716, 3), target (716, 3), and the pose (4, 4) that maps the one into the other."""
    rng = np.random.default_rng(seed)
    middle = (vertices.max(axis=0) + vertices.min(axis=0)) / 2
    unit = (vertices - middle) / np.linalg.norm(vertices - middle, axis=1).max()
    T = np.eye(4)
    T[:3, :3] = euler_zyx(rng.uniform(0.0, ANGLE, 3))
    T[:3, 3] = rng.uniform(-DISTANCE, DISTANCE, 3)
    source, target = (_cropped(_sampled(unit, faces, rng), rng) for _ in range(2))
    return source, apply(T, target), T


def read_off(path: Path) -> tuple[Array, Array]:
    """Vertices (n, 3) and triangles (m, 3) of an OFF file; faces of more corners become fans. Some
    of the set's files have the counts in the first line, right behind OFF."""
    words = path.read_text(errors="replace").split()
    try:
        if not words or not words[0].startswith("OFF"):
            raise ValueError("it does not begin with OFF")
        words = ([words[0][3:]] if words[0] != "OFF" else []) + words[1:]
        count, face_count = int(words[0]), int(words[1])
        end = 3 + 3 * count
        vertices = np.array(words[3:end], dtype=np.float64).reshape(count, 3)
        triangles, at = [], end
        for _ in range(face_count):
            corners = [int(word) for word in words[at + 1 : at + 1 + int(words[at])]]
            triangles += [(corners[0], *two) for two in zip(corners[1:], corners[2:])]
            at += 1 + len(corners)
        faces = np.array(triangles, dtype=np.int64).reshape(-1, 3)
        if not len(faces) or faces.min() < 0 or faces.max() >= count:
            raise ValueError("a face names a vertex that is not there, or there is no face")
    except (ValueError, IndexError) as error:
        raise DataError(f"{path}: expected a mesh in OFF format: {error}") from error
    return vertices, faces


def _sampled(vertices: Array, faces: Array, rng: np.random.Generator) -> Array:
    """Points (POINTS, 3), uniform over the surface."""
    a, b, c = (vertices[faces[:, i]] for i in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    chosen = rng.choice(len(faces), POINTS, p=areas / areas.sum())
    u, v = rng.random((2, POINTS, 1))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    return np.asarray(a[chosen] + u * (b - a)[chosen] + v * (c - a)[chosen])


def _cropped(points: Array, rng: np.random.Generator) -> Array:
    """With noise, and without what lies beyond a plane of any direction."""
    noise = np.clip(rng.normal(0.0, NOISE, points.shape), -MOST_NOISE, MOST_NOISE)
    normal = rng.normal(size=3)
    order = np.argsort(points @ normal)
    return np.asarray((points + noise)[np.sort(order[: int(KEPT * len(points))])])
