"""The report: tables, figures, and what they say beside the paper."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..pairs import Pair
from ..whole_file import write_whole
from . import claims, differences, figures, methods_text, more_tables, scenes, tables
from .run_log import Record
from .table import Table


def write(
    folder: Path, records: Sequence[Record], pairs: Sequence[Pair], about: dict[str, Any],
) -> Path:  # fmt: skip
    """report.md, tables/*.csv and figures/*.png in a folder."""
    made = all_tables(records)
    (folder / "tables").mkdir(parents=True, exist_ok=True)
    for table in made:
        write_whole(folder / "tables" / f"{table.name}.csv", table.csv())
    drawn = figures.draw(records, folder / "figures")
    pictures = scenes.draw(records, pairs, folder / "figures" / "pairs")
    path = folder / "report.md"
    write_whole(path, page("Reproduction of the paper", path, records, made, drawn, about,
                           pictures))  # fmt: skip
    return path


def write_page(path: Path, records: Sequence[Record], about: dict[str, Any]) -> Path:
    """The same as a page of the documentation, its figures beside it. It has no pictures of the
    clouds, whose terms may not allow to pass them on."""
    drawn = figures.draw(records, path.parent, "reproduction_")
    made = all_tables(records)
    write_whole(path, page("The paper, reproduced", path, records, made, drawn, about, []))
    return path


def all_tables(records: Sequence[Record]) -> list[Table]:
    found = tables.made(records)
    found += [table for make in more_tables.ALL if (table := make(records)) is not None]
    tests = claims.significance(records)
    return [*found, tests] if tests else found


def page(
    title: str, path: Path, records: Sequence[Record], made: Sequence[Table],
    drawn: dict[str, tuple[str, Path]], about: dict[str, Any],
    pictures: Sequence[tuple[str, Path]],
) -> str:  # fmt: skip
    clouds = [r for r in records if r["tier"] not in ("modelnet", "functions")]
    pairs = len({r["pair"] for r in clouds})
    lines = [
        f"# {title}", "",
        "Wu et al., *Evolutionary Multitasking with Solution Space Cutting for Point Cloud "
        "Registration*, IEEE TETCI 2023: its experiments, run again. In each cell the paper's "
        "figure is in parentheses behind ours; ours is a mean, with a standard deviation where "
        "the paper has one.", "",
        "```text", about["command"], "```", "",
        f"{len(records)} of {about['planned']} runs; {pairs} pairs, {about['motions']}; "
        f"{about['made']}.", "",
    ]  # fmt: skip
    lines += ["## What differs, and why", "", *differences.text(records, made)]
    lines += [f"* Not run, {note}" for note in about["missing"]] + [""]
    lines += ["## The methods", "", *methods_text.lines(), "## Tables", ""]
    for table in made:
        lines += [f"### {table.title}", "", table.markdown(), ""]
        for note in table.notes:
            lines += [note, ""]
    if drawn:
        lines += ["## Figures", ""]
    for caption, file in drawn.values():
        lines += [f"{caption}:", "", f"![{caption}]({_relative(file, path)})", ""]
    if pictures:
        lines += ["## Pairs", ""]
    for row, file in pictures:
        lines += [f"![{row}: the input, each method, and the truth]({_relative(file, path)})", ""]
    return "\n".join(lines).rstrip() + "\n"


def _relative(file: Path, page: Path) -> str:
    return Path(os.path.relpath(file, page.parent)).as_posix()
