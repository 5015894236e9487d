"""The settings: what there is, and how keyword arguments become what the C library reads."""

from __future__ import annotations

import difflib
import numbers
import operator
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Union

import numpy as np

from . import _emtr
from .arrays import as_bounds, as_correspondences, as_transformation, as_vector

Value = Union[int, float, bool, str]


@dataclass(frozen=True)
class Setting:
    """One setting. ``minimum`` and ``maximum`` are inclusive, ``default`` is that
    of preset "default".

    ``type`` is "integer", "real", "switch" (False or True) or "choice" (one of ``choices``).
    ``part`` is that of the method it belongs to; but for the part "priors", lengths are never in
    the cloud's own unit.
    """

    name: str
    type: str
    unit: str
    minimum: float
    maximum: float
    default: Value
    part: str
    text: str
    choices: tuple[str, ...]


def settings() -> dict[str, Setting]:
    """Every setting by name, in the library's order."""
    found = {}
    for name, kind, unit, low, high, value, part, text, choices in _emtr.describe_settings():
        names = tuple(word.strip() for word in choices.split(",")) if choices else ()
        found[name] = Setting(
            name, kind, unit, low, high, _plain(kind, value, names), part, text, names
        )
    return found


def presets() -> list[str]:
    """Names for the argument ``preset``."""
    return _emtr.preset_names()


def make_settings(
    seed: int,
    threads: int,
    preset: str,
    guess: Any,
    changes: Mapping[str, Value],
    source_viewpoint: Any = None,
    target_viewpoint: Any = None,
    axis: Any = None,
    translation_bounds: Any = None,
) -> _emtr.Settings:
    """A preset with the changes made; what is None stays unknown.

    Raises:
        TypeError: an unknown setting (close names are listed), or a value of a wrong type.
        ValueError: a value out of range, an unknown preset, a guess that is not (4, 4), a
            viewpoint or axis that is not (3,) or not finite, bounds that are not (2, 3).
    """
    if not isinstance(preset, str):
        raise TypeError(f"preset: a name is expected, got {type(preset).__name__}")
    chosen = _emtr.Settings(preset)
    known = settings()
    for name, value in changes.items():
        if name not in known:
            raise TypeError(_unknown(name, list(known)))
        chosen.set(name, _number(known[name], value))
    chosen.set("threads", float(_whole("threads", threads)))
    chosen.seed = _seed(seed)
    if guess is not None:
        chosen.guess = as_transformation(guess, "guess").reshape(16)
    if source_viewpoint is not None:
        chosen.viewpoint_source = as_vector(source_viewpoint, "source_viewpoint", 3)
    if target_viewpoint is not None:
        chosen.viewpoint_target = as_vector(target_viewpoint, "target_viewpoint", 3)
    if axis is not None:
        chosen.axis = as_vector(axis, "axis", 3)
    if translation_bounds is not None:
        chosen.translation_bounds = as_bounds(translation_bounds, "translation_bounds")
    return chosen


def take_correspondences(chosen: _emtr.Settings, correspondences: Any) -> bool:
    """Hands them in; whether there are any. Raises as :func:`as_correspondences`."""
    if correspondences is not None:
        chosen.correspondences = as_correspondences(correspondences)
    return correspondences is not None


def thread_setting(threads: int) -> int:
    """The argument ``threads`` of calls that take no other setting; raises as above."""
    return int(make_settings(0, threads, "default", None, {}).get("threads"))


def settings_used(chosen: _emtr.Settings) -> dict[str, Any]:
    """All settings by name, as keyword arguments that repeat the run; poses: lists or None."""
    used: dict[str, Any] = {}
    for name, setting in settings().items():
        used[name] = _plain(setting.type, chosen.get(name), setting.choices)
    used["seed"] = chosen.seed  # exact, where a double is not
    guess = chosen.guess
    used["guess"] = None if guess is None else [guess[i : i + 4] for i in range(0, 16, 4)]
    used["source_viewpoint"] = chosen.viewpoint_source
    used["target_viewpoint"] = chosen.viewpoint_target
    used["axis"] = chosen.axis
    used["translation_bounds"] = chosen.translation_bounds
    return used


def _plain(kind: str, value: float, choices: tuple[str, ...]) -> Value:
    if kind == "real":
        return value
    if kind == "switch":
        return bool(value)
    return choices[int(value)] if kind == "choice" else int(value)


def _number(setting: Setting, value: Any) -> float:
    """The value as the number that the library takes; it checks the range itself."""
    if isinstance(value, (bool, np.bool_)):
        if setting.type != "switch":
            raise TypeError(f"{setting.name}: expected a number, got {value!r}")
        return float(value)
    if setting.type == "choice" and isinstance(value, str):
        if value not in setting.choices:
            raise ValueError(
                f"{setting.name}: expected one of {', '.join(setting.choices)}, got {value!r}"
            )
        return float(setting.choices.index(value))
    if setting.type != "real":
        return float(_whole(setting.name, value))
    if not isinstance(value, numbers.Real):
        raise TypeError(f"{setting.name}: expected a number, got {value!r}")
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{setting.name}: {value!r} is out of range") from None


def _whole(name: str, value: Any) -> int:
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{name}: expected an integer, got {value!r}")
    whole = operator.index(value)
    if abs(whole) >= 2**64:
        raise ValueError(f"{name}: {value!r} is out of range")
    return whole


def _seed(value: Any) -> int:
    whole = _whole("seed", value)
    if whole < 0:
        raise ValueError(f"seed: expected 0 <= seed < 2**64, got {value!r}")
    return whole


# that the table leaves out
_OWN = [
    "preset",
    "guess",
    "source_viewpoint",
    "target_viewpoint",
    "axis",
    "translation_bounds",
    "source_normals",
    "target_normals",
    "source_features",
    "target_features",
    "correspondences",
]


def _unknown(name: str, known: list[str]) -> str:
    close = difflib.get_close_matches(name, known + _OWN, n=3)
    hint = f"did you mean {' or '.join(close)}?" if close else "see pyemtr.settings()"
    return f"unknown setting {name!r}; {hint}"
