"""The committed counts."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path

from ..locations import REPOSITORY
from ..whole_file import write_whole
from .counting import Count
from .programs import RegressFailure

FILE = REPOSITORY / "tools" / "bench" / "regress.json"


@dataclass(frozen=True)
class Record:
    toolchain: dict[str, str]
    counts: dict[str, Count]  # by program


def read(path: Path) -> Record:
    try:
        value = json.loads(path.read_text())
        counts = {name: Count(**count) for name, count in value["programs"].items()}
        return Record(dict(value["toolchain"]), counts)
    except (OSError, KeyError, TypeError, ValueError) as error:
        raise RegressFailure(f"{path}: expected counts made by --update: {error!r}") from error


def write(path: Path, record: Record) -> None:
    """Whole or not at all."""
    value = {
        "toolchain": record.toolchain,
        "programs": {name: asdict(count) for name, count in record.counts.items()},
    }
    write_whole(path, json.dumps(value, indent=1) + "\n")
