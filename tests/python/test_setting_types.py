"""The types of the settings for type checkers are those of the library's table."""

from __future__ import annotations

import typing
from dataclasses import fields

import pytest

import pyemtr
from pyemtr.inputs import Inputs
from pyemtr.setting_types import AllSettings, MethodSettings, Switch, When

TYPES = typing.get_type_hints(MethodSettings)
ALL = pyemtr.settings()


def test_every_setting_has_a_type_in_the_table_s_order() -> None:
    assert list(TYPES) == [name for name in ALL if name not in ("seed", "threads")]
    assert not MethodSettings.__required_keys__


@pytest.mark.parametrize("name", TYPES)
def test_the_type_is_that_of_the_table(name: str) -> None:
    setting = ALL[name]
    plain = {"integer": int, "real": float, "switch": Switch}
    if name == "scale":  # one of the choices, or numbers that stand for "bounded"
        choices, *numbers = typing.get_args(TYPES[name])
        assert typing.get_args(choices) == setting.choices
        assert numbers == [float, tuple[float, float]]
    elif setting.type == "choice":
        assert typing.get_args(TYPES[name]) == setting.choices
    else:
        assert TYPES[name] == plain[setting.type]


def test_choices_of_the_same_values_have_one_type() -> None:
    same = [name for name in TYPES if ALL[name].choices == typing.get_args(When)]
    assert same and all(TYPES[name] == When for name in same)


def test_a_problem_s_arguments_have_types_too() -> None:
    more = [name for name in typing.get_type_hints(AllSettings) if name not in TYPES]
    assert more == [field.name for field in fields(Inputs)]
