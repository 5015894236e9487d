"""Where a cloud is best looked at from."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from .arrays import Floats


@dataclass(frozen=True)
class Camera:
    """An orthographic view; the rows of ``axes`` (3, 3) are right, up and towards the viewer."""

    axes: Floats

    @classmethod
    def towards(cls, direction: Floats, up: Floats) -> Camera:
        """Returns the view against ``direction`` (3,), from the clouds to the viewer."""
        toward = direction / np.linalg.norm(direction)
        right = np.cross(up, toward)
        if np.linalg.norm(right) < 1e-6 * np.linalg.norm(up):  # straight from above or below
            right = np.cross(np.roll(up, 1) + [0.1, 0.2, 0.3], toward)
        right = right / np.linalg.norm(right)
        return cls(np.stack([right, np.cross(toward, right), toward]))

    def visible(self, points: Floats, cell: float) -> float:
        """Returns the share of points (N, 3) that none hides, on a raster of width ``cell``."""
        seen = points @ self.axes.T
        columns = np.floor(seen[:, :2] / cell).astype(np.int64)
        columns -= columns.min(axis=0)
        keys = columns[:, 0] * (columns[:, 1].max() + 1) + columns[:, 1]
        order = np.lexsort((seen[:, 2], keys))
        last = np.append(np.diff(keys[order]) != 0, True)  # nearest to the viewer in its cell
        front = np.repeat(seen[order, 2][last], np.diff(np.flatnonzero(last), prepend=-1))
        return float(np.mean(seen[order, 2] > front - 4 * cell))

    def bulges(self, points: Floats) -> bool:
        """Tells whether points (N, 3) come nearer in the middle, as a shell does from outside."""
        seen = (points - points.mean(axis=0)) @ self.axes.T
        return bool(np.sum(seen[:, 2] * np.sum(seen[:, :2] ** 2, axis=1)) <= 0)

    def rotated(self, degrees: float, up: Floats) -> Camera:
        """Returns the same view from another side, rotated about the vertical axis ``up`` (3,)."""
        x, y, z = up / np.linalg.norm(up)
        angle = math.radians(degrees)
        cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        rotation = np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
        return Camera(self.axes @ rotation.T)


def best_view(points: Floats, up: Floats, gap: float) -> Camera:
    """Returns the view from slightly above that hides the fewest points, from outside the shell.

    ``gap`` is the usual distance between neighbors among points (N, 3).
    """
    up = up / np.linalg.norm(up)
    flat = np.cross(up, np.roll(up, 1) + [0.1, 0.2, 0.3])
    start = Camera.towards(flat / np.linalg.norm(flat) + 0.3 * up, up)
    views = [start.rotated(degrees, up) for degrees in range(0, 360, 10)]
    shares = [camera.visible(points, _cell(gap)) for camera in views]
    # a single layer of points hides as few from behind, so both ends of an axis count together
    best = max(range(18), key=lambda i: shares[i] + shares[i + 18])
    return views[best] if views[best].bulges(points) else views[best + 18]


def side_view(front: Camera, points: Floats, up: Floats, gap: float) -> tuple[str, Camera]:
    """Returns a second view, 50 degrees to the side that hides fewer points."""
    sides = {"left": front.rotated(-50.0, up), "right": front.rotated(50.0, up)}
    return max(sides.items(), key=lambda side: side[1].visible(points, _cell(gap)))


def _cell(gap: float) -> float:
    return 2 * gap or 1.0
