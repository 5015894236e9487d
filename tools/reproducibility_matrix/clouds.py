"""The pairs that are registered: a generated one, and real ones where they are present."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float32]  # (n, 3)

GENERATED = "generated"
REAL = (
    "stanford/bunny_045_000",
    "fgr/angel_n1_18",
    "uwa/trex_03_01",
    "lidar/kitti_05_00",
    "threedmatch/redkitchen_1_0_3dmatch",
)


def load(name: str, data: Path) -> tuple[Points, Points]:
    """Returns source and target. Raises FileNotFoundError when `data` has no such pair."""
    if name == GENERATED:
        return generated()
    folder = data / "pairs" / name
    return read_ply(folder / "source.ply"), read_ply(folder / "target.ply")


def read_ply(path: Path) -> Points:
    import plyfile

    vertex = plyfile.PlyData.read(str(path))["vertex"]
    return np.column_stack([vertex[axis] for axis in "xyz"]).astype(np.float32)


def generated() -> tuple[Points, Points]:
    """Returns two parts of one relief that share three quarters."""
    rng = np.random.default_rng(3)
    u, v = rng.uniform(-1, 1, (2, 9000))
    relief = 0.3 * np.sin(3 * u + v) * np.cos(2 * v) + 0.2 * np.exp(-8 * ((u - 0.3) ** 2 + v**2))
    points = np.column_stack([u, v, relief]) + rng.normal(0, 0.002, (9000, 3))
    rotation = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0]])
    source = points[u > -0.5] @ rotation + [4, 5, 6]
    return source.astype(np.float32), points[u < 0.6].astype(np.float32)


def write_pcd(path: Path, points: Points) -> Path:
    header = (
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
        f"WIDTH {len(points)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(points)}\n"
        "DATA binary\n"
    )
    path.write_bytes(header.encode() + points.astype("<f4").tobytes())
    return path
