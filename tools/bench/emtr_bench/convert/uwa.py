"""The UWA set of objects in clutter: models, scenes, and MODEL-SCENE.xf, the pose of one in the
other: a 4x4 matrix that maps the model into the scene."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from ..pairs import Array, DataError
from .found import Found, ply
from .logs import published

GROUP = "uwa"
_POSE = re.compile(r"(.+)-(rs\d+)\.xf")


def pairs(folders: Sequence[Path]) -> Iterator[Found]:
    clouds = sorted(path for folder in folders for path in folder.rglob("*.ply"))
    for xf in sorted(path for folder in folders for path in folder.rglob("*.xf")):
        match = _POSE.fullmatch(xf.name)
        if match is None:
            continue
        model, scene = _model(match[1], clouds), _scene(match[2], clouds)
        if model is None or scene is None:
            what = f"model {match[1]}" if model is None else f"scene {match[2]}"
            print(f"left out: {xf.name}: no cloud of the {what}")
            continue
        name = f"{match[1].replace('-', '').casefold()}_{match[2]}"
        yield Found(GROUP, name, ply(model), ply(scene), read_xf(xf), "clutter")


def read_xf(path: Path) -> Array:
    """The pose (4, 4), model into scene."""
    try:
        matrix = np.loadtxt(path)
    except ValueError as error:
        raise DataError(f"{path}: expected a 4x4 matrix in text: {error}") from error
    if matrix.shape != (4, 4):
        raise DataError(f"{path}: expected a 4x4 matrix in text, got shape {matrix.shape}")
    return published(np.asarray(matrix, dtype=np.float64), path)


def _model(name: str, clouds: list[Path]) -> Path | None:
    """The file whose name begins as the model's: chef's is cheff.ply. The shortest of several."""
    found = [path for path in clouds if path.stem.casefold().startswith(name.casefold())]
    return min(found, key=lambda path: (len(path.stem), path), default=None)


def _scene(name: str, clouds: list[Path]) -> Path | None:
    return next((path for path in clouds if path.stem.casefold() == name), None)
