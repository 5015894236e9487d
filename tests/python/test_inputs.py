"""The arguments that register() and Problem() share are written once, and alike in both."""

from __future__ import annotations

import inspect
from dataclasses import fields

import pytest

import pyemtr
from pyemtr.inputs import Inputs

DEFAULTS = {field.name: field.default for field in fields(Inputs)}


@pytest.mark.parametrize("function", [pyemtr.register, pyemtr.Problem])
def test_signatures_have_the_inputs_and_their_defaults(function) -> None:
    found = {
        name: parameter.default
        for name, parameter in inspect.signature(function).parameters.items()
        if parameter.kind is parameter.KEYWORD_ONLY and name != "callback"
    }
    assert found == DEFAULTS
    assert list(found) == list(DEFAULTS)  # in the same order


@pytest.mark.parametrize("function", [pyemtr.register, pyemtr.Problem])
@pytest.mark.parametrize("name", [name for name in DEFAULTS if name not in ("seed", "threads")])
def test_each_input_reaches_the_library(function, name: str, pair) -> None:
    """An object that is no value of any input is refused by the input's own name."""
    with pytest.raises((TypeError, ValueError), match=f"^{name}: "):
        function(pair.source, pair.target, **{name: object()})


@pytest.mark.parametrize("name", DEFAULTS)
def test_a_mistyped_input_is_suggested(name: str, pair) -> None:
    with pytest.raises(TypeError, match=rf"unknown setting '{name}_'; did you mean .*\b{name}\b"):
        pyemtr.register(pair.source, pair.target, **{f"{name}_": 1})
