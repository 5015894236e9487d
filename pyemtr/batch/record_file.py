"""The file of records, results.jsonl: a record is in it whole or not at all."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from ..whole_file import sync_folder, write_whole
from .folder_lock import FolderLock
from .record import ERROR, Line

NAME = "results.jsonl"


class Place(NamedTuple):
    """Where a record is, and what it says in short."""

    offset: int
    length: int  # bytes
    status: str


class RecordFile:
    """The records in a folder, which is made when it is not there, and locked.

    A last line without its end is what a killed writer left: it is cut off. With ``retry_errors``
    the records of pairs that failed are left out, so that these are tried again.

    Raises:
        BlockingIOError: another run has the folder.
        ValueError: a line is no record, or two are of one pair.
        OSError: the folder cannot be written to.
    """

    def __init__(self, folder: Path, *, retry_errors: bool = False) -> None:
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        self._lock = FolderLock(folder)
        try:
            self.path = folder / NAME
            self._open()
            self.places: dict[int, Place] = self._read()
            if retry_errors and any(p.status == ERROR for p in self.places.values()):
                self._forget_errors()
        except BaseException:
            self._lock.release()
            raise

    def append(self, lines: list[Line]) -> None:
        """Writes the records in one call and waits until the disk has them. Where it cannot write
        them whole, it writes none and raises OSError."""
        data = "".join(line.text for line in lines).encode()
        end = os.fstat(self._file).st_size
        try:
            if os.write(self._file, data) != len(data):
                raise OSError(f"{self.path}: cannot be written whole, is the disk full?")
            os.fsync(self._file)
        except OSError:
            os.ftruncate(self._file, end)
            raise
        for line in lines:
            size = len(line.text.encode())
            self._note(line.index, line.status, end, size)
            end += size

    def read(self, index: int) -> dict[str, Any]:
        """Returns the record of one pair. Raises KeyError when there is none."""
        place = self.places[index]
        return dict(json.loads(os.pread(self._file, place.length, place.offset)))

    def __iter__(self) -> Iterator[dict[str, Any]]:
        with self.path.open("rb") as file:
            for line in file:
                yield json.loads(line)

    def close(self) -> None:
        os.close(self._file)
        self._lock.release()

    def _open(self) -> None:
        self._file = os.open(self.path, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o666)
        sync_folder(self.folder)
        end = os.fstat(self._file).st_size
        kept = _last_line_end(self._file, end)
        if kept < end:
            os.ftruncate(self._file, kept)
            os.fsync(self._file)

    def _read(self) -> dict[int, Place]:
        self.places = {}
        offset = 0
        with self.path.open("rb") as file:
            for number, line in enumerate(file, 1):
                try:
                    record = json.loads(line)
                    self._note(record["index"], record["status"], offset, len(line))
                except (ValueError, KeyError, TypeError) as error:
                    raise ValueError(
                        f"{self.path}: line {number}: expected the record of a pair: {error}"
                    ) from error
                offset += len(line)
        return self.places

    def _note(self, index: int, status: str, offset: int, length: int) -> None:
        if index in self.places:
            raise ValueError(f"a second record of pair {index}")
        self.places[index] = Place(offset, length, status)

    def _forget_errors(self) -> None:
        kept = [place for place in self.places.values() if place.status != ERROR]
        write_whole(self.path, (os.pread(self._file, p.length, p.offset) for p in kept))
        os.close(self._file)
        self._open()
        self._read()


def read_records(path: Path) -> dict[int, dict[str, Any]]:
    """Returns the records of a file by index; a last line without its end is left out.

    Raises:
        ValueError: a line is no record.
        OSError: the file cannot be read.
    """
    records = {}
    with path.open("rb") as file:
        for number, line in enumerate(file, 1):
            if line.endswith(b"\n"):
                try:
                    record = dict(json.loads(line))
                    records[int(record["index"])] = record
                except (ValueError, KeyError, TypeError) as error:
                    raise ValueError(
                        f"{path}: line {number}: expected the record of a pair: {error}"
                    ) from error
    return records


def _last_line_end(file: int, end: int) -> int:
    """Returns where the last whole line ends; 0 when there is none."""
    step = 1 << 16
    while end > 0:
        begin = max(0, end - step)
        found = os.pread(file, end - begin, begin).rfind(b"\n")
        if found >= 0:
            return begin + found + 1
        end = begin
    return 0
