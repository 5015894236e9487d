"""Pairs of scans of painted surfaces whose pose is known. All are made by a seed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from ..protocol import apply
from ..virtual_pairs.frames import any_pose, between
from .paint import Array, Generator, Paint, plain, posters, tiles

POINTS, NOISE, COLOR_NOISE = 20000, 0.003, 0.03  # a scan; meters; of a color


@dataclass(frozen=True)
class Case:
    """Two scans in frames of their own; `truth` maps source into target."""

    source: Array  # (n, 3), meters
    target: Array
    source_colors: Array | None  # (n, 3), 0 to 1
    target_colors: Array | None
    truth: Array
    source_intensity: Array | None = None  # (n,)
    target_intensity: Array | None = None
    tolerance: float = 0.02  # of a right pose, in the points' unit
    degrees: float = 1.0  # of a right pose


@dataclass(frozen=True)
class Scan:
    """What one sensor saw, in the frame of the scene."""

    points: Array
    colors: Array


def wall(seed: int, *, overlap: float = 0.6) -> Case:
    """A flat wall with posters, of which two scans share a part."""
    rng = np.random.default_rng([1, seed])
    paint = posters(6.0, 3.0, 12, rng)
    width = 4.0
    apart = width * (1 - overlap)
    scans = [_on_wall(paint, center, width, rng) for center in (-apart / 2, apart / 2)]
    return case_from(scans[0], scans[1], rng)


def floor(seed: int, *, marks: int = 40) -> Case:
    """A tiled floor with stains; without marks nothing tells one tile from the next."""
    rng = np.random.default_rng([2, seed])
    paint = tiles(0.4, 6.0, marks, rng)
    scans = [_disc(paint, center, 2.0, rng) for center in ((-0.5, -0.3), (0.5, 0.3))]
    return case_from(scans[0], scans[1], rng)


def box(seed: int) -> Case:
    """A box with square ends and labels on two of its sides; both scans go all around it."""
    rng = np.random.default_rng([3, seed])
    half = np.array([0.3, 0.3, 0.45])
    cardboard = np.array([0.65, 0.5, 0.35])
    paints: list[Paint] = [plain(cardboard)] * 6
    for side in rng.choice(4, 2, replace=False):
        paints[side] = _labelled(cardboard, rng)
    return case_from(_on_box(half, paints, rng), _on_box(half, paints, rng), rng)


def column(seed: int) -> Case:
    """A round column with posters, seen all around."""
    rng = np.random.default_rng([4, seed])
    radius, height = 0.5, 2.4
    paint = posters(2 * np.pi * radius, height, 8, rng)
    return case_from(*(_on_column(paint, radius, height, rng) for _ in range(2)), rng)


def corridor(seed: int) -> Case:
    """Two walls with posters, floor and ceiling: nothing of the shape tells how far along."""
    rng = np.random.default_rng([5, seed])
    paints = [posters(10.0, 2.2, 16, rng), posters(10.0, 2.2, 16, rng),
              tiles(0.5, 10.0, 8, rng), plain(np.array([0.9, 0.9, 0.88]))]  # fmt: skip
    return case_from(*(_in_corridor(paints, x, rng) for x in (-1.2, 1.2)), rng)


def intensity(seed: int) -> Case:
    """The wall as a LiDAR's intensity, which falls off with range, from two places."""
    rng = np.random.default_rng([6, seed])
    paint = posters(6.0, 3.0, 12, rng)
    scans = [_on_wall(paint, center, 4.0, rng) for center in (-0.8, 0.8)]
    received = []
    for scan, x in zip(scans, (-1.2, 1.0)):
        to_sensor = np.array([x, 2.0, rng.uniform(-0.5, 0.5)]) - scan.points
        distance = np.linalg.norm(to_sensor, axis=1)
        reflected = scan.colors.mean(axis=1) * np.abs(to_sensor[:, 1]) / distance / distance**2
        received.append(1000 * reflected * rng.normal(1.0, 0.05, len(distance)).clip(0.5))
    case = case_from(scans[0], scans[1], rng)
    return replace(case, source_colors=None, target_colors=None,
                   source_intensity=received[0], target_intensity=received[1])  # fmt: skip


SCENES: dict[str, Callable[[int], Case]] = {
    "wall": wall, "floor": floor, "box": box, "column": column, "corridor": corridor,
    "intensity": intensity,
}  # fmt: skip


def _on_wall(paint: Paint, center: float, width: float, rng: Generator) -> Scan:
    places = rng.uniform([center - width / 2, -1.4], [center + width / 2, 1.4], (POINTS, 2))
    points = np.column_stack([places[:, 0], np.zeros(POINTS), places[:, 1]])
    return _seen(points, paint(places), np.array([0.0, 1.0, 0.0]), rng)


def _disc(paint: Paint, center: tuple[float, float], radius: float, rng: Generator) -> Scan:
    angle, distance = rng.uniform(0, 2 * np.pi, POINTS), radius * np.sqrt(rng.random(POINTS))
    places = np.column_stack([np.cos(angle), np.sin(angle)]) * distance[:, None] + center
    points = np.column_stack([places, np.zeros(POINTS)])
    return _seen(points, paint(places), np.array([0.0, 0.0, 1.0]), rng)


def _labelled(ground: Array, rng: Generator) -> Paint:
    center, half = rng.uniform(-0.12, 0.12, 2), rng.uniform(0.06, 0.16, 2)
    color, print_color = rng.uniform(0.7, 1.0, 3), rng.uniform(0, 0.4, 3)

    def paint(places: Array) -> Array:
        out = np.tile(ground, (len(places), 1))
        local = (places - center) / half
        label = (np.abs(local) < 1).all(axis=1)
        out[label] = color
        out[label & (np.abs(local[:, 1] * 4 % 2 - 1) < 0.5) & (local[:, 0] < 0.6)] = print_color
        return out

    return paint


def _on_box(half: Array, paints: list[Paint], rng: Generator) -> Scan:
    faces = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for sign in (-1, 1):
            faces.append((axis, sign, u, v, 4 * half[u] * half[v]))
    areas = np.array([face[4] for face in faces])
    counts = np.round(POINTS * areas / areas.sum()).astype(int)
    points, colors, normals = [], [], []
    for (axis, sign, u, v, _), paint, count in zip(faces, paints, counts):
        p, n = np.zeros((count, 3)), np.zeros((count, 3))
        p[:, u], p[:, v] = (
            rng.uniform(-half[u], half[u], count),
            rng.uniform(-half[v], half[v], count),
        )
        p[:, axis], n[:, axis] = sign * half[axis], 1.0
        points.append(p)
        normals.append(n)
        colors.append(paint(p[:, [u, v]]))
    return _seen(np.vstack(points), np.vstack(colors), np.vstack(normals), rng, noise=0.001)


def _on_column(paint: Paint, radius: float, height: float, rng: Generator) -> Scan:
    angle, z = rng.uniform(-np.pi, np.pi, POINTS), rng.uniform(-height / 2, height / 2, POINTS)
    normals = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(POINTS)])
    points = radius * normals + np.column_stack([np.zeros((POINTS, 2)), z])
    return _seen(points, paint(np.column_stack([radius * angle, z])), normals, rng)


def _in_corridor(paints: list[Paint], center: float, rng: Generator) -> Scan:
    n = POINTS // 4
    points, colors, normals = [], [], []
    for side, paint in enumerate(paints):
        along = rng.uniform(center - 3, center + 3, n)
        across = rng.uniform(-1.2, 1.2, n) if side < 2 else rng.uniform(-1.0, 1.0, n)
        p, normal = np.zeros((n, 3)), np.zeros((n, 3))
        p[:, 0] = along
        p[:, 2 if side < 2 else 1] = across
        p[:, 1 if side < 2 else 2] = (1.0 if side < 2 else 1.2) * (1 - 2 * (side % 2))
        normal[:, 1 if side < 2 else 2] = 1.0
        points.append(p)
        normals.append(normal)
        colors.append(paint(np.column_stack([along, across])))
    return _seen(np.vstack(points), np.vstack(colors), np.vstack(normals), rng)


def _seen(
    points: Array, colors: Array, normals: Array, rng: Generator, noise: float = NOISE
) -> Scan:
    """Adds the noise of the range and of the camera, and an exposure of its own."""
    off = rng.normal(scale=noise, size=(len(points), 1))
    exposed = rng.uniform(0.6, 1.0) * colors + rng.uniform(-0.05, 0.1)
    exposed = exposed + rng.normal(scale=COLOR_NOISE, size=colors.shape)
    return Scan(points + off * normals, exposed.clip(0, 1))


def case_from(source: Scan, target: Scan, rng: Generator) -> Case:
    extent = float(np.linalg.norm(np.ptp(target.points, axis=0)))
    a, b = any_pose(rng, extent), any_pose(rng, extent)
    return Case(apply(a, source.points), apply(b, target.points), source.colors, target.colors,
                between(a, b))  # fmt: skip
