"""The pages of a run over many pairs: one of each pair that has a result, and their index."""

from __future__ import annotations

import base64
import hashlib
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..cloud import Cloud
from ..html import IndexEntry, page_payload, write_index
from ..html.template_files import page_with
from ..html.thumbnail import thumbnail
from ..mesh import MESH_POINTS
from ..result import Result
from ..whole_file import write_whole
from .pair import Pair
from .record import ERROR, as_line
from .shared import Shared

PAIRS = "pairs"  # the folder of the pages of pairs
_GENERATOR = '<meta name="generator" content="emtr">'
_STAMP = '<meta name="emtr-record" content="{}">'
_HEAD = 4096  # bytes of a page that its stamp is within
_PICTURE = "data:image/png;base64,"


@dataclass(frozen=True)
class PairPage:
    """The page of a pair, and the small picture of it in the index."""

    html: bytes
    picture: bytes  # PNG


def page_of_pair(
    pair: Pair, record: Mapping[str, Any], result: Result, clouds: tuple[Any, Any]
) -> PairPage:
    """Makes the page of a pair from its record, its result and its clouds.

    Raises TypeError, ValueError or OSError when the points of a cloud cannot be had.
    """
    paths = ((pair.source_text, "source"), (pair.target_text, "target"))
    names = [os.path.basename(text or "") or role for text, role in paths]
    mesh_points = result.settings.get("mesh_points")
    if mesh_points is None:  # 0 stands for the vertices
        mesh_points = MESH_POINTS
    payload = page_payload(
        result, *clouds, title=pair.name or "", names=names, threads=1, mesh_points=mesh_points
    )
    text = page_with(payload)
    stamp = _STAMP.format(stamp_of(record))
    up = payload["up"]
    picture = thumbnail(result, *clouds, up=(up[0], up[1], up[2]), mesh_points=mesh_points)
    return PairPage(
        text.replace(_GENERATOR, f"{_GENERATOR}\n{stamp}", 1).encode(),
        base64.b64decode(picture.removeprefix(_PICTURE)),
    )


def shown_cloud(given: Any, registered: Any) -> Any:
    """Returns what the points that a page shows are of: the cloud that was registered if it has
    kept them, else what the user gave."""
    if isinstance(given, Shared):
        given = registered if given.is_packed else given.cloud
    if not isinstance(registered, Cloud):
        return given
    try:
        return registered.points
    except TypeError:
        if isinstance(given, Cloud):
            raise
        return given


def stamp_of(record: Mapping[str, Any]) -> str:
    """Returns what tells a record from all others, so that a page is known to be of it."""
    return hashlib.sha256(as_line(record).text.encode()).hexdigest()


class PagesFolder:
    """The folder of the pages of a run, which is made.

    A page is in it whole or not at all. It has a stamp of the record that it was made from, so that
    one of another run is made again.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        (folder / PAIRS).mkdir(parents=True, exist_ok=True)

    def has(self, record: Mapping[str, Any]) -> bool:
        """Tells whether the page of a record is there, or there is to be none: of an error."""
        if record["status"] == ERROR:
            return True
        try:
            with self._page(record["index"]).open("rb") as file:
                head = file.read(_HEAD)
        except FileNotFoundError:
            return False
        return stamp_of(record).encode() in head and self._picture(record["index"]).is_file()

    def write(self, index: int, page: PairPage) -> None:
        """Writes the page last: it counts when its picture is there too."""
        write_whole(self._picture(index), page.picture)
        write_whole(self._page(index), page.html)

    def write_index(self, records: Iterable[Mapping[str, Any]], title: str) -> None:
        """Writes the index of all pairs, those with an error too."""
        write_index(self._folder / "index.html", map(self._entry, records), title=title)

    def _entry(self, record: Mapping[str, Any]) -> IndexEntry:
        name = record["name"] or " → ".join(
            os.path.basename(record[role] or role) for role in ("source", "target")
        )
        if record["status"] == ERROR:
            failed = {"registered": False, "reason": "error", "reason_text": record["error"]}
            return IndexEntry(name, failed)
        page = self._page(record["index"])
        if not self.has(record):
            return IndexEntry(name, record)
        picture = base64.b64encode(self._picture(record["index"]).read_bytes()).decode()
        return IndexEntry(name, record, page, _PICTURE + picture)

    def _page(self, index: int) -> Path:
        return self._folder / PAIRS / f"{index:06d}.html"

    def _picture(self, index: int) -> Path:
        return self._folder / PAIRS / f"{index:06d}.png"
