"""What a run over many pairs gives back."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, overload

from ..result import Result
from .record import ERROR, NOT_REGISTERED, REGISTERED, result_of


@dataclass(frozen=True)
class PairRecord:
    """What is known of one pair.

    Attributes:
        values: the record as docs/MANY_PAIRS.md describes it, as JSON values.
    """

    values: dict[str, Any]

    @property
    def index(self) -> int:
        """The place of the pair among all pairs, from 0."""
        return int(self.values["index"])

    @property
    def name(self) -> str | None:
        """The name of the pair, None when it has none."""
        return None if self.values["name"] is None else str(self.values["name"])

    @property
    def status(self) -> str:
        """ "registered", "not_registered" or "error"."""
        return str(self.values["status"])

    @property
    def error(self) -> str | None:
        """Why the pair could not be registered; None when it has a result."""
        return None if self.values["error"] is None else str(self.values["error"])

    @property
    def result(self) -> Result | None:
        """The result, as :func:`pyemtr.register` returned it; None with an error."""
        return result_of(self.values)

    def __repr__(self) -> str:
        name = "" if self.name is None else f" {self.name}"
        return f"<pyemtr.PairRecord {self.index}{name}: {self.error or self.status}>"


class PairRecords(Sequence[PairRecord]):
    """The records of a run, in the order of the pairs. They are read when they are asked for: from
    the file of the run, or from memory when it had no folder.

    Attributes:
        folder: where ``results.jsonl`` and ``results.csv`` are, None without a folder.
        counts: how many pairs are "registered", "not_registered" or have an "error".
    """

    def __init__(self, lines: dict[int, Any], statuses: Counter[str], path: Path | None) -> None:
        self._lines = lines  # texts, or offset and length in the file
        self._order = sorted(lines)
        # Open as long as the records are wanted: a later run may replace the file.
        self._file = None if path is None else path.open("rb")
        self.folder = None if path is None else path.parent
        self.counts = {kind: statuses[kind] for kind in (REGISTERED, NOT_REGISTERED, ERROR)}

    def __len__(self) -> int:
        return len(self._order)

    @overload
    def __getitem__(self, place: int) -> PairRecord: ...

    @overload
    def __getitem__(self, place: slice) -> list[PairRecord]: ...

    def __getitem__(self, place: int | slice) -> PairRecord | list[PairRecord]:
        if isinstance(place, slice):
            return [self._record(index) for index in self._order[place]]
        return self._record(self._order[place])

    def __iter__(self) -> Iterator[PairRecord]:
        return map(self._record, self._order)

    def _record(self, index: int) -> PairRecord:
        line = self._lines[index]
        if self._file is not None:
            offset, length = line
            line = os.pread(self._file.fileno(), length, offset)
        return PairRecord(json.loads(line))

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {kind}" for kind, count in self.counts.items() if count)
        place = "" if self.folder is None else f" in {self.folder}"
        return f"<pyemtr.PairRecords: {counts or 'no pairs'}{place}>"
