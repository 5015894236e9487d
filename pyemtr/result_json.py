"""The fields of a result as JSON values, and back."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from .alternative import Alternative
from .arrays import Floats

_SHAPES = {
    "transformation": (4, 4),
    "information": (6, 6),
    "information_similarity": (7, 7),
    "hessian_eigenvectors": (6, 6),
    "hessian_eigenvalues": (6,),
}


def to_json(values: Mapping[str, Any]) -> dict[str, Any]:
    """Returns lists for arrays, None for NaN and infinities, dicts for alternatives."""
    return {name: _json(value) for name, value in values.items()}


def from_json(values: Any, types: Mapping[str, str]) -> dict[str, Any]:
    """Returns what :func:`to_json` was given, by the declared type of each field.

    A field that ``types`` does not have stays as it is.

    Raises:
        TypeError: not a dict.
        ValueError: a field is missing, or is not of its type and shape.
    """
    if not isinstance(values, Mapping):
        raise TypeError(f"expected a dict as to_dict() returns it, got {type(values).__name__}")
    missing = [name for name in types if name not in values]
    if missing:
        raise ValueError(f"not a result: {', '.join(missing)}: missing")
    found = {}
    for name, value in values.items():
        try:
            found[name] = _value(name, value, types.get(name, "Any"))
        except (TypeError, ValueError, KeyError, AttributeError) as error:
            raise ValueError(f"{name}: expected {types[name]}, got {value!r}: {error}") from error
    return found


def _value(name: str, value: Any, kind: str) -> Any:
    if kind == "Floats":
        return _floats(value, _SHAPES.get(name))
    if kind == "float":
        return _float(value)
    if kind == "dict[str, Floats]":
        return {key: _floats(item) for key, item in value.items()}
    if kind == "dict[str, float]":
        return {key: _float(item) for key, item in value.items()}
    if kind == "list[Alternative]":
        return [_alternative(**item) for item in value]
    plain = {"int": int, "bool": bool, "str": str}.get(kind)
    if plain is not None and type(value) is not plain:
        raise TypeError(f"got a {type(value).__name__}")
    return value


def _alternative(transformation: Any, **numbers: Any) -> Alternative:
    return Alternative(
        _floats(transformation, (4, 4)), **{name: _float(value) for name, value in numbers.items()}
    )


def _float(value: Any) -> float:
    return math.nan if value is None else float(value)


def _floats(values: Any, shape: tuple[int, ...] | None = None) -> Floats:
    array = np.array(values, dtype=np.float64)  # None becomes NaN
    if shape is not None and array.shape != shape:
        raise ValueError(f"expected the shape {shape}, got {array.shape}")
    return array


def _json(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return _json(value.tolist())
    if isinstance(value, Alternative):
        return _json(value._asdict())
    if isinstance(value, dict):
        return {key: _json(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_json(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
