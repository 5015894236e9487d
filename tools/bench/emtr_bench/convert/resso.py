"""RESSO: scans of buildings, and a text file with the pose of each in a common frame.

The file has the number of scans in its first line; then for each scan a line with its file's name
and four lines of a matrix.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from ..pairs import DataError
from .found import Found, Placed, all_pairs
from .logs import published

GROUP = "resso"


def pairs(folders: Sequence[Path]) -> Iterator[Found]:
    for folder in folders:
        for path in sorted(folder.rglob("*.txt")):
            lines = path.read_text(errors="replace").splitlines()
            if is_list(lines):
                yield from all_pairs(GROUP, path.parent.name, read_poses(path))


def is_list(lines: list[str]) -> bool:
    """Tells a file of poses from another text: a number, and then the name of a cloud."""
    words = [line.split() for line in lines if line.split()][:2]
    return (
        len(words) == 2
        and len(words[0]) == len(words[1]) == 1
        and words[0][0].isdigit()
        and words[1][0].casefold().endswith(".ply")
    )


def read_poses(path: Path) -> list[Placed]:
    """The scans of the list. Raises DataError, which names the file."""
    lines = [line.split() for line in path.read_text(errors="replace").splitlines() if line.split()]
    count, rows = int(lines[0][0]), lines[1:]
    scans = []
    try:
        if len(rows) != 5 * count:
            raise ValueError(f"got {len(rows)} lines")
        for head in range(0, len(rows), 5):
            matrix = np.array([[float(word) for word in row] for row in rows[head + 1 : head + 5]])
            if matrix.shape != (4, 4):
                raise ValueError(f"got a matrix of shape {matrix.shape}")
            scans.append(Placed(_cloud(path, rows[head][0]), published(matrix, path)))
    except ValueError as error:
        raise DataError(
            f"{path}: expected {count} scans, five lines each: a file and a 4x4 matrix: {error}"
        ) from error
    return scans


def _cloud(path: Path, name: str) -> Path:
    found = next(iter(sorted(path.parent.rglob(Path(name).name))), None)
    if found is None:
        raise DataError(f"{path}: names {name}, which is not beside it")
    return found
