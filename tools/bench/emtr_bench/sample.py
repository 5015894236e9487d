"""The generated pair that stands in where no test data are: tools/sample_pair.py."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
from plyfile import PlyData, PlyElement

from .pairs import REPOSITORY, Array, DataError, Pair

TOOLS = REPOSITORY / "tools"


def sample_pair(folder: Path) -> Pair:
    """Makes the pair in `folder` and gives it the layout of the test data."""
    clouds = sample_clouds(folder)
    for name, cloud in zip(("source", "target"), clouds):
        write_ply(folder / f"{name}.ply", cloud)
    (folder / "T_true.txt").rename(folder / "T_gt.txt")
    return Pair("sample", "sample", folder, size=sum(cloud.nbytes for cloud in clouds))


def sample_clouds(folder: Path, points: int = 40000) -> tuple[Array, Array]:
    """Makes the pair, of about so many points a cloud, in `folder`: (n, 3) and (m, 3)."""
    command = [sys.executable, str(TOOLS / "sample_pair.py"), "--out", str(folder)]
    command += ["--points", str(points)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise DataError(f"no sample pair: {' '.join(command)} failed:\n{done.stderr.strip()}")
    sys.path.insert(0, str(TOOLS))  # where sample_pair.py itself finds its modules
    from virtual_scan.files import read_pcd

    source, target = (read_pcd(folder / f"{name}.pcd")[0] for name in ("source", "target"))
    return source, target


def write_ply(path: Path, points: np.ndarray) -> None:
    """Points (n, 3) as a binary PLY of float32 vertices."""
    vertices = np.empty(len(points), dtype=[(axis, "<f4") for axis in "xyz"])
    for column, axis in enumerate("xyz"):
        vertices[axis] = points[:, column]
    PlyData([PlyElement.describe(vertices, "vertex")], byte_order="<").write(str(path))
