"""An index of many registrations: a table that can be sorted, with a link to each page."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote

from ..result import Result
from ..whole_file import write_whole
from .template_files import index_with

_FIELDS = ("registered", "confidence", "reason", "reason_text", "overlap_source",
           "inlier_rmse_plane")  # fmt: skip


class IndexEntry(NamedTuple):
    """One row of the index.

    Attributes:
        name: what the row is called, such as "scan 3 to scan 4".
        record: the :class:`pyemtr.Result`, the dict of its ``to_dict()``, or a report of the
            command as JSON values. "registered" is needed; what else is missing is shown as
            unknown.
        page: the file that :meth:`pyemtr.Result.to_html` wrote, or None; linked by its place beside
            the index, so that a folder of both can be moved.
        thumbnail: a picture of the pair, as :func:`pyemtr.html.thumbnail.thumbnail` makes it,
            or "".
    """

    name: str
    record: Result | Mapping[str, Any]
    page: str | os.PathLike[str] | None = None
    thumbnail: str = ""


def write_index(
    path: str | os.PathLike[str], entries: Iterable[IndexEntry], *, title: str = "Registrations"
) -> None:
    """Writes the index, whole or not at all: one file that loads nothing.

    It is sorted by confidence at first, the least sure on top, and by any column whose head is
    pressed.

    Args:
        path: file to write.
        entries: the rows; tuples of the same order will do.
        title: above the table.

    Raises:
        TypeError, ValueError: an entry without a name or without "registered" in its record, or a
            thumbnail that is no picture.
        OSError: the file cannot be written.
    """
    place = Path(path)
    rows = [_row(IndexEntry(*entry), place.parent) for entry in entries]
    write_whole(place, index_with({"format": 1, "title": title, "entries": rows}).encode())


def _row(entry: IndexEntry, folder: Path) -> dict[str, Any]:
    if not isinstance(entry.name, str) or not entry.name:
        raise TypeError(f"name: expected a text, got {entry.name!r}")
    record = vars(entry.record) if isinstance(entry.record, Result) else entry.record
    flat = {**record, **record.get("quality", {})}
    if not isinstance(flat.get("registered"), bool):
        raise ValueError(f"{entry.name}: the record has no 'registered' that is True or False")
    if entry.thumbnail and not entry.thumbnail.startswith("data:image/"):
        raise ValueError(f"{entry.name}: thumbnail: expected a data URL of a picture")
    seconds = record.get("timings", record.get("seconds"))
    return {
        "name": entry.name,
        **{field: _json(flat.get(field)) for field in _FIELDS},
        "seconds": _json(seconds.get("total") if isinstance(seconds, Mapping) else seconds),
        "page": None if entry.page is None else _link(Path(entry.page), folder),
        "thumbnail": entry.thumbnail,
    }


def _json(value: Any) -> Any:
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _link(page: Path, folder: Path) -> str:
    """The way from the index to the page, as a URL; a name with a colon is no other scheme."""
    return quote(Path(os.path.relpath(page, folder)).as_posix())
