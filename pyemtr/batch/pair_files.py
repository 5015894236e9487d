"""The pairs that a CSV file lists, or a folder of folders has."""

from __future__ import annotations

import csv
import os
from pathlib import Path
from typing import Any

from .cells import setting_of
from .pair import Pair

_FILES = ("source.ply", "target.ply")  # of a folder that is a pair, as docs/BENCHMARKING.md has it


def read_pairs(path: str) -> list[Pair]:
    """Returns the pairs of a CSV file or of a folder.

    A CSV file has the columns ``source`` and ``target``, and may have ``name``, ``preset``,
    ``guess`` (a text file of a 4x4 matrix), ``source_viewpoint``, ``target_viewpoint``, ``axis``
    (three numbers), ``translation_bounds`` (six), ``mesh_points`` and any setting. An empty cell
    means what all pairs have. Relative paths begin at the folder of the file.

    Raises:
        OSError: the file cannot be read.
        ValueError: a column that is not known, a line of another length, a value out of range, by
            its line; a folder without pairs.
    """
    return _folder(path) if os.path.isdir(path) else _table(path)


def _table(path: str) -> list[Pair]:
    folder = os.path.dirname(os.path.abspath(path))
    with open(path, newline="", encoding="utf-8-sig") as file:
        lines = csv.reader(file, strict=True)
        try:
            names = _columns(next(lines, []), path)
            return [
                _row(index, dict(zip(names, cells)), folder, f"{path}: line {line}")
                for index, (line, cells) in enumerate(_rows(lines, len(names), path))
            ]
        except (csv.Error, UnicodeDecodeError) as error:
            raise ValueError(f"{path}: line {lines.line_num}: {error}") from error


def _columns(header: list[str], path: str) -> list[str]:
    names = [name.strip().replace("-", "_") for name in header]
    for needed in ("source", "target"):
        if needed not in names:
            raise ValueError(f"{path}: line 1: expected a column called {needed}")
    for i, name in enumerate(names):
        if name in names[:i]:
            raise ValueError(f"{path}: line 1: two columns are called {name}")
        if name not in ("source", "target", "name"):
            try:
                setting_of(name, "", "")
            except ValueError as error:
                raise ValueError(f"{path}: line 1: {error}") from None
    return names


def _rows(lines: Any, count: int, path: str) -> Any:
    for cells in lines:
        if not cells:
            continue
        if len(cells) != count:
            raise ValueError(
                f"{path}: line {lines.line_num}: expected {count} cells, got {len(cells)}"
            )
        yield lines.line_num, cells


def _row(index: int, cells: dict[str, str], folder: str, place: str) -> Pair:
    source, target = cells.pop("source"), cells.pop("target")
    name = cells.pop("name", "") or None
    for column, cell in (("source", source), ("target", target)):
        if not cell:
            raise ValueError(f"{place}: {column}: expected a file, got nothing")
    try:
        settings = {
            key: setting_of(key, cell.strip(), folder)
            for key, cell in cells.items()
            if cell.strip()
        }
    except (OSError, TypeError, ValueError) as error:
        raise ValueError(f"{place}: {error}") from error
    return Pair(
        index,
        name,
        os.path.join(folder, source),
        os.path.join(folder, target),
        source,
        target,
        settings,
    )


def _folder(path: str) -> list[Pair]:
    names = sorted(
        Path(folder).relative_to(path).as_posix()
        for folder, _, files in os.walk(path)
        if all(file in files for file in _FILES)
    )
    if not names:
        raise ValueError(f"{path}: no folder in it has {' and '.join(_FILES)}")
    pairs = []
    for index, name in enumerate(names):
        texts = [file if name == "." else f"{name}/{file}" for file in _FILES]
        source, target = (os.path.join(path, text) for text in texts)
        called = os.path.basename(os.path.abspath(path)) if name == "." else name
        pairs.append(Pair(index, called, source, target, texts[0], texts[1]))
    return pairs
