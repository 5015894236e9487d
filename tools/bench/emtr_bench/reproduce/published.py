"""The paper's figures, from the tables in tools/bench/paper."""

from __future__ import annotations

import csv
from functools import cache
from typing import NamedTuple

from ..locations import REPOSITORY
from ..paper_tables import short_name

FOLDER = REPOSITORY / "tools" / "bench" / "paper"


class Published(NamedTuple):
    """A mean, and its standard deviation where the paper gives one."""

    mean: float
    std: float | None = None

    def __str__(self) -> str:
        return f"{self.mean:.3f}" + ("" if self.std is None else f"±{self.std:.3f}")


@cache
def table(name: str) -> list[dict[str, str]]:
    """The rows of one of the files, such as "run_time"."""
    with (FOLDER / f"{name}.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def value(name: str, row: str, column: str, **where: str) -> Published | None:
    """A cell: of the row whose first column is `row` (a stand-in's name has its model's), and which
    has the values `where`. None where the paper has no such cell, or a dash."""
    wanted = short_name(row)
    for cells in table(name):
        first = next(iter(cells.values()))
        if first == wanted and all(cells[key] == text for key, text in where.items()):
            return read(cells[column])
    return None


def read(text: str) -> Published | None:
    text = text.strip().rstrip("%")
    if text in ("", "-"):
        return None
    mean, _, std = text.partition("±")
    return Published(float(mean), float(std) if std else None)
