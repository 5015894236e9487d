"""The library's table of result fields is what a Result has, declares and describes."""

from __future__ import annotations

import inspect
import re
from dataclasses import fields
from typing import Any

import numpy as np
import pytest
from shapes import make_pair

import pyemtr
from pyemtr import _emtr, result

SCALARS = {
    "real": "float",
    "int32": "int",
    "switch": "bool",
    "size": "int",
    "uint64": "int",
    "text": "str",
    "reason": "str",
}


def declared_type(kind: str, rows: int, columns: int) -> str:
    if kind == "alternative":
        return "list[Alternative]"
    return SCALARS[kind] if rows * columns == 1 else "Floats"


def table() -> dict[str, str]:
    """The type of each attribute as the library's table says."""
    types = {"settings": "dict[str, Any]"}
    for name, group, key, kind, rows, columns in _emtr.describe_result():
        one = declared_type(kind, rows, columns)
        if key != name:
            types[result.ATTRIBUTES.get(group, group)] = f"dict[str, {one}]"
        else:
            types[name] = one
        if kind == "reason":
            types[f"{name}_text"] = one
    return types


@pytest.fixture(scope="module")
def found() -> pyemtr.Result:
    pair = make_pair(1, 3000)
    return pyemtr.register(pair.source, pair.target, preset="fast", iterations=5)


def test_the_class_declares_the_types_of_the_table() -> None:
    types = {field.name: str(field.type) for field in fields(pyemtr.Result)}
    # The table does not say which integer may be missing.
    assert {name: one.replace(" | None", "") for name, one in types.items()} == table()
    assert [name for name, one in types.items() if "None" in one] == ["unconstrained_directions"]


def test_the_docstring_describes_each_attribute() -> None:
    text = inspect.getdoc(pyemtr.Result).split("Attributes:")[1]  # Python 3.13 dedents it
    heads = re.findall(r"^ {4}(\w[\w, ]*):", text, re.MULTILINE)
    described = [name for head in heads for name in head.split(", ")]
    assert sorted(described) == sorted(table())


def is_a(value: Any, one: str) -> bool:
    if one.startswith("dict[str, ") and one != "dict[str, Any]":
        return bool(value) and all(is_a(item, one[10:-1]) for item in value.values())
    if one == "Floats":
        return isinstance(value, np.ndarray) and value.dtype == np.float64
    plain = {"float": float, "int": int, "bool": bool, "str": str}
    return type(value) is plain.get(one, list if one.startswith("list") else dict)


def test_each_value_has_the_type_of_the_table(found: pyemtr.Result) -> None:
    assert found.refined
    assert vars(found).keys() == table().keys()
    assert [n for n, one in table().items() if not is_a(getattr(found, n), one)] == []


def test_each_array_has_the_shape_of_the_table(found: pyemtr.Result) -> None:
    for name, _, key, kind, rows, columns in _emtr.describe_result():
        if kind != "real" or rows * columns == 1:
            continue
        if columns == 0:
            assert found.history[key].shape == (found.iterations,)
        else:
            shape = (columns,) if rows == 1 else (rows, columns)
            assert getattr(found, name).shape == shape


def test_the_groups_are_dicts_in_the_order_of_the_table(found: pyemtr.Result) -> None:
    assert list(found.queries) == ["evaluation", "switch", "complement"]
    assert list(found.history) == ["alpha", "beta"]
    assert next(iter(found.timings)) == "normalization" and list(found.timings)[-1] == "total"


def test_what_was_not_refined_has_no_unconstrained_directions() -> None:
    pair = make_pair(1, 3000)
    plain = pyemtr.register(pair.source, pair.target, preset="paper", iterations=3)
    assert not plain.refined and plain.unconstrained_directions is None


def test_a_new_field_of_the_table_becomes_an_attribute(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = [
        *_emtr.describe_result(),
        ("shape", "quality", "shape", "real", 2, 3),
        ("queries_other", "queries", "other", "uint64", 1, 1),
        ("weather_wind", "weather", "wind", "real", 1, 1),
    ]
    raw: dict[str, Any] = dict.fromkeys((row[0] for row in rows), 0)
    raw |= {
        "reason": ("low_overlap", "few points"),
        "alternatives": [(range(16), 0.5, 0.4, 0.3, 90.0)],
    }
    raw |= {"shape": [1, 2, 3, 4, 5, 6], "queries_other": 7, "weather_wind": 0.25}
    monkeypatch.setattr(_emtr, "describe_result", lambda: rows)
    made: Any = result.make_result(raw, {})
    np.testing.assert_array_equal(made.shape, [[1, 2, 3], [4, 5, 6]])
    assert made.queries["other"] == 7 and made.weather == {"wind": 0.25}
    assert (made.reason, made.reason_text) == ("low_overlap", "few points")
    assert made.alternatives[0].transformation[1, 2] == 6
    assert made.alternatives[0][1:] == (0.5, 0.4, 0.3, 90.0)
    written = made.to_dict()
    assert written["shape"] == [[1, 2, 3], [4, 5, 6]] and written["weather"] == {"wind": 0.25}
    assert next(iter(written)) == "transformation" and list(written)[-1] == "weather"
