"""What a reader of a set finds: two clouds and the pose between them, not read yet."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from ..pairs import Array, read_ply

Cloud = Callable[[], Array]  # () -> points (n, 3)


@dataclass(frozen=True)
class Found:
    """A pair of a set. `tier` is "" where the overlap says it; `paired` by the set itself, rather
    than one of all pairs of its scans."""

    group: str
    name: str
    source: Cloud
    target: Cloud
    T_gt: Array  # (4, 4), source into target
    tier: str = ""
    paired: bool = True


@dataclass(frozen=True)
class Placed:
    """A scan and its pose (4, 4), which maps it into a frame that several share."""

    path: Path
    pose: Array


def all_pairs(group: str, name: str, scans: Sequence[Placed]) -> Iterator[Found]:
    """Each scan with each that comes before it, which is the target."""
    for number, source in enumerate(scans):
        for target in scans[:number]:
            T = rigid_inverse(target.pose) @ source.pose
            called = f"{name}_{source.path.stem}_{target.path.stem}"
            yield Found(group, called, ply(source.path), ply(target.path), T, paired=False)


def ply(path: Path) -> Cloud:
    return lambda: _cached_ply(path)


def rigid_inverse(T: Array) -> Array:
    R = T[:3, :3].T
    inverse = np.eye(4)
    inverse[:3, :3], inverse[:3, 3] = R, -R @ T[:3, 3]
    return inverse


@lru_cache(maxsize=16)
def _cached_ply(path: Path) -> Array:
    return read_ply(path)
