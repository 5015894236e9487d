"""Pairs of clouds with ground truth, and how they are read."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from plyfile import PlyData, PlyParseError

from .unknown_scale import split

Array = NDArray[np.float64]

#: The files of a pair; the last may say NONE.
FILES = ("source.ply", "target.ply", "T_gt.txt")
NONE = "none"  # for a pose: the scans do not belong together
VIEWPOINTS = "viewpoints.txt"  # one more, that need not be there


class DataError(Exception):
    """The data are absent or not what was expected; the message names the file."""


@dataclass(frozen=True)
class Pair:
    """One pair on disk: FILES in ``folder``."""

    name: str
    tier: str
    folder: Path
    paper_row: str = ""  # as the manifest has it, "" where the paper has no such row
    size: int = 0  # of the files, in bytes
    group: str = ""  # where it comes from
    related: bool = True  # there is a right pose


@dataclass(frozen=True)
class Clouds:
    """A pair in memory, in the user's unit; ``T_gt`` maps source into target."""

    source: Array  # (n, 3)
    target: Array  # (m, 3)
    T_gt: Array  # (4, 4)


def load(pair: Pair) -> Clouds:
    """Reads both clouds and the ground truth, whose rotation is made exactly orthonormal. Where
    that is a similarity, the source is given the target's scale."""
    source, target = (read_ply(pair.folder / name) for name in FILES[:2])
    path = pair.folder / FILES[2]
    scale, T_gt = split(read_matrix(path))
    if scale <= 0 or abs(scale - 1.0) < 1e-3:
        return Clouds(source, target, read_transformation(path))
    return Clouds(scale * source, target, nearest_rigid(T_gt, path))


def viewpoints(pair: Pair) -> Array | None:
    """Where the sensors were, (2, 3): the source's in the source's frame, the target's in the
    target's. None where no file says it."""
    path = pair.folder / VIEWPOINTS
    if not path.is_file():
        return None
    try:
        rows = np.loadtxt(path, ndmin=2)
    except ValueError as error:
        raise DataError(f"{path}: expected two lines of three numbers: {error}") from error
    if rows.shape != (2, 3) or not np.isfinite(rows).all():
        raise DataError(f"{path}: expected two lines of three finite numbers, got {rows.shape}")
    return np.asarray(rows, dtype=np.float64)


def read_ply(path: Path) -> Array:
    """The x, y and z of a PLY file's vertices, (n, 3) float64."""
    try:
        vertex = PlyData.read(str(path))["vertex"]
        return np.stack([np.asarray(vertex[axis], dtype=np.float64) for axis in "xyz"], axis=1)
    except (OSError, PlyParseError, KeyError, ValueError) as error:
        raise DataError(f"{path}: expected a PLY file with vertices x, y, z: {error}") from error


def read_transformation(path: Path) -> Array:
    """A rigid 4x4 matrix from text. Ten printed digits leave R a little off: the nearest
    rotation is taken, so that the error metrics see no more than the pose's own error."""
    return nearest_rigid(read_matrix(path), path)


def read_matrix(path: Path) -> Array:
    """A finite 4x4 matrix from text."""
    try:
        matrix = np.loadtxt(path)
    except (OSError, ValueError) as error:
        raise DataError(f"{path}: expected a 4x4 matrix in text: {error}") from error
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all():
        raise DataError(f"{path}: expected a finite 4x4 matrix, got shape {matrix.shape}")
    return np.asarray(matrix, dtype=np.float64)


def nearest_rigid(matrix: Array, path: Path) -> Array:
    """The matrix (4, 4) with the nearest rotation. Raises DataError, which names the file, where
    that is not very near."""
    u, singular, vt = np.linalg.svd(matrix[:3, :3])
    if np.abs(singular - 1.0).max() > 1e-4 or np.linalg.det(u @ vt) < 0.0:
        raise DataError(f"{path}: expected a rigid matrix, got singular values {singular}")
    rigid = matrix.copy()
    rigid[:3, :3] = u @ vt
    return rigid
