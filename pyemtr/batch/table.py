"""The table of results, results.csv: one line a pair, in the order of the pairs."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from ..whole_file import write_whole

NAME = "results.csv"
_PLAIN = ("index", "name", "source", "target", "status", "reason", "confidence")
_MEASURES = ("overlap_source", "overlap_target", "inlier_rmse")
_POSE = tuple(f"t{row}{column}" for row in range(4) for column in range(4))
COLUMNS = (*_PLAIN, *_MEASURES, "seconds", "error", *_POSE)


def write_table(path: Path, records: Iterable[Mapping[str, Any]]) -> None:
    """Writes the table whole or not at all. The order of the records does not matter."""
    rows = sorted((record["index"], _text(_row(record))) for record in records)

    def parts() -> Iterator[bytes]:
        yield _text(COLUMNS)
        for _, text in rows:
            yield text

    write_whole(path, parts())


def _row(record: Mapping[str, Any]) -> list[Any]:
    pose = record.get("transformation")
    numbers = [None] * 16 if pose is None else [value for row in pose for value in row]
    quality = record.get("quality") or {}
    seconds = record.get("seconds") or {}
    return [
        *(record.get(name) for name in _PLAIN),
        *(quality.get(name) for name in _MEASURES),
        seconds.get("total"),
        record["error"],
        *numbers,
    ]


def _text(cells: Iterable[Any]) -> bytes:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerow(cells)
    return out.getvalue().encode()
