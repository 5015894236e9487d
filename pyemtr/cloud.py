"""One cloud made ready for many registrations."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _emtr
from .arrays import Floats, as_points
from .options import thread_setting


class Cloud:
    """Points read, measured and, when they are many, thinned: once, for any number of partners.

    Stands in for an array wherever :func:`pyemtr.register`, :class:`pyemtr.Problem` and the tasks
    take one, as source or as target, with the same bits as result::

        model = pyemtr.Cloud(points)
        results = [pyemtr.register(scan, model) for scan in scans]

    Never changes and keeps nothing of the caller's memory; threads may share one.

    Args:
        points: as :func:`pyemtr.register` takes them, (N, 3) in any unit.
        threads: 0 for as many as OpenMP would use; the cloud does not depend on it.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N, 3), or a cloud that cannot be registered (fewer than 10 finite points,
            all on one point or one line).
    """

    def __init__(self, points: Any, *, threads: int = 0) -> None:
        self._raw = _emtr.Prepared(as_points(points, "points"), "", thread_setting(threads))
        self._info: dict[str, Any] = self._raw.describe()

    def __len__(self) -> int:
        """How many finite points there are."""
        return int(self._info["points"])

    @property
    def dropped(self) -> int:
        """How many points with a NaN or an infinity were left out."""
        return int(self._info["dropped"])

    @property
    def center(self) -> Floats:
        """Centroid of the finite points: float64 (3,), in their unit."""
        return np.array(self._info["center"], dtype=np.float64)

    @property
    def radius(self) -> float:
        """Largest distance of a point from the centroid, in their unit."""
        return float(self._info["radius"])

    def __repr__(self) -> str:
        dropped = f", {self.dropped} dropped" if self.dropped else ""
        return f"<pyemtr.Cloud: {len(self)} points{dropped}, radius {self.radius:.6g}>"


def as_cloud(cloud: Any, name: str) -> NDArray[Any] | _emtr.Prepared:
    """What the C library reads: a prepared cloud, or points as :func:`as_points` makes them."""
    return cloud._raw if isinstance(cloud, Cloud) else as_points(cloud, name)
