"""The value of a setting that is written in a cell of a table."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np

from ..options import Setting, Value, make_settings, presets, settings
from ..suggestions import unknown_setting

_VECTORS = {"source_viewpoint": 3, "target_viewpoint": 3, "axis": 3, "translation_bounds": 6}
_OTHERS = ("preset", "guess", "mesh_points", *_VECTORS)


def setting_of(name: str, cell: str, folder: str) -> Any:
    """Returns the value of a keyword argument of :func:`pyemtr.register`; of an empty cell nothing,
    but the name is checked. Relative paths begin at ``folder``.

    Raises:
        ValueError: an unknown name, or a cell that is not of its kind or out of range.
        OSError: a file that cannot be read.
    """
    known = _settings()
    if name not in known and name not in _OTHERS:
        texts = {**{key: one.text for key, one in known.items()}, **dict.fromkeys(_OTHERS, "")}
        raise ValueError(f"{unknown_setting(name, texts)}")
    if not cell:
        return None
    if name == "guess":
        return _matrix(os.path.join(folder, cell))
    if name in _VECTORS:
        numbers = _vector(name, cell, _VECTORS[name])
        return [numbers[:3], numbers[3:]] if len(numbers) == 6 else numbers
    return _single(name, cell)


@lru_cache(maxsize=1)
def _settings() -> dict[str, Setting]:
    return settings()


@lru_cache(maxsize=4096)
def _single(name: str, cell: str) -> Value:
    if name == "preset":
        if cell not in presets():
            raise ValueError(f"preset: {cell!r} is not one of {', '.join(presets())}")
        return cell
    if name == "mesh_points":
        return _whole(name, cell)
    if name in ("seed", "threads"):
        whole = _whole(name, cell)
        make_settings("default", {}, **{name: whole})  # type: ignore[arg-type]
        return whole
    value = _READERS[_settings()[name].type](name, cell)
    make_settings("default", {name: value})
    return value


def _whole(name: str, cell: str) -> int:
    if not re.fullmatch(r"[0-9]+", cell):
        raise ValueError(f"{name}: expected a whole number, got {cell!r}")
    return int(cell)


def _real(name: str, cell: str) -> float:
    try:
        return float(cell)
    except ValueError:
        raise ValueError(f"{name}: expected a number, got {cell!r}") from None


def _switch(name: str, cell: str) -> bool:
    if cell not in ("on", "off", "1", "0"):
        raise ValueError(f"{name}: expected on, off, 1 or 0, got {cell!r}")
    return cell in ("on", "1")


_READERS: dict[str, Callable[[str, str], Value]] = {
    "integer": _whole,
    "real": _real,
    "switch": _switch,
    "choice": lambda _, cell: cell,
}


def _vector(name: str, cell: str, count: int) -> list[float]:
    numbers = [_real(name, word) for word in cell.split()]
    if len(numbers) != count or not np.isfinite(numbers).all():
        raise ValueError(f"{name}: expected {count} numbers with blanks between, got {cell!r}")
    return numbers


def _matrix(path: str) -> list[list[float]]:
    try:
        matrix = np.loadtxt(path)
    except ValueError as error:
        raise ValueError(f"guess: {path}: {error}") from error
    if matrix.shape != (4, 4):
        raise ValueError(f"guess: {path}: expected a 4x4 matrix, got {matrix.shape}")
    rows: list[list[float]] = matrix.tolist()
    return rows
