"""The record of a pair: one line of JSON, in the layout of the command's report."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..extension import _emtr
from ..options import settings
from ..result import ATTRIBUTES, Result
from ..result_json import to_json
from .pair import Pair

if TYPE_CHECKING:
    from .pages import PairPage

REGISTERED, NOT_REGISTERED, ERROR = "registered", "not_registered", "error"


def result_record(pair: Pair, preset: str, result: Result) -> dict[str, Any]:
    """Returns the record of a pair that has a result. NaN and infinities are None."""
    used = dict(result.settings)
    known_pose = {
        "guess": used.pop("guess"),
        "viewpoints": {
            "source": used.pop("source_viewpoint"),
            "target": used.pop("target_viewpoint"),
        },
        "axis": used.pop("axis"),
        "translation_bounds": used.pop("translation_bounds"),
        "mesh_points": used.pop("mesh_points"),
    }
    status = REGISTERED if result.registered else NOT_REGISTERED
    record = {**_heading(pair, status, None), "preset": preset, "settings": used, **known_pose}
    for name, group, key, kind, _, _ in _emtr.describe_result():
        attribute = getattr(result, name, None)
        if key != name:
            attribute = getattr(result, ATTRIBUTES.get(group, group))[key]
        (record.setdefault(group, {}) if group else record)[key] = attribute
        if kind == "reason":
            record["reason_text"] = result.reason_text
    if not result.refined:
        record["refinement"] = None
    record["queries"]["total"] = sum(result.queries.values())
    return to_json(record)


def error_record(pair: Pair, error: BaseException) -> dict[str, Any]:
    """Returns the record of a pair that could not be registered."""
    return _heading(pair, ERROR, str(error) or "not enough memory")


@dataclass(frozen=True)
class Line:
    """A record as it is written, and what has to be known of it without reading it again."""

    index: int
    status: str
    text: str  # JSON without a line break within, and one behind it
    page: PairPage | None = None
    is_new: bool = True  # and not that of a pair of which the page alone was made


def as_line(record: Mapping[str, Any]) -> Line:
    """Returns the record as it is written."""
    text = json.dumps(record, allow_nan=False, separators=(",", ":"), ensure_ascii=False)
    return Line(record["index"], record["status"], text + "\n")


def result_of(record: Mapping[str, Any]) -> Result | None:
    """Returns the result that a record has, None for one with an error.

    Raises ValueError for a record that lacks a field.
    """
    if record["status"] == ERROR:
        return None
    values: dict[str, Any] = {"settings": arguments_of(record)}
    try:
        for name, group, key, kind, _, _ in _emtr.describe_result():
            place = record[group] if group else record
            value = None if place is None else place[key]
            if key != name:
                values.setdefault(ATTRIBUTES.get(group, group), {})[key] = value
            else:
                values[name] = _unrefined(name) if place is None else value
            if kind == "reason":
                values["reason_text"] = record["reason_text"]
    except KeyError as error:
        raise ValueError(f"record {record['index']}: {error} is missing") from error
    return Result.from_dict(values)


def arguments_of(record: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the keyword arguments of :func:`pyemtr.register` that repeat a record."""
    known = settings()
    return {
        **{name: value for name, value in record["settings"].items() if name in known},
        "guess": record["guess"],
        "source_viewpoint": record["viewpoints"]["source"],
        "target_viewpoint": record["viewpoints"]["target"],
        "axis": record["axis"],
        "translation_bounds": record["translation_bounds"],
        "mesh_points": record["mesh_points"],
    }


def _unrefined(name: str) -> Any:
    """What a result that was not refined has: NaN in the shape of the field, or None."""
    for field, _, _, kind, rows, columns in _emtr.describe_result():
        if field == name and kind == "real" and rows * columns > 1:
            return [[None] * columns] * rows if rows > 1 else [None] * columns
    return None


def _heading(pair: Pair, status: str, error: str | None) -> dict[str, Any]:
    return {
        "index": pair.index,
        "name": pair.name,
        "source": pair.source_text,
        "target": pair.target_text,
        "status": status,
        "error": error,
    }
