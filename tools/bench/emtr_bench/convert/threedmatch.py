"""The test scenes of 3DMatch: fragments in SCENE, the poses of pairs in SCENE-evaluation/gt.log.

A gt.log in another folder called as the scene is one more list of pairs, such as 3DLoMatch's.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from ..pairs import DataError
from .found import Found, ply
from .logs import read_log

GROUP = "threedmatch"
_FRAGMENT = re.compile(r"cloud_bin_(\d+)\.ply")
_SUFFIX = "-evaluation"


def pairs(folders: Sequence[Path]) -> Iterator[Found]:
    scenes = fragments(folders)
    logs = sorted(log for folder in folders for log in folder.rglob("gt.log"))
    for log in logs:
        scene = log.parent.name.replace(_SUFFIX, "")
        if scene not in scenes:
            continue
        low = "_lo" if any("lomatch" in part.casefold() for part in log.parts[:-2]) else ""
        for entry in read_log(log):
            absent = [i for i in (entry.source, entry.target) if i not in scenes[scene]]
            if absent:
                raise DataError(f"{log}: names fragment {absent[0]}, and {scene} has no such file")
            source, target = (scenes[scene][i] for i in (entry.source, entry.target))
            name = f"{scene}{low}_{entry.source}_{entry.target}"
            yield Found(GROUP, name, ply(source), ply(target), entry.pose)


def fragments(folders: Sequence[Path]) -> dict[str, dict[int, Path]]:
    """The files of each scene by their numbers."""
    scenes: dict[str, dict[int, Path]] = {}
    for folder in folders:
        for path in sorted(folder.rglob("cloud_bin_*.ply")):
            match = _FRAGMENT.fullmatch(path.name)
            if match:
                scenes.setdefault(path.parent.name, {})[int(match[1])] = path
    return scenes
