"""The settings: the table of them, and their values as the C library reads them."""

from __future__ import annotations

import numbers
import operator
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Union

import numpy as np

from . import _emtr
from .suggestions import unknown_setting

Value = Union[int, float, bool, str]


@dataclass(frozen=True)
class Setting:
    """One setting of the method.

    Attributes:
        name: the keyword argument.
        type: "integer", "real", "switch" (False or True) or "choice" (one of ``choices``).
        unit: "" where there is none. Only lengths of the part "priors" are in the cloud's own unit.
        minimum, maximum: the range, both inclusive.
        default: the value in preset "default".
        part: the part of the method that the setting belongs to.
        text: its meaning in one line.
        choices: the names that a "choice" takes, else empty.
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
    """Returns every setting by name, in the library's order."""
    found = {}
    for name, kind, unit, low, high, value, part, text, choices in _emtr.describe_settings():
        names = tuple(word.strip() for word in choices.split(",")) if choices else ()
        found[name] = Setting(
            name, kind, unit, low, high, _plain(kind, value, names), part, text, names
        )
    return found


def presets() -> list[str]:
    """Returns the names that the argument ``preset`` takes."""
    return _emtr.preset_names()


def make_settings(
    preset: str,
    changes: Mapping[str, Value],
    *,
    seed: int = 0,
    threads: int = 0,
    arguments: Sequence[str] = (),
) -> _emtr.Settings:
    """Returns a preset with the changes made.

    The names in ``arguments`` are suggested for a mistyped setting too.

    Raises:
        TypeError: an unknown setting (close names are listed), or a value of a wrong type.
        ValueError: a value out of range, or an unknown preset.
    """
    if not isinstance(preset, str):
        raise TypeError(f"preset: a name is expected, got {type(preset).__name__}")
    chosen = _emtr.Settings(preset)
    known = settings()
    for name, value in _plain_scale(changes).items():
        if name not in known:
            raise TypeError(
                unknown_setting(
                    name, {**{n: s.text for n, s in known.items()}, **dict.fromkeys(arguments, "")}
                )
            )
        chosen.set(name, _number(known[name], value))
    chosen.set("threads", float(_whole("threads", threads)))
    chosen.seed = _seed(seed)
    return chosen


def _plain_scale(changes: Mapping[str, Any]) -> Mapping[str, Any]:
    """Returns the changes with a scale that is given by numbers as settings of the library: one
    number, which is known, or the bounds of an unknown one."""
    value = changes.get("scale")
    if value is None or isinstance(value, (str, bool, np.bool_)):
        return changes
    bounds = (value, value) if isinstance(value, numbers.Real) else value
    try:
        low, high = bounds
    except (TypeError, ValueError):
        raise TypeError(
            f"scale: expected 'free', 'units', a number or its two bounds, got {value!r}"
        ) from None
    for name in ("scale_minimum", "scale_maximum"):
        if name in changes:
            raise TypeError(f"{name}: given beside the bounds in scale={value!r}")
    if low == high == 1:
        return {**changes, "scale": "fixed"}
    return {**changes, "scale": "bounded", "scale_minimum": low, "scale_maximum": high}


def require_rigid(settings: Mapping[str, Any]) -> None:
    """Raises ValueError where the settings search a scale: the poses of many scans are rigid."""
    if settings.get("scale", "fixed") not in ("fixed", 1):
        raise ValueError(
            f"scale: expected clouds of one unit, got {settings['scale']!r}: the poses are rigid"
        )


def thread_setting(threads: int) -> int:
    """Checks the argument ``threads`` of calls without other settings; raises as above."""
    return int(make_settings("default", {}, threads=threads).get("threads"))


def settings_used(chosen: _emtr.Settings) -> dict[str, Any]:
    """Returns all settings as keyword arguments that repeat the run; vectors are lists or None."""
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
    """Returns the value as the number that the library takes and checks the range of."""
    plain = isinstance(value, (bool, np.bool_))
    if setting.type == "switch":
        if plain:
            return float(value)
        if isinstance(value, str):
            if value not in ("on", "off"):
                raise TypeError(
                    f'{setting.name}: expected True or False ("on", "off"), got {value!r}'
                )
            return float(value == "on")
    elif setting.type == "choice" and (plain or isinstance(value, str)):
        if plain or value not in setting.choices:
            raise (TypeError if plain else ValueError)(
                f"{setting.name}: expected one of {', '.join(setting.choices)}, got {value!r}"
            )
        return float(setting.choices.index(value))
    elif plain:
        raise TypeError(f"{setting.name}: expected a number, got {value!r}")
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
