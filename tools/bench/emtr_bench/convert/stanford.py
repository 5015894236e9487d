"""The Stanford 3D Scanning Repository: range scans, and a .conf with the pose of each.

A line of the .conf is ``bmesh FILE tx ty tz qx qy qz qw``. The quaternion is that of the inverse
rotation: a point p of the scan is at R(q)^T p + t in the frame that the scans of a .conf share.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from ..pairs import Array, DataError
from .found import Found, Placed, all_pairs

GROUP = "stanford"


def pairs(folders: Sequence[Path]) -> Iterator[Found]:
    for folder in folders:
        for conf in sorted(folder.rglob("*.conf")):
            scans = read_conf(conf)
            missing = [scan.path.name for scan in scans if not scan.path.is_file()]
            if missing:
                print(f"left out: {conf} names {', '.join(missing)}, not there")
            yield from all_pairs(GROUP, conf.stem, [s for s in scans if s.path.is_file()])


def read_conf(path: Path) -> list[Placed]:
    """The scans that a .conf names; none of a .conf of something else."""
    scans = []
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        words = line.split()
        if not words or words[0] not in ("bmesh", "mesh"):
            continue
        try:
            tx, ty, tz, qx, qy, qz, qw = (float(word) for word in words[2:9])
        except ValueError as error:
            raise DataError(
                f"{path}:{number}: expected bmesh FILE tx ty tz qx qy qz qw, got {line!r}"
            ) from error
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = rotation(qx, qy, qz, qw).T, (tx, ty, tz)
        scans.append(Placed(path.parent / words[1], pose))
    return scans


def rotation(x: float, y: float, z: float, w: float) -> Array:
    """The rotation (3, 3) of a quaternion, which need not be of length one."""
    x, y, z, w = np.array([x, y, z, w]) / np.linalg.norm([x, y, z, w])
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + 2.0 * (w * cross + cross @ cross))
