"""The synthetic pairs of Fast Global Registration: a folder each, two depth views and a log."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from ..pairs import DataError
from .found import Found, ply
from .logs import read_log

GROUP = "fgr"
VIEWS = ("Depth_0000.ply", "Depth_0001.ply")
LOG = "gt.log"
_FOLDER = re.compile(r"pairwise_(no_noise|noise_xyz_level_(\d+))_(\d+)")


def pairs(folders: Sequence[Path]) -> Iterator[Found]:
    for folder in folders:
        for first in sorted(folder.rglob(VIEWS[0])):
            place = first.parent
            absent = [name for name in (*VIEWS, LOG) if not (place / name).is_file()]
            if absent:
                print(f"left out: {place} has no {' and no '.join(absent)}")
                continue
            for entry in read_log(place / LOG):
                source, target = (_view(place, i) for i in (entry.source, entry.target))
                yield Found(GROUP, name_of(place.name), ply(source), ply(target), entry.pose)


def name_of(folder: str) -> str:
    """``fgr_n1_18`` for ``pairwise_noise_xyz_level_01_18_rot_05``: noise level and view."""
    match = _FOLDER.match(folder)
    return folder if match is None else f"fgr_n{int(match[2] or 0)}_{match[3]}"


def _view(place: Path, number: int) -> Path:
    path = place / f"Depth_{number:04}.ply"
    if not path.is_file():
        raise DataError(f"{place / LOG}: names view {number}, and there is no {path.name}")
    return path
