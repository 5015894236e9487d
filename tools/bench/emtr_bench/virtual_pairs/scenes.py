"""The ten pairs: scans of the sample shape, a ball, a table, rooms and a street."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from ..bumpy_ball import ball_pair
from ..locations import TOOLS
from ..pairs import Array
from .frames import Scan, any_pose, between, upright_pose

sys.path.insert(0, str(TOOLS))  # where the scanner is
from virtual_scan import places, rays, scanner
from virtual_scan.solids import Solid

#: Azimuth and elevation, degrees, of the scans of the sample shape.
_DRAGON = ((-42, 22), (28, 14), (75, 20), (140, 10), (200, 25))
_DRAGON_POINTS, _DRAGON_NOISE = 6000, 0.1  # noise in mm
_BALL_POINTS = 5000


@dataclass(frozen=True)
class Made:
    """A pair in memory, each cloud in a frame of its own; T_gt maps source into target, None where
    the two do not belong together."""

    group: str
    name: str
    tier: str
    source: Array  # (n, 3)
    target: Array  # (m, 3)
    T_gt: Array | None
    sensors: Array | None = None  # (2, 3), each in its cloud's frame


def all_pairs(seed: int = 1) -> Iterator[Made]:
    """The same seed makes the same pairs. Their names share a word where they share an object."""
    rng = np.random.default_rng(seed)
    dragon = [_dragon(*view, rng) for view in _DRAGON]
    yield _pair("objects", "dragon_front", "standard", dragon[0], dragon[1], rng)
    yield _pair("objects", "dragon_back", "standard", dragon[3], dragon[4], rng)
    yield _pair("objects", "dragon_apart", "low-overlap", dragon[0], dragon[2], rng)
    ball = ball_pair(_BALL_POINTS, seed)
    source, target = (cloud.astype(np.float64) for cloud in (ball.source, ball.target))
    yield Made("objects", "ball_bumps", "standard", source, target, ball.T_true)
    things = [_table(azimuth, rng) for azimuth in (0, 110)]
    yield _pair("objects", "table_things", "standard", *things, rng)
    room = [_room(places.living_room, *view, rng) for view in _ROOM]
    yield _pair("rooms", "room_sofa", "standard", room[1], room[2], rng)
    yield _pair("rooms", "room_shelves", "low-overlap", room[0], room[1], rng)
    other = _room(places.office, *_ROOM[1], rng)
    yield _pair("rooms", "two_rooms", "unrelated", room[0], other, rng, related=False)
    street = [_street(x, y, rng) for x, y in ((-14.0, 0.4), (-8.0, -0.5), (7.0, -0.5))]
    yield _pair("streets", "street_near", "standard", street[0], street[1], rng, upright_pose)
    yield _pair("streets", "street_far", "low-overlap", street[0], street[2], rng, upright_pose)


#: Where the camera is in the room, and what it looks at, meters.
_ROOM = (
    ((-1.5, -1.2, 1.5), (1.5, 1.5, 0.6)),
    ((1.8, -1.0, 1.7), (-1.5, 1.6, 0.7)),
    ((0.0, -1.3, 1.6), (-0.5, 1.9, 0.9)),
)


def _pair(
    group: str,
    name: str,
    tier: str,
    source: Scan,
    target: Scan,
    rng: np.random.Generator,
    pose: Callable[[np.random.Generator, float], Array] = any_pose,
    related: bool = True,
) -> Made:
    """Both scans in frames of their own: the source's is any, the target's as `pose` says."""
    a, b = any_pose(rng, source.extent), pose(rng, target.extent)
    moved = [scan.moved(T) for scan, T in ((source, a), (target, b))]
    sensors = np.stack([scan.sensor for scan in moved])
    T_gt = between(a, b) if related else None
    return Made(group, name, tier, moved[0].points, moved[1].points, T_gt, sensors)


def _dragon(azimuth: float, elevation: float, rng: np.random.Generator) -> Scan:
    seen = scanner.scan(scanner.viewpoint(azimuth, elevation), _DRAGON_POINTS, _DRAGON_NOISE, rng)
    return Scan(seen.points, seen.viewpoint)


def _table(azimuth: float, rng: np.random.Generator) -> Scan:
    a, elevation, away = np.radians(azimuth), np.radians(35.0), 1.1
    level = away * np.cos(elevation)
    eye = np.array([level * np.cos(a), level * np.sin(a), away * np.sin(elevation)])
    sight = rays.camera(eye, np.zeros(3), half_angle=27.0, columns=140, rows=105)
    return Scan(rays.see(places.table_top(), eye, sight, 0.0015, 3.0, rng), eye)


def _room(
    place: Callable[[], list[Solid]],
    eye: tuple[float, ...],
    look_at: tuple[float, ...],
    rng: np.random.Generator,
) -> Scan:
    at = np.array(eye)
    sight = rays.camera(at, np.array(look_at), half_angle=35.0, columns=96, rows=72)
    return Scan(rays.see(place(), at, sight, 0.004, 8.0, rng), at)


def _street(x: float, y: float, rng: np.random.Generator) -> Scan:
    eye = np.array([x, y, 1.8])
    sight = rays.spinning(-22.0, 12.0, beams=32, steps=400, start=rng.uniform(0.0, 360.0))
    return Scan(rays.see(places.street(), eye, sight, 0.02, 45.0, rng), eye)
