"""A folder of pairs: what is in it, and how a pair gets into it."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from plyfile import PlyData, PlyElement

from .pairs import FILES, NONE, VIEWPOINTS, Array, DataError, Pair
from .whole_file import write_whole

MANIFEST = "MANIFEST.csv"
COLUMNS = ("group", "name", "tier", "n_source", "n_target", "overlap_source", "overlap_target")

#: The order of the tables; a tier that is not named here comes last.
TIERS = ("paper", "standard", "cad", "scene", "low-overlap", "extreme", "clutter")


def read_folder(folder: Path) -> list[Pair]:
    """All pairs of a folder, in the order of the tiers and then of the manifest. Without a manifest
    each folder with FILES, at any depth, is a pair; the folder around it is its tier and group.
    Raises DataError for a folder without pairs, half a pair, and a name that two have."""
    path = folder / MANIFEST
    pairs = _listed(path) if path.is_file() else _found(folder)
    if not pairs:
        raise DataError(
            f"no pairs in {folder}: it has no {MANIFEST}, and no folder in it has "
            f"{', '.join(FILES)}. docs/BENCHMARKING.md shows the layout"
        )
    twice = [name for name, count in Counter(pair.name for pair in pairs).items() if count > 1]
    if twice:
        raise DataError(f"{folder}: two pairs are called {twice[0]}; each needs a name of its own")
    return sorted(pairs, key=lambda pair: _tier_rank(pair.tier))


def write_pair(
    folder: Path, source: Array, target: Array, T_gt: Array | None, sensors: Array | None = None
) -> None:
    """The files of one pair. T_gt (4, 4) maps source into target, None for scans that do not belong
    together; sensors (2, 3) are their places, each in its own cloud's frame."""
    folder.mkdir(parents=True, exist_ok=True)
    write_ply(folder / FILES[0], source)
    write_ply(folder / FILES[1], target)
    write_whole(folder / FILES[2], f"{NONE}\n" if T_gt is None else _text(T_gt))
    if sensors is not None:
        write_whole(folder / VIEWPOINTS, _text(sensors))


def write_ply(path: Path, points: Array) -> None:
    """Points (n, 3) as a binary PLY of float32 vertices, whole or not at all."""
    vertices = np.empty(len(points), dtype=[(axis, "<f4") for axis in "xyz"])
    for column, axis in enumerate("xyz"):
        vertices[axis] = points[:, column]
    content = io.BytesIO()
    PlyData([PlyElement.describe(vertices, "vertex")], byte_order="<").write(content)
    write_whole(path, content.getvalue())


def write_manifest(folder: Path, rows: Iterable[dict[str, str]]) -> None:
    """The list of the pairs in ``folder/pairs/<group>/<name>``, a row each, with COLUMNS and what
    others the rows have."""
    rows, content = list(rows), io.StringIO()
    columns = dict.fromkeys([*COLUMNS, *(name for row in rows for name in row)])
    writer = csv.DictWriter(content, list(columns), restval="", lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    write_whole(folder / MANIFEST, content.getvalue())


def _listed(path: Path) -> list[Pair]:
    try:
        with path.open(newline="", encoding="utf-8") as file:
            return [_pair(path.parent, row) for row in csv.DictReader(file)]
    except (KeyError, TypeError, ValueError) as error:
        raise DataError(
            f"{path}: expected the columns group, name and tier in every line: {error!r}"
        ) from error


def _pair(folder: Path, row: dict[str, str]) -> Pair:
    own = folder / "pairs" / row["group"] / row["name"]
    paper_row = row.get("paper_row") or ""
    return Pair(
        row["name"], row["tier"], own, paper_row, _bytes(own), row["group"], _is_related(own)
    )


def _found(folder: Path) -> list[Pair]:
    places = sorted({file.parent for name in FILES for file in folder.rglob(name)})
    for place in places:
        absent = [name for name in FILES if not (place / name).is_file()]
        if absent:
            raise DataError(f"{place}: half a pair: it has no {' and no '.join(absent)}")
    return [_unlisted(place, folder) for place in places]


def _unlisted(place: Path, folder: Path) -> Pair:
    name = place.resolve().name
    nested = place != folder and place.parent != folder
    around = (place if place == folder else place.parent).resolve().name
    group = around if nested else name  # side by side, each is a source of its own
    return Pair(name, around, place, "", _bytes(place), group, _is_related(place))


def _is_related(folder: Path) -> bool:
    path = folder / FILES[2]
    return not (path.is_file() and path.read_bytes().strip() == NONE.encode())


def _bytes(folder: Path) -> int:
    files = [folder / name for name in FILES]
    return sum(file.stat().st_size for file in files if file.is_file())


def _text(rows: Array) -> str:
    """Enough digits to read back the same doubles."""
    return "".join(" ".join(f"{value:.17g}" for value in row) + "\n" for row in rows)


def _tier_rank(tier: str) -> int:
    return TIERS.index(tier) if tier in TIERS else len(TIERS)
