"""Reads all scans of an E57 file as one cloud."""

from __future__ import annotations

from importlib import import_module
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .arrays import Floats

_AXES = ("cartesianX", "cartesianY", "cartesianZ")
_ANGLES = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
_INVALID = ("cartesianInvalidState", "sphericalInvalidState")
_COLORS = ("colorRed", "colorGreen", "colorBlue")
_INTENSITY = "intensity"
_READ = (*_AXES, *_ANGLES, *_INVALID, *_COLORS, _INTENSITY)

_Fields = dict[str, Floats]  # float64 (N,) each


class ScannedPoints(NamedTuple):
    """The points of a file of scans, with what it has beside them."""

    xyz: Any
    colors: Any
    intensity: Any


def read_e57(path: str) -> ScannedPoints:
    """Returns the points of all scans, each moved by its pose: float64 (N, 3).

    Points that the scanner marked as invalid are NaN, so that they are dropped and counted. Colors
    and intensities are there if all scans have them.

    Raises:
        ImportError: pye57 is not installed.
        ValueError: the file cannot be read, or has no scans.
    """
    e57 = import_module("pye57").libe57
    try:
        file = e57.ImageFile(path, "r")
        try:
            root = file.root()
            nodes = list(root["data3D"]) if root.isDefined("data3D") else []
            scans = [_Scan(e57, file, node) for node in nodes if node["points"].childCount() > 0]
        finally:
            file.close()
    except e57.E57Exception as error:
        raise ValueError(str(error).partition("\n")[0]) from error
    if not scans:
        raise ValueError("expected scans with points, got none")
    colors, intensity = _of_all(scans, _COLORS), _of_all(scans, (_INTENSITY,))
    if (
        colors is not None and colors.max() > 1 and not (colors % 1).any()
    ):  # numbers of a byte or two
        colors = colors.astype(np.uint8 if colors.max() <= 255 else np.uint16)
    return ScannedPoints(
        np.concatenate([scan.points() for scan in scans]),
        colors,
        None if intensity is None else intensity[:, 0],
    )


class _Scan:
    """A scan as the file has it, and its pose: rotation w, x, y, z and translation."""

    def __init__(self, e57: Any, file: Any, node: Any) -> None:
        points = node["points"]
        known = e57.StructureNode(points.prototype())
        count = points.childCount()
        self.fields: _Fields = {name: np.empty(count) for name in _READ if known.isDefined(name)}
        buffers = e57.VectorSourceDestBuffer()
        for name, values in self.fields.items():
            buffers.append(e57.SourceDestBuffer(file, name, values, count, True, True))
        points.reader(buffers).read()
        self._rotation = _numbers(node, "rotation", {"w": 1.0, "x": 0.0, "y": 0.0, "z": 0.0})
        self._translation = _numbers(node, "translation", {"x": 0.0, "y": 0.0, "z": 0.0})

    def points(self) -> Floats:
        """Returns the points (N, 3) in the file's frame. The sums are in the command's order."""
        if _AXES[0] in self.fields:
            a, b, c = (self.fields[name] for name in _AXES)
        else:
            distance, azimuth, elevation = (self.fields[name] for name in _ANGLES)
            a = distance * np.cos(elevation) * np.cos(azimuth)
            b = distance * np.cos(elevation) * np.sin(azimuth)
            c = distance * np.sin(elevation)
        w, x, y, z = self._rotation
        rows = (
            (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
        )
        rotated = np.column_stack([row[0] * a + row[1] * b + row[2] * c for row in rows])
        moved: Floats = rotated + np.array(self._translation)
        invalid = self.fields.get(_INVALID[0 if _AXES[0] in self.fields else 1])
        if invalid is not None:
            moved[invalid != 0] = np.nan
        return moved


def _numbers(scan: Any, name: str, otherwise: dict[str, float]) -> list[float]:
    """The numbers of a part of a scan's pose; where they are not there, what they are then."""
    if not scan.isDefined("pose") or not scan["pose"].isDefined(name):
        return list(otherwise.values())
    part = scan["pose"][name]
    return [
        float(part[key].value()) if part.isDefined(key) else value
        for key, value in otherwise.items()
    ]


def _of_all(scans: list[_Scan], names: tuple[str, ...]) -> NDArray[Any] | None:
    """What all scans have, float64 (N, len(names)); None where one lacks it."""
    if not all(name in scan.fields for scan in scans for name in names):
        return None
    return np.concatenate(
        [np.column_stack([scan.fields[name] for name in names]) for scan in scans]
    )
