"""The scans that are aligned: where they come from, and those that are in memory."""

from __future__ import annotations

import os
import threading
from collections import OrderedDict
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ..arrays import Floats
from ..cloud import Cloud
from ..cloud_files import FORMATS, ending_of, read_cloud
from ..mesh import mesh_of
from ..points import as_points
from .colors import Rows, rows_of
from .surface import Surface, make_surface

#: Preprocessed clouds that are in memory at a time; pairs are registered in blocks of half as many.
CACHED = 32


class Extent(NamedTuple):
    """Where a scan is in its own frame."""

    center: Floats  # (3,), the centroid
    radius: float


class Scans:
    """Reads scans when they are needed. Threads may share it.

    A cloud that was given by its path is read again whenever it is needed and is not among the last
    CACHED. Its surface is kept.
    """

    def __init__(self, clouds: Any, names: Sequence[str] | None, mesh_points: int) -> None:
        self._clouds = _listed(clouds)
        self.names = _named(self._clouds, names)
        self._mesh_points = mesh_points
        self._lock = threading.Lock()
        self._locks = [threading.Lock() for _ in self._clouds]
        self._cache: OrderedDict[int, Cloud] = OrderedDict()
        self._surfaces: dict[int, Surface] = {}
        self._extents: dict[int, Extent] = {}

    def __len__(self) -> int:
        return len(self._clouds)

    def cloud(self, index: int) -> Cloud:
        """Returns a scan preprocessed; raises as :class:`pyemtr.Cloud`, with the scan's name."""
        with self._locks[index]:  # so that no two threads read one scan
            with self._lock:
                found = self._cache.get(index)
            if found is None:
                found = self._preprocessed(index)
            with self._lock:
                self._cache[index] = found
                self._cache.move_to_end(index)
                if len(self._cache) > CACHED:
                    self._cache.popitem(last=False)
        return found

    def surface(self, index: int) -> Surface:
        """Returns a scan's thinned surface."""
        if index not in self._surfaces:
            self._preprocessed(index)
        return self._surfaces[index]

    def extent(self, index: int) -> Extent:
        """Returns a scan's centroid and radius."""
        if index not in self._extents:
            self.cloud(index)
        return self._extents[index]

    def rows(self, index: int) -> Rows:
        """Reads all finite points of a scan, with the colors and normals that it has."""
        given = self._clouds[index]
        name = f"clouds[{index}]"
        if isinstance(given, (str, os.PathLike)):
            path = os.fspath(given)
            given, name = read_cloud(path, name), f"{name}: {path}"
        points = given.points if isinstance(given, Cloud) else given
        taken = as_points(points, name, self._mesh_points)
        # The colors of a mesh belong to its vertices, and the points are spread over its faces.
        plain = mesh_of(given, name) is not None
        return rows_of(taken if plain else given, taken, name)

    def _preprocessed(self, index: int) -> Cloud:
        given = self._clouds[index]
        points = self.rows(index).points
        name = self.names[index]
        try:
            cloud = given if isinstance(given, Cloud) else Cloud(points, threads=1)
        except ValueError as error:
            raise ValueError(f"clouds[{index}] ({name}): {error}") from error
        extent = Extent(cloud.center, cloud.radius)
        if index not in self._surfaces:
            near = np.linalg.norm(points - extent.center, axis=1) <= extent.radius * 1.0001
            self._surfaces[index] = make_surface(points[near], extent.radius)
            self._extents[index] = extent
        return cloud


def _listed(clouds: Any) -> list[Any]:
    """Returns the scans of a folder, or those of a list, as a list."""
    if isinstance(clouds, (str, os.PathLike)):
        folder = Path(clouds)
        if not folder.is_dir():
            raise NotADirectoryError(f"clouds: {folder}: expected a folder, or a list of clouds")
        clouds = sorted(
            path for path in folder.iterdir() if ending_of(str(path)) in FORMATS and path.is_file()
        )
        if len(clouds) < 2:
            raise ValueError(
                f"clouds: {folder}: expected two or more files that end in"
                f" {', '.join(FORMATS)}, got {len(clouds)}"
            )
        return list(clouds)
    if isinstance(clouds, np.ndarray) or not isinstance(clouds, Iterable):
        raise TypeError(
            f"clouds: expected a list of clouds or a folder, got {type(clouds).__name__}"
        )
    listed = list(clouds)
    if len(listed) < 2:
        raise ValueError(f"clouds: expected two or more, got {len(listed)}")
    return listed


def _named(clouds: Sequence[Any], names: Sequence[str] | None) -> list[str]:
    """Returns a name for each scan: the one given, its file's, or its number."""
    if names is None:
        width = len(str(len(clouds) - 1))
        found = [
            Path(os.fspath(cloud)).name
            if isinstance(cloud, (str, os.PathLike))
            else f"scan_{i:0{width}d}"
            for i, cloud in enumerate(clouds)
        ]
        if len(set(found)) == len(found):
            return found
        return [f"{i:0{width}d}_{name}" for i, name in enumerate(found)]
    found = [str(name) for name in names]
    if len(found) != len(clouds) or len(set(found)) != len(found):
        raise ValueError(f"names: expected {len(clouds)} different names, got {found}")
    return found
