"""Parts of a map around a place, each preprocessed once."""

from __future__ import annotations

from collections import OrderedDict

import numpy as np

from .arrays import Floats
from .cloud import Cloud
from .looks import Looks

_TILES = 64  # along the longest side of the map
_KEPT = 8  # parts that stay preprocessed, those that were used last


class Submaps:
    """The points of a map by tiles.

    A part is around a place of a grid, so that the places nearby have the same part: what it is
    depends on where one asks, and not on what was asked before.
    """

    def __init__(self, looks: Looks) -> None:
        """Takes finite points, float64, with their colors and intensities."""
        points = looks.points
        low, high = points.min(axis=0), points.max(axis=0)
        edge = max(float((high - low).max()) / _TILES, np.finfo(np.float64).tiny)
        tiles = np.floor((points - low) / edge).astype(np.int64)
        found, index = np.unique(tiles, axis=0, return_inverse=True)
        order = np.argsort(index.ravel(), kind="stable")
        self._looks = looks.rows(order)
        self._begins = np.searchsorted(index.ravel()[order], np.arange(len(found) + 1))
        self._middles = low + (found + 0.5) * edge
        self._corner = edge * np.sqrt(3) / 2
        self._clouds: OrderedDict[tuple[float, ...], Cloud | None] = OrderedDict()

    def around(self, place: Floats, reach: float, threads: int) -> Cloud | None:
        """Returns the map within ``reach`` of a place (3,) and a little beyond, or None where it
        has too few points to be registered with.

        The place is rounded to a grid of a quarter of the reach.
        """
        step = reach / 4
        cell = np.floor(place / step + 0.5)
        key = (*cell.tolist(), reach)
        if key not in self._clouds:
            self._clouds[key] = self._part(cell * step, reach + step, threads)
        self._clouds.move_to_end(key)
        if len(self._clouds) > _KEPT:
            self._clouds.popitem(last=False)
        return self._clouds[key]

    def _part(self, place: Floats, reach: float, threads: int) -> Cloud | None:
        near = np.linalg.norm(self._middles - place, axis=1) <= reach + self._corner
        ranges = [np.arange(*self._begins[i : i + 2]) for i in np.flatnonzero(near)]
        rows = np.concatenate([np.arange(0), *ranges])
        distance = np.linalg.norm(self._looks.points[rows] - place, axis=1)
        try:
            return self._looks.rows(rows[distance <= reach]).cloud(threads)
        except ValueError:  # fewer than ten, or all on one line: nothing to be found there
            return None
