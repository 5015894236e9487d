"""The files of a sample pair, written whole or not at all, and read back."""

from __future__ import annotations

import os
import secrets
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

HEADER = """# .PCD v0.7 - Point Cloud Data file format
VERSION 0.7
FIELDS x y z
SIZE 4 4 4
TYPE F F F
COUNT 1 1 1
WIDTH {count}
HEIGHT 1
VIEWPOINT {x:.9g} {y:.9g} {z:.9g} 1 0 0 0
POINTS {count}
DATA binary
"""


def write_whole(path: Path, content: bytes) -> None:
    """Writes beside `path` first, so that a broken run leaves no half file under its name."""
    beside = path.with_name(f".{path.name}.{secrets.token_hex(4)}")
    try:
        with open(beside, "xb") as file:
            file.write(content)
        os.replace(beside, path)
    finally:
        beside.unlink(missing_ok=True)


def write_pcd(path: Path, points: Array, viewpoint: Array) -> None:
    """Binary PCD of points (N, 3); `viewpoint` (3,) is the sensor's position, same frame."""
    x, y, z = viewpoint
    header = HEADER.format(count=len(points), x=x, y=y, z=z)
    write_whole(path, header.encode("ascii") + points.astype("<f4").tobytes())


def read_pcd(path: Path) -> tuple[Array, Array]:
    """Points (N, 3) and viewpoint (3,) of a file made by write_pcd(); no other PCD."""
    content = path.read_bytes()
    head, mark, data = content.partition(b"DATA binary\n")
    fields = dict(line.split(" ", 1) for line in head.decode("ascii").splitlines())
    if not mark or fields["FIELDS"] != "x y z" or len(data) != 12 * int(fields["POINTS"]):
        raise ValueError(f"{path}: not a whole binary PCD with the fields x y z")
    points = np.frombuffer(data, dtype="<f4").reshape(-1, 3).astype(np.float64)
    return points, np.array(fields["VIEWPOINT"].split()[:3], dtype=np.float64)


def write_transformation(path: Path, transformation: Array) -> None:
    """Four rows of four numbers, enough digits to read back the same doubles."""
    rows = [" ".join(f"{value:.17g}" for value in row) for row in transformation]
    write_whole(path, ("\n".join(rows) + "\n").encode("ascii"))
