"""A result as the report of the command has it: the same groups and keys."""

from __future__ import annotations

import platform
from typing import TYPE_CHECKING, Any

import numpy as np

from ..extension import _emtr
from ..options import settings
from ..result_json import to_json

if TYPE_CHECKING:
    from ..result import Result


def report_of(result: Result, names: tuple[str, str], read: tuple[int, int]) -> dict[str, Any]:
    """Returns the report of a result, as JSON values; None for what only the command knows.

    Args:
        result: of a registration.
        names: of the source and the target, as the page calls them.
        read: the number of points of each, those that are not finite too.
    """
    report = {**_input(result, names), **_fields(result)}
    if not result.refined:
        report["refinement"] = None
    report["queries"]["total"] = sum(result.queries.values())
    report["reason_text"] = result.reason_text
    report.update({"residuals": None, "unit_hint": None, "meshes": None})
    report["counts"]["read_source"], report["counts"]["read_target"] = read
    return report


def versions() -> dict[str, str]:
    """Returns the versions that a page names."""
    return {
        "emtr": _emtr.version(),
        "numpy": np.__version__,
        "python": platform.python_version(),
    }


def _input(result: Result, names: tuple[str, str]) -> dict[str, Any]:
    used = result.settings
    return {
        "versions": versions(),
        "files": {"source": names[0], "target": names[1]},
        "preset": None,
        "settings": to_json({name: used[name] for name in settings() if name in used}),
        "guess": used.get("guess"),
        "viewpoints": {
            "source": used.get("source_viewpoint"),
            "target": used.get("target_viewpoint"),
        },
        "axis": used.get("axis"),
        "translation_bounds": used.get("translation_bounds"),
    }


def _fields(result: Result) -> dict[str, Any]:
    from ..result import ATTRIBUTES

    values = result.to_dict()
    found: dict[str, Any] = {}
    for name, group, key, *_ in _emtr.describe_result():
        value = values[name] if key == name else values[ATTRIBUTES.get(group, group)][key]
        (found.setdefault(group, {}) if group else found)[key] = value
    return found
