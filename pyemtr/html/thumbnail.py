"""A small picture of two aligned clouds, as a data URL; it needs no other package."""

from __future__ import annotations

import base64
import struct
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats, as_transformation
from ..mesh import MESH_POINTS
from ..points import as_points

WIDTH, HEIGHT = 224, 168
_SOURCE, _TARGET = (240, 140, 40), (60, 135, 205)
_MOST = 20_000  # points of a cloud that are drawn


def thumbnail(
    result: Any,
    source: Any,
    target: Any,
    *,
    up: tuple[float, float, float] = (0.0, 0.0, 1.0),
    mesh_points: int = MESH_POINTS,
) -> str:
    """Draws the moved source on the target, from a little above, as a PNG of 224 x 168 pixels.

    Args:
        result: a :class:`pyemtr.Result`, or a matrix (4, 4), source into target. With a NaN in it
            the target is drawn alone.
        source, target: the clouds, as :func:`pyemtr.register` takes them.
        up: direction (3,) in the target's frame that is up.
        mesh_points: as in :func:`pyemtr.register`.

    Returns:
        "data:image/png;base64,..." for :class:`pyemtr.html.IndexEntry`; nothing is drawn where
        there is no point.

    Raises:
        TypeError, ValueError: not a cloud, or not a matrix.
    """
    fixed = _some(target, "target", mesh_points)
    moving = _some(source, "source", mesh_points)
    known = getattr(result, "transformation", result)
    if np.isfinite(np.asarray(known, dtype=np.float64)).all():
        pose = as_transformation(result, "result")
        moving = moving @ pose[:3, :3].T + pose[:3, 3]
    else:
        moving = moving[:0]
    points = np.concatenate([fixed, moving])
    colors = np.repeat(
        np.array([_TARGET, _SOURCE], dtype=np.float64), [len(fixed), len(moving)], axis=0
    )
    return "data:image/png;base64," + base64.b64encode(_png(_drawn(points, colors, up))).decode()


def _some(cloud: Any, name: str, mesh_points: int) -> Floats:
    points = as_points(cloud, name, mesh_points)
    points = points[:: max(1, len(points) // _MOST)].astype(np.float64)
    return np.asarray(points[np.isfinite(points).all(axis=1)])


def _drawn(points: Floats, colors: Floats, up: tuple[float, float, float]) -> NDArray[np.uint8]:
    """Pixels (H, W, 4): the nearest point of each, darker the farther it is."""
    pixels = np.zeros((HEIGHT, WIDTH, 4), dtype=np.uint8)
    if not len(points):
        return pixels
    seen = (points - np.median(points, axis=0)) @ _axes(up).T
    seen -= np.mean(np.percentile(seen, (0.5, 99.5), axis=0), axis=0)
    reach = np.percentile((np.abs(seen[:, :2]) / (WIDTH, HEIGHT)).max(axis=1), 99.5) * 2.15 or 1.0
    at = np.floor(seen[:, :2] / reach * (1, -1) + (WIDTH / 2, HEIGHT / 2)).astype(np.int64)
    low, high = np.percentile(seen[:, 2], (1, 99))
    light = 0.65 + 0.35 * np.clip((seen[:, 2] - low) / ((high - low) or 1.0), 0, 1)
    order = np.argsort(seen[:, 2], kind="stable")  # what is nearer is drawn later
    for dx, dy in ((0, 0), (1, 0), (0, 1), (1, 1)):
        x, y = (at[order] + (dx, dy)).T
        inside = (x >= 0) & (x < WIDTH) & (y >= 0) & (y < HEIGHT)
        rows = order[inside]
        pixels[y[inside], x[inside], :3] = (colors * light[:, None])[rows].astype(np.uint8)
        pixels[y[inside], x[inside], 3] = 255
    return pixels


def _axes(up: tuple[float, float, float]) -> Floats:
    """Rows: to the right, up on the picture, towards the viewer."""
    upward = np.asarray(up, dtype=np.float64) / np.linalg.norm(up)
    least = np.eye(3)[np.argmin(np.abs(upward))]
    side = np.cross(least, upward)
    side /= np.linalg.norm(side)
    towards = np.cross(side, upward) * 0.8 + upward * 0.6 + 0.3 * side
    towards /= np.linalg.norm(towards)
    right = np.cross(upward, towards)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(towards, right), towards])


def _png(pixels: NDArray[np.uint8]) -> bytes:
    """A PNG file of pixels (H, W, 4), by the two chunks that it needs."""
    height, width, _ = pixels.shape
    rows = np.zeros((height, 1 + 4 * width), dtype=np.uint8)  # a 0 before each: no filter
    rows[:, 1:] = pixels.reshape(height, -1)
    head = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    chunks = ((b"IHDR", head), (b"IDAT", zlib.compress(rows.tobytes(), 9)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(kind, data) for kind, data in chunks)


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
