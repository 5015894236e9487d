"""A table of the report: cells with ours and the paper's, as Markdown and as CSV."""

from __future__ import annotations

import csv
import io
import math
from dataclasses import dataclass, field
from typing import Union

from .published import Published

Value = Union[Published, float, str, None]


@dataclass(frozen=True)
class Cell:
    """Ours, and the paper's where it has the same figure."""

    ours: Value
    paper: Value = None
    digits: int = 3

    def text(self) -> str:
        ours, paper = (_text(v, self.digits) for v in (self.ours, self.paper))
        if not paper:
            return ours
        return f"{ours or '-'} ({paper})"


@dataclass
class Table:
    """`name` is that of its CSV. In Markdown the paper's figure is in parentheses."""

    name: str
    title: str
    columns: list[str]  # the first is the row's name
    rows: list[tuple[str, list[Cell]]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def markdown(self) -> str:
        lines = [f"| {' | '.join(self.columns)} |",
                 f"|---|{'--:|' * (len(self.columns) - 1)}"]  # fmt: skip
        lines += [f"| {name} | {' | '.join(c.text() for c in cells)} |"
                  for name, cells in self.rows]  # fmt: skip
        return "\n".join(lines)

    def csv(self) -> str:
        """Four columns for each of ours: mean, standard deviation, and both of the paper's."""
        content = io.StringIO()
        writer = csv.writer(content, lineterminator="\n")
        heads = [f"{column} {part}".strip() for column in self.columns[1:]
                 for part in ("", "std", "paper", "paper std")]  # fmt: skip
        writer.writerow([self.columns[0], *heads])
        for name, cells in self.rows:
            values: list[str] = []
            for cell in cells:
                values += [*_numbers(cell.ours), *_numbers(cell.paper)]
            writer.writerow([name, *values])
        return content.getvalue()


def _text(value: Value, digits: int) -> str:
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return ""
    if isinstance(value, Published):
        text = f"{value.mean:.{digits}f}"
        return text if value.std is None else f"{text}±{value.std:.{digits}f}"
    return value if isinstance(value, str) else f"{value:.{digits}f}"


def _numbers(value: Value) -> tuple[str, str]:
    """Six significant digits and more: the CSV is what the page is made of."""
    if isinstance(value, Published):
        return f"{value.mean:.6g}", "" if value.std is None else f"{value.std:.6g}"
    if isinstance(value, float):
        return ("" if math.isnan(value) else f"{value:.6g}"), ""
    return value or "", ""
