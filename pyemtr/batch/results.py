"""Where the records of a run go: to a folder, or to memory."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..inputs import Inputs
from .pair import Pair
from .record import ERROR, Line, arguments_of
from .record_file import RecordFile
from .records import PairRecords
from .table import NAME as TABLE
from .table import write_table

_INPUTS = frozenset(Inputs.__dataclass_fields__)


class MemoryResults:
    """Keeps the records in memory."""

    def __init__(self) -> None:
        self._lines: dict[int, str] = {}
        self._statuses: Counter[str] = Counter()

    def __len__(self) -> int:
        return len(self._lines)

    def has(self, pair: Pair, settings: Mapping[str, Any]) -> bool:
        return False

    def record(self, index: int) -> dict[str, Any]:
        raise KeyError(index)

    def append(self, lines: list[Line]) -> None:
        for line in lines:
            self._lines[line.index] = line.text
            self._statuses[line.status] += 1

    def finish(self, count: int) -> PairRecords:
        return PairRecords(dict(self._lines), self._statuses, None)

    def close(self) -> None:
        pass


class FolderResults:
    """Keeps the records in a folder, and goes on where an earlier run ended."""

    def __init__(self, folder: Path, retry_errors: bool) -> None:
        self._file = RecordFile(folder, retry_errors=retry_errors)
        self._common: dict[str, Any] | None = None  # what pairs without own settings use

    def __len__(self) -> int:
        return len(self._file.places)

    def has(self, pair: Pair, settings: Mapping[str, Any]) -> bool:
        """Tells whether the pair has its record.

        Raises ValueError when the record is of another pair or of other settings.
        """
        if pair.index not in self._file.places:
            return False
        record = self._file.read(pair.index)
        for what in ("name", "source", "target"):
            given = getattr(pair, what if what == "name" else f"{what}_text")
            if record[what] != given:
                self._refuse(pair, what, record[what], given)
        if record["status"] != ERROR:
            preset = pair.settings.get("preset", settings.get("preset", "default"))
            if record["preset"] != preset:
                self._refuse(pair, "preset", record["preset"], preset)
            recorded, wanted = arguments_of(record), self._wanted(pair, settings)
            for name, value in wanted.items():
                if name != "threads" and recorded.get(name) != value:
                    self._refuse(pair, name, recorded.get(name), value)
        return True

    def record(self, index: int) -> dict[str, Any]:
        """Returns the record of a pair that has one. Raises KeyError for any other."""
        return self._file.read(index)

    def append(self, lines: list[Line]) -> None:
        self._file.append(lines)

    def finish(self, count: int) -> PairRecords:
        """Writes the table. Raises ValueError when the folder has records of more pairs."""
        beyond = [index for index in self._file.places if index >= count]
        if beyond:
            raise ValueError(
                f"{self._file.path}: has a record of pair {min(beyond)}, and there are {count}"
                " pairs: it is of another run; name another folder"
            )
        write_table(self._file.folder / TABLE, self._file)
        places = self._file.places
        statuses = Counter(place.status for place in places.values())
        lines = {index: (place.offset, place.length) for index, place in places.items()}
        return PairRecords(lines, statuses, self._file.path)

    def close(self) -> None:
        self._file.close()

    def _wanted(self, pair: Pair, settings: Mapping[str, Any]) -> dict[str, Any]:
        if pair.settings:
            return used_arguments({**settings, **pair.settings})
        if self._common is None:
            self._common = used_arguments(settings)
        return self._common

    def _refuse(self, pair: Pair, what: str, recorded: Any, given: Any) -> None:
        raise ValueError(
            f"{self._file.path}: the record of pair {pair.index} has the {what} {recorded!r}, and"
            f" the pair has {given!r}: it is of another run; name another folder"
        )


def used_arguments(arguments: Mapping[str, Any]) -> dict[str, Any]:
    """Returns all that a registration with these arguments would use. Raises as it would."""
    inputs = Inputs(**{name: value for name, value in arguments.items() if name in _INPUTS})
    changes = {name: value for name, value in arguments.items() if name not in _INPUTS}
    return inputs.used(inputs.settings(changes))
