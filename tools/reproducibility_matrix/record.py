"""Results in a file, so that a change of the code can be shown to change no bit."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path

from .fields import Fields

Results = dict[str, dict[str, Fields]]  # by pair, then by preset
LONGEST = 2000  # characters of a value that is kept; of a longer one its digest is


def write(path: Path, results: Results) -> None:
    path.write_text(
        json.dumps(_digested(results), indent=1, sort_keys=True) + "\n", encoding="utf-8"
    )


def read(path: Path, renamed: Mapping[str, str]) -> Results:
    """Returns a record with its fields under their new names.

    Raises OSError, or ValueError when the file is no record, has no field of an old name, or
    already has one of the new name.
    """
    try:
        results = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise ValueError(f"{path}: expected JSON as --record writes it: {error}") from error
    if not _is_record(results):
        raise ValueError(f"{path}: expected results by pair and preset, as --record writes them")
    return {
        pair: {preset: _rename(path, fields, renamed) for preset, fields in presets.items()}
        for pair, presets in results.items()
    }


def differences(recorded: Results, found: Results) -> list[str]:
    """Returns a line for each pair and preset that differs, or that only one side has."""
    lines = []
    found = _digested(found)
    for pair, preset in sorted(_keys(recorded) | _keys(found)):
        one, other = recorded.get(pair, {}).get(preset), found.get(pair, {}).get(preset)
        if one is None or other is None:
            where = "this run" if one is None else "the record"
            lines.append(f"{pair} {preset}: only in {where}")
            continue
        parts = {
            "different": [name for name in one if name in other and one[name] != other[name]],
            "only in the record": [name for name in one if name not in other],
            "only in this run": [name for name in other if name not in one],
        }
        said = [f"{what}: {', '.join(names)}" for what, names in parts.items() if names]
        if said:
            lines.append(f"{pair} {preset}: {'; '.join(said)}")
    return lines


def _is_record(value: object) -> bool:
    return (
        isinstance(value, dict)
        and bool(value)
        and all(isinstance(presets, dict) and presets for presets in value.values())
        and all(
            isinstance(fields, dict) and all(isinstance(text, str) for text in fields.values())
            for presets in value.values()
            for fields in presets.values()
        )
    )


def _digested(results: Results) -> Results:
    def short(value: str) -> str:
        digest = hashlib.sha256(value.encode()).hexdigest()
        return value if len(value) <= LONGEST else f"sha256 {digest}"

    return {
        pair: {preset: {name: short(value) for name, value in fields.items()}
               for preset, fields in presets.items()}
        for pair, presets in results.items()
    }  # fmt: skip


def _rename(path: Path, fields: Fields, renamed: Mapping[str, str]) -> Fields:
    for old, new in renamed.items():
        if old not in fields:
            raise ValueError(f"--renamed {old}={new}: {path} has no field {old!r}")
        if new in fields:
            raise ValueError(f"--renamed {old}={new}: {path} has a field {new!r} already")
    return {renamed.get(name, name): value for name, value in fields.items()}


def _keys(results: Results) -> set[tuple[str, str]]:
    return {(pair, preset) for pair, presets in results.items() for preset in presets}
