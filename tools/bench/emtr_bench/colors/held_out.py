"""Scenes of which no threshold knows: other prints, shapes, sizes, units and sensors."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..protocol import apply
from . import prints
from .paint import Array, Generator, Paint, plain
from .scenes import Case, Scan, case_from
from .sensor import Sensor

POINTS = 20000  # of a scan, about
PLACES = 60000  # that it may see
SHARE = 0.005  # of the extent: how far off a right pose may be


def mosaic(rng: Generator) -> Case:
    """A wall of small stones."""
    paint = prints.mosaic(rng.uniform(0.15, 0.3), 8.0, rng)
    return _wall(prints.with_pictures(paint, 4.0, 2.0, 1, rng), rng)


def wallpaper(rng: Generator, things: Generator | None = None) -> Case:
    """A wall of one motif, and a few pictures: at least one where the scans overlap."""
    ground, things = prints.wallpaper(rng), things or rng
    inside = prints.with_pictures(ground, 1.0, 1.6, 1, things)
    return _wall(prints.with_pictures(inside, 5.0, 2.4, int(things.integers(1, 4)), things), rng)


def facade(rng: Generator) -> Case:
    """A house front with rows of windows."""
    paint = prints.facade(rng)
    return _wall(paint, rng, size=(9.0, 6.0))


def ceiling(rng: Generator) -> Case:
    """Panels and lamps."""
    return _disc(prints.lamps(8.0, rng), 2.8, rng)


def carpet(rng: Generator) -> Case:
    """A floor whose shades change without an edge."""
    return _disc(prints.cloudy(rng.uniform(0.25, 0.4), 0.45, 0.12, rng), 1.5, rng)


def road(rng: Generator) -> Case:
    """A road with lane marks, by color."""
    return _wall(prints.lanes(18.0, rng), rng, size=(14.0, 7.0))


def road_intensity(rng: Generator) -> Case:
    """The road by a LiDAR's intensity, which falls off with range and angle."""
    case = road(rng)
    shades = [colors.mean(axis=1) for colors in (case.source_colors, case.target_colors)
              if colors is not None]  # fmt: skip
    received = []
    for points, shade in zip((case.source, case.target), shades):
        center = points.mean(axis=0)
        _, _, axes = np.linalg.svd(points - center, full_matrices=False)
        sensor = center + axes[0] * rng.uniform(-4, 4) + axes[1] * rng.uniform(-2, 2)
        to_sensor = sensor + axes[2] * rng.uniform(1.7, 2.2) - points
        distance = np.linalg.norm(to_sensor, axis=1)
        cosine = np.abs(to_sensor @ axes[2]) / distance
        received.append(rng.uniform(10, 1e4) * (shade + 0.02) * cosine / distance**2)
    return replace(case, source_colors=None, target_colors=None,
                   source_intensity=received[0], target_intensity=received[1])  # fmt: skip


def parcel(rng: Generator) -> Case:
    """A parcel with square ends and two or three labels, in millimeters."""
    a, b = rng.uniform(0.1, 0.2), rng.uniform(0.22, 0.35)
    half = np.array([a, a, b])
    blank = plain(rng.uniform(0.5, 0.7) * np.array([1.0, 0.8, 0.6]))
    paints: list[Paint] = [blank] * 6
    for side in rng.choice(4, rng.integers(2, 4), replace=False):
        axis = side // 2
        paints[side] = prints.label(half[[(axis + 1) % 3, (axis + 2) % 3]], rng)
    return _scaled(_scans(lambda _: _box(half, paints, rng), rng), 1000)


def can(rng: Generator) -> Case:
    """A can with a printed label all around, in millimeters."""
    radius, height = rng.uniform(0.03, 0.05), rng.uniform(0.1, 0.17)
    around = 2 * np.pi * radius
    scale = around / 4.0  # the prints are made for walls
    print_ = prints.with_pictures(plain(rng.uniform(0, 1, 3)), 3.2, height / scale, 5, rng)

    def look(_: float) -> tuple[Array, Array, Array]:
        angle, z = rng.uniform(-np.pi, np.pi, PLACES), rng.uniform(-height / 2, height / 2, PLACES)
        normals = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(PLACES)])
        points = radius * normals + np.column_stack([np.zeros((PLACES, 2)), z])
        return points, print_(np.column_stack([radius * angle, z]) / scale), normals

    return _scaled(_scans(look, rng), 1000)


def things(rng: Generator) -> Case:
    """Boxes on a floor: their shape is enough."""
    floor = prints.cloudy(0.4, 0.5, 0.15, rng)
    boxes = [(rng.uniform(-1.3, 1.3, 2), rng.uniform(0.1, 0.35, 3), rng.uniform(0, np.pi),
              [prints.label(np.full(2, 0.3), rng)] * 6) for _ in range(7)]  # fmt: skip

    def look(_: float) -> tuple[Array, Array, Array]:
        parts = [_flat(floor, -1.8, 1.8, -1.8, 1.8, 30000, rng)]
        for center, half, angle, paints in boxes:
            c, s = np.cos(angle), np.sin(angle)
            pose = np.eye(4)
            pose[:2, :2], pose[:3, 3] = [[c, -s], [s, c]], [*center, half[2]]
            p, colors, n = _box(half, paints, rng, 5000)
            parts.append((apply(pose, p), colors, n @ pose[:3, :3].T))
        return _mixed(parts, rng)

    return _scans(look, rng)


def hotel(rng: Generator) -> Case:
    """Two rooms with one wallpaper and different pictures: they do not belong together."""
    same = rng.integers(2**32)
    one, other = (wallpaper(np.random.default_rng(same), rng) for _ in range(2))
    return replace(one, target=other.target, target_colors=other.target_colors)


HELD_OUT: dict[str, Callable[[Generator], Case]] = {
    "mosaic": mosaic, "wallpaper": wallpaper, "facade": facade, "ceiling": ceiling,
    "carpet": carpet, "road": road, "road_intensity": road_intensity, "parcel": parcel,
    "can": can, "things": things, "hotel": hotel,
}  # fmt: skip


def _scans(look: Callable[[float], tuple[Array, Array, Array]], rng: Generator) -> Case:
    """Two scans by two sensors; `look` takes -1 and 1."""
    scans: list[Scan] = [Sensor.any(rng, POINTS).see(*look(side), rng) for side in (-1.0, 1.0)]
    case = case_from(scans[0], scans[1], rng)
    return replace(case, tolerance=SHARE * float(np.linalg.norm(np.ptp(scans[1].points, axis=0))))


def _scaled(case: Case, unit: float) -> Case:
    truth = case.truth.copy()
    truth[:3, 3] *= unit
    return replace(case, source=unit * case.source, target=unit * case.target, truth=truth,
                   tolerance=unit * case.tolerance)  # fmt: skip


def _wall(paint: Paint, rng: Generator, size: tuple[float, float] = (4.0, 2.6)) -> Case:
    width, height = size
    half, apart = width / 2, width * rng.uniform(0.2, 0.45) / 2

    def look(side: float) -> tuple[Array, Array, Array]:
        x, up = side * apart, rng.uniform(-0.1, 0.1) * height
        return _flat(paint, x - half, x + half, up - height / 2, up + height / 2, PLACES, rng)

    return _scans(look, rng)


def _disc(paint: Paint, radius: float, rng: Generator) -> Case:
    apart = radius * rng.uniform(0.15, 0.4)

    def look(side: float) -> tuple[Array, Array, Array]:
        p, colors, n = _flat(paint, side * apart - radius, side * apart + radius,
                             -radius, radius, PLACES, rng)  # fmt: skip
        within = np.linalg.norm(p - [side * apart, 0, 0], axis=1) < radius
        return p[within], colors[within], n[within]

    return _scans(look, rng)


def _flat(
    paint: Paint, left: float, right: float, low: float, high: float, count: int, rng: Generator
) -> tuple[Array, Array, Array]:
    places = rng.uniform([left, low], [right, high], (count, 2))
    points = np.column_stack([places, np.zeros(count)])
    return points, paint(places), np.tile([0.0, 0.0, 1.0], (count, 1))


def _box(
    half: Array, paints: list[Paint], rng: Generator, count: int = PLACES
) -> tuple[Array, Array, Array]:
    """All six sides; `paints` of -x, x, -y, y, -z, z."""
    areas = np.repeat([half[1] * half[2], half[2] * half[0], half[0] * half[1]], 2)
    parts = []
    for side, (paint, share) in enumerate(zip(paints, areas / areas.sum())):
        axis, sign = side // 2, 2.0 * (side % 2) - 1
        u, v = (axis + 1) % 3, (axis + 2) % 3
        n = np.zeros((int(count * share), 3))
        n[:, axis] = sign
        p = half[axis] * n
        p[:, [u, v]] = rng.uniform(-1, 1, (len(n), 2)) * half[[u, v]]
        parts.append((p, paint(p[:, [u, v]]), n))
    return _mixed(parts, rng)


def _mixed(parts: list[tuple[Array, Array, Array]], rng: Generator) -> tuple[Array, Array, Array]:
    order = rng.permutation(sum(len(part[0]) for part in parts))
    p, colors, n = (np.vstack(columns)[order] for columns in zip(*parts))
    return p, colors, n
