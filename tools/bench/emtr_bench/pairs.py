"""Pairs of clouds with ground truth: where they are, which there are, and how they are read."""

from __future__ import annotations

import csv
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from plyfile import PlyData, PlyParseError

Array = NDArray[np.float64]

REPOSITORY = Path(__file__).resolve().parents[3]

#: The order of the tables; a tier that is not named here comes last.
TIERS = ("paper", "standard", "cad", "scene", "low-overlap", "extreme", "clutter", "sample")


class DataError(Exception):
    """The data are absent or not what was expected; the message names the file."""


FILES = ("source.ply", "target.ply", "T_gt.txt")


@dataclass(frozen=True)
class Pair:
    """One pair on disk: FILES in ``folder``."""

    name: str
    tier: str
    folder: Path
    paper_row: str = ""  # as the manifest has it, "" where the paper has no such row
    size: int = 0  # of the files, in bytes
    group: str = ""  # where it comes from


@dataclass(frozen=True)
class Clouds:
    """A pair in memory, in the user's unit; ``T_gt`` maps source into target."""

    source: Array  # (n, 3)
    target: Array  # (m, 3)
    T_gt: Array  # (4, 4)


def data_folder(argument: str | None = None) -> Path:
    """The folder with ``MANIFEST.csv``, or with a folder for each pair: the argument, else
    EMTR_DATA, else beside the project."""
    chosen = argument or os.environ.get("EMTR_DATA") or REPOSITORY.parent / "shared" / "data"
    folder = Path(chosen)
    if not (folder / "MANIFEST.csv").is_file() and not _pair_folders(folder):
        raise DataError(
            f"no test data: {folder / 'MANIFEST.csv'} does not exist, and no folder in {folder} "
            f"has {', '.join(FILES)} (name the folder by --data or by the environment variable "
            "EMTR_DATA)"
        )
    return folder


def read_manifest(folder: Path) -> list[Pair]:
    """All pairs of a data folder, in the order of the tiers and then of the manifest. Without a
    manifest each folder with FILES is a pair, all of one tier and each from a source of its own."""
    path = folder / "MANIFEST.csv"
    if not path.is_file():
        return [
            Pair(own.name, folder.resolve().name, own, size=_bytes(own), group=own.name)
            for own in _pair_folders(folder)
        ]
    try:
        with path.open(newline="", encoding="utf-8") as file:
            pairs = [_pair(folder, row) for row in csv.DictReader(file)]
    except (KeyError, TypeError, ValueError) as error:
        raise DataError(
            f"{path}: expected the columns group, name and tier in every line: {error!r}"
        ) from error
    return sorted(pairs, key=lambda pair: _tier_rank(pair.tier))


def select(pairs: list[Pair], tiers: list[str], names: list[str]) -> list[Pair]:
    """The pairs of these tiers ("all": every one); given names choose instead of tiers."""
    known = {pair.name for pair in pairs}
    for name in names:
        if name not in known:
            raise DataError(f"--pair {name}: no such pair; there are {', '.join(sorted(known))}")
    known_tiers = list(dict.fromkeys(pair.tier for pair in pairs))
    for tier in tiers:
        if tier != "all" and tier not in known_tiers:
            raise DataError(f"--tier {tier}: no such tier; there are all, {', '.join(known_tiers)}")
    if names:
        return [pair for pair in pairs if pair.name in names]
    return [pair for pair in pairs if "all" in tiers or pair.tier in tiers]


def load(pair: Pair) -> Clouds:
    """Reads both clouds and the ground truth, whose rotation is made exactly orthonormal."""
    return Clouds(
        read_ply(pair.folder / "source.ply"),
        read_ply(pair.folder / "target.ply"),
        read_transformation(pair.folder / "T_gt.txt"),
    )


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
    try:
        matrix = np.loadtxt(path)
    except (OSError, ValueError) as error:
        raise DataError(f"{path}: expected a 4x4 matrix in text: {error}") from error
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all():
        raise DataError(f"{path}: expected a finite 4x4 matrix, got shape {matrix.shape}")
    u, singular, vt = np.linalg.svd(matrix[:3, :3])
    if np.abs(singular - 1.0).max() > 1e-4 or np.linalg.det(u @ vt) < 0.0:
        raise DataError(f"{path}: expected a rigid matrix, got singular values {singular}")
    matrix[:3, :3] = u @ vt
    return np.asarray(matrix, dtype=np.float64)


def _pair(folder: Path, row: dict[str, str]) -> Pair:
    own = folder / "pairs" / row["group"] / row["name"]
    paper_row = row.get("paper_row") or ""
    return Pair(row["name"], row["tier"], own, paper_row, _bytes(own), row["group"])


def _pair_folders(folder: Path) -> list[Path]:
    return sorted(own for own in folder.glob("*") if all((own / name).is_file() for name in FILES))


def _bytes(folder: Path) -> int:
    files = [folder / name for name in FILES]
    return sum(file.stat().st_size for file in files if file.is_file())


def _tier_rank(tier: str) -> int:
    return TIERS.index(tier) if tier in TIERS else len(TIERS)
