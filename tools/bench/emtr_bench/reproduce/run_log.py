"""The log of finished runs, one JSON line each, from which an interrupted reproduction goes on.

A line cut short by the interruption is dropped. The first line says with what the runs were made;
a log of other options is not gone on with.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from ..pairs import DataError

Record = dict[str, Any]
Key = tuple[str, str, str, int]


def key(record: Record) -> Key:
    """What makes a run the same run: section, method, pair and motion."""
    return record["section"], record["method"], record["pair"], record["index"]


class RunLog:
    """Appends to a file. `options` are those that change what a run gives. A log that is only
    `read` is left as it is, for another process may be at it."""

    def __init__(self, path: Path, options: Record, read: bool = False) -> None:
        self.path = path
        self.records: list[Record] = []
        if not read:
            path.parent.mkdir(parents=True, exist_ok=True)
        head = {"options": options}
        if path.is_file():
            found, size = _read(path)
            if found and found[0] != json.loads(json.dumps(head)):
                raise DataError(
                    f"{path}: it was made with other options, {found[0].get('options')}; "
                    "choose another --out, or remove it"
                )
            self.records = found[1:]
            if not read:
                with path.open("r+b") as file:
                    file.truncate(size)
        elif read:
            raise DataError(f"{path}: no such log of runs")
        self._done = {key(record) for record in self.records}
        self._file = None if read else path.open("a", encoding="utf-8")
        if self._file is not None and not path.stat().st_size:
            self._write(head)

    def has(self, wanted: Key) -> bool:
        return wanted in self._done

    def append(self, records: Iterable[Record]) -> None:
        for record in records:
            self._write(record)
            self.records.append(record)
            self._done.add(key(record))

    def close(self) -> None:
        if self._file is not None:
            self._file.close()

    def _write(self, record: Record) -> None:
        if self._file is None:
            raise ValueError(f"{self.path} is open for reading only")
        self._file.write(json.dumps(_plain(record), allow_nan=False) + "\n")
        self._file.flush()


def _read(path: Path) -> tuple[list[Record], int]:
    """The whole lines, and how many bytes they are."""
    found: list[Record] = []
    size = 0
    for number, line in enumerate(path.read_bytes().splitlines(keepends=True), 1):
        if not line.endswith(b"\n"):
            break
        try:
            record = json.loads(line)
        except ValueError as error:
            raise DataError(f"{path}: line {number} is no JSON: {error}") from error
        found.append(record)
        size += len(line)
    return found, size


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _plain(item) for name, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    if hasattr(value, "item"):
        value = value.item()
    return None if isinstance(value, float) and not math.isfinite(value) else value
