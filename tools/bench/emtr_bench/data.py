"""Which pairs a benchmark runs on: the user's, or the generated ones."""

from __future__ import annotations

import argparse
import os
from collections.abc import Iterable
from pathlib import Path

from .layout import read_folder
from .locations import REPOSITORY
from .pairs import DataError, Pair


def chosen(arguments: argparse.Namespace) -> list[Pair]:
    """The pairs that the options of pair_arguments name; says which folder they are from. Scans
    that do not belong together are among them. Raises DataError."""
    folder = locate(arguments.data)
    if folder is None:
        from .virtual_pairs.folder import virtual_pairs

        folder = virtual_pairs()
        why = f"EMTR_DATA={_environment()} is not there" if _environment() else "no EMTR_DATA"
        print(f"no --data, {why}: the generated pairs in {folder} (docs/BENCHMARKING.md)")
    else:
        print(f"data: {folder}")
    tiers, names = (
        [word for group in getattr(arguments, option) or [] for word in group]
        for option in ("tier", "pair")
    )
    pairs = read_folder(folder)
    if not tiers and not names:
        known = {pair.tier for pair in pairs}
        tiers = [arguments.default_tier if arguments.default_tier in known else "all"]
    return select(pairs, tiers, names)


def related(pairs: list[Pair]) -> list[Pair]:
    """Those that have a right pose. Raises DataError where none has."""
    found = [pair for pair in pairs if pair.related]
    if not found:
        raise DataError("none of the chosen pairs has a pose: T_gt.txt says none")
    return found


def are_generated(pairs: Iterable[Pair]) -> bool:
    """Tells whether some of the pairs are generated ones."""
    from .virtual_pairs.folder import FOLDER

    return any(FOLDER in pair.folder.parents for pair in pairs)


def locate(argument: str | None) -> Path | None:
    """The folder of --data, else of EMTR_DATA where that is there, else the one beside the project;
    None where there is none of them. Raises DataError for --data that is not there."""
    if argument:
        folder = Path(argument)
        if not folder.is_dir():
            raise DataError(
                f"--data {argument}: no such folder (without --data: EMTR_DATA, or generated pairs)"
            )
        return folder
    named = Path(_environment() or REPOSITORY.parent / "shared" / "data")
    return named if named.is_dir() else None


def select(pairs: list[Pair], tiers: list[str], names: list[str]) -> list[Pair]:
    """The pairs of these tiers ("all": every one); given names choose instead of tiers."""
    known = {pair.name for pair in pairs}
    for name in names:
        if name not in known:
            raise DataError(f"--pair {name}: no such pair; there are {', '.join(sorted(known))}")
    known_tiers = list(dict.fromkeys(pair.tier for pair in pairs))
    for tier in tiers:
        if tier != "all" and tier not in known_tiers:
            raise DataError(f"--tier {tier}: no such tier; there are all, {', '.join(known_tiers)}")
    if names:
        return [pair for pair in pairs if pair.name in names]
    return [pair for pair in pairs if "all" in tiers or pair.tier in tiers]


def _environment() -> str:
    return os.environ.get("EMTR_DATA", "")
