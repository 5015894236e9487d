"""Where a sensor is in a map: scan after scan against a map that is preprocessed once."""

from __future__ import annotations

from dataclasses import dataclass
from time import perf_counter
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from .arrays import Floats, as_transformation, as_vector
from .cloud import Cloud
from .looks import looks_of
from .mesh import MESH_POINTS, as_mesh_points
from .options import make_settings, require_rigid
from .registration import register
from .result import Result
from .submaps import Submaps

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .setting_types import MethodSettings

_RADIUS = 0.25  # of a scan's radius: how far its centroid may have moved since the last scan
_DEGREES = 45.0
_SURE = 0.99  # what is less confident near the last pose is compared with the whole map


@dataclass(frozen=True, eq=False)
class Location:
    """Where a scan is in the map, and how far to trust it.

    Attributes:
        pose: float64 (4, 4), scan -> map, q = R p + t, in the map's unit. It may be wrong where
            ``registered`` is False.
        registered: whether the pose is trusted.
        confidence: estimated probability that the pose is right.
        by: how it was found: near a "guess" of the caller, near the "last pose", or by a "search"
            of the whole map.
        result: of the registration that the pose is of.
        seconds: wall time, that of a guess in vain included.
    """

    pose: Floats
    registered: bool
    confidence: float
    by: Literal["guess", "last pose", "search"]
    result: Result
    seconds: float


class Localizer:
    """Finds scans in a map, one after the other.

    A scan is looked for near the guess, or near where the last one was found, within a radius and
    in that part of the map alone. If what is found there is not registered, the whole map is
    searched. What is not registered changes nothing: the last pose stays. ::

        localizer = pyemtr.Localizer(map_points, axis=(0, 0, 1), axis_tilt=3)
        for scan in scans:
            location = localizer.localize(scan)
            if location.registered:
                print(location.pose)  # scan -> map

    The same scans in the same order give the same bits, for any number of threads. Threads may not
    share a localizer; each may have its own of one ``map`` that is a :class:`pyemtr.Cloud`.

    Args:
        map: points as :func:`pyemtr.register` takes them, in the scans' unit; a
            :class:`pyemtr.Cloud` must have kept its points. Its colors or intensities are compared
            with those of the scans, as the setting ``use_colors`` says.
        axis: (3,), the direction that is up in the map and in the scans, as of leveled sensors; the
            setting ``axis_tilt`` says how level, in degrees. None: any rotation.
        sensor: (3,), where the sensor is in the scans' frame; None where that is not known.
        radius: how far the scan's centroid may be from where a guess or the last pose puts it, in
            the map's unit. None: a quarter of the scan's radius.
        degrees: how far the rotation may be from that of a guess or the last pose.
        seed, threads, preset, mesh_points: as in :func:`pyemtr.register`.
        **settings: any of :func:`pyemtr.settings` by name, for every scan.

    Raises:
        TypeError, ValueError, OSError, ImportError: as :class:`pyemtr.Cloud` and
            :func:`pyemtr.register`, for the map and the settings.
    """

    def __init__(
        self,
        map: Any,
        *,
        axis: Any = None,
        sensor: Any = (0.0, 0.0, 0.0),
        radius: float | None = None,
        degrees: float = _DEGREES,
        seed: int = 0,
        threads: int = 0,
        preset: str = "default",
        mesh_points: int = MESH_POINTS,
        **settings: Unpack[MethodSettings],
    ) -> None:
        make_settings(preset, {**settings}, seed=seed, threads=threads)  # type: ignore[dict-item]
        require_rigid(settings)
        if {"guess_translation", "guess_rotation"} & settings.keys():
            raise TypeError("guess_translation, guess_rotation: give radius= and degrees= instead")
        self._mesh_points = as_mesh_points(mesh_points)
        given = looks_of(map, "map", self._mesh_points)
        self._map = map if isinstance(map, Cloud) else given.cloud(threads)
        if settings.get("use_colors") == "on" and given.is_bare:
            raise ValueError(
                "map: has neither colors nor intensities, expected some for use_colors on"
            )
        self._submaps = Submaps(given.finite())
        self._radius = None if radius is None else _positive("radius", radius)
        self._degrees = _positive("degrees", degrees)
        self._arguments: dict[str, Any] = {
            "seed": seed,
            "threads": threads,
            "preset": preset,
            "axis": None if axis is None else as_vector(axis, "axis", 3),
            "source_viewpoint": None if sensor is None else as_vector(sensor, "sensor", 3),
            **settings,
        }
        self._last: Floats | None = None

    @property
    def last_pose(self) -> Floats | None:
        """float64 (4, 4), scan -> map, of the last scan that was registered; None before the first
        one and after :meth:`forget`."""
        return None if self._last is None else self._last.copy()

    def forget(self) -> None:
        """Forgets the last pose, as when the robot was carried away: the next scan without a guess
        is looked for in the whole map."""
        self._last = None

    def localize(
        self,
        scan: Any,
        guess: Any = None,
        radius: float | None = None,
        degrees: float | None = None,
    ) -> Location:
        """Returns where a scan is in the map.

        Args:
            scan: points as :func:`pyemtr.register` takes them, in the map's unit.
            guess: (4, 4), scan -> map, as of odometry. None: the last pose.
            radius, degrees: how far from the guess, instead of those of the localizer.

        Raises:
            TypeError, ValueError, OSError, MemoryError: as :func:`pyemtr.register`; a guess that is
                no rigid transformation, a radius that is not above 0.
        """
        begin = perf_counter()
        cloud = scan if isinstance(scan, Cloud) else self._cloud(scan)
        by: Literal["guess", "last pose"] = "last pose" if guess is None else "guess"
        start = self._last if guess is None else as_transformation(guess, "guess")
        near: Result | None = None
        if start is not None:
            limit = radius if radius is not None else self._radius
            limit = _RADIUS * cloud.radius if limit is None else _positive("radius", limit)
            angle = self._degrees if degrees is None else _positive("degrees", degrees)
            result = self._near(cloud, start, limit, angle)
            if result is not None and result.registered:
                if guess is not None or result.confidence >= _SURE:
                    return self._located(result, by, begin)
                near = result
        found = register(cloud, self._map, **self._arguments)
        if near is not None and not (found.registered and found.confidence > near.confidence):
            return self._located(near, by, begin)
        return self._located(found, "search", begin)

    def _cloud(self, scan: Any) -> Cloud:
        threads = self._arguments["threads"]
        try:
            return Cloud(scan, threads=threads, mesh_points=self._mesh_points)
        except (TypeError, ValueError) as error:
            raise type(error)(f"scan: {str(error).removeprefix('points: ')}") from error

    def _near(self, scan: Cloud, start: Floats, radius: float, degrees: float) -> Result | None:
        """Returns the result in the part of the map around a pose; None where the map is empty."""
        place = start[:3, :3] @ scan.center + start[:3, 3]
        part = self._submaps.around(place, scan.radius + radius, self._arguments["threads"])
        if part is None:
            return None
        return register(
            scan,
            part,
            guess=start,
            guess_translation=radius,
            guess_rotation=min(degrees, 180.0),
            **{**self._arguments, "fallback_search": "off"},
        )

    def _located(
        self, result: Result, by: Literal["guess", "last pose", "search"], begin: float
    ) -> Location:
        pose = result.transformation
        if result.registered:
            self._last = pose.copy()
        seconds = perf_counter() - begin
        return Location(pose, result.registered, result.confidence, by, result, seconds)


def _positive(name: str, value: float) -> float:
    number = float(value)
    if not 0 < number < np.inf:
        raise ValueError(f"{name}: expected a number above 0, got {value!r}")
    return number
