"""Points with their colors or intensities, to make parts of a cloud."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .cloud import Beside, Cloud, rows_of


class Looks(NamedTuple):
    """Points, float32 or float64 (N, 3); their colors, float32 (N, 3) from 0 to 1, and intensities,
    float32 (N,), or None."""

    points: NDArray[Any]
    colors: NDArray[np.float32] | None = None
    intensity: NDArray[np.float32] | None = None

    @property
    def is_bare(self) -> bool:
        """True where there are neither colors nor intensities."""
        return self.colors is None and self.intensity is None

    def rows(self, which: NDArray[Any]) -> Looks:
        """Returns the rows of a mask or of indices."""
        return Looks(
            self.points[which],
            None if self.colors is None else self.colors[which],
            None if self.intensity is None else self.intensity[which],
        )

    def finite(self) -> Looks:
        """Returns the points that are finite, as float64."""
        kept = self.rows(np.isfinite(self.points).all(axis=1))
        return kept._replace(points=kept.points.astype(np.float64))

    def cloud(self, threads: int) -> Cloud:
        """Returns them preprocessed. Raises ValueError where they cannot be registered."""
        return Cloud(self.points, colors=self.colors, intensity=self.intensity, threads=threads)


def looks_of(cloud: Any, name: str, mesh_points: int) -> Looks:
    """Returns the points of what users call a cloud, with the colors and intensities that it has.

    Raises as :class:`pyemtr.Cloud`, and TypeError for one that did not keep its points.
    """
    rows = rows_of(cloud, name, Beside(), mesh_points)
    plain = None if rows.intensity is None else rows.intensity.reshape(-1)
    return Looks(rows.points, rows.colors, plain)
