"""A wrong setting is refused with what may be meant; a switch takes the words of the table."""

from __future__ import annotations

import pytest

import pyemtr
from pyemtr.options import make_settings
from pyemtr.suggestions import unknown_setting

SUGGESTED = {
    "rmp": "transfer_probability",  # as the paper has it
    "MaxIt": "iterations",
    "maxit": "iterations",
    "eta": "outlier_penalty",
    "c2": "social",
    "itertions": "iterations",
    "num_threads": "threads",
    "random_state": "seed",
    "trans_init": "guess",
    "popsize": "population",
}


@pytest.mark.parametrize("name", SUGGESTED)
def test_the_setting_s_own_name_is_suggested_first(pair, name: str) -> None:
    for call in (pyemtr.register, pyemtr.Problem):
        with pytest.raises(TypeError, match=rf"'{name}'; did you mean {SUGGESTED[name]}\b"):
            call(pair.source, pair.target, **{name: 1})


def test_a_voxel_size_is_not_needed(pair) -> None:
    with pytest.raises(TypeError, match="'voxel_size'; none is needed"):
        pyemtr.register(pair.source, pair.target, voxel_size=0.05)


def test_a_name_like_no_other_points_to_the_table() -> None:
    assert unknown_setting("zzz", {"seed": "of all"}).endswith("see pyemtr.settings()")
    assert unknown_setting("rm", {"chance": "(rmp)"}).endswith("see pyemtr.settings()")


@pytest.mark.parametrize("word, value", [("on", 1), ("off", 0), (True, 1), (False, 0), (1, 1)])
def test_a_switch_takes_on_and_off(word, value) -> None:
    assert make_settings("default", {"transfer": word}).get("transfer") == value


@pytest.mark.parametrize(
    "change, error, text",
    [
        ({"transfer": "no"}, TypeError, "transfer: expected True or False .*got 'no'"),
        ({"fallback_search": False}, TypeError, "one of off, auto, always, got False"),
        ({"fallback_search": "never"}, ValueError, "one of off, auto, always, got 'never'"),
        ({"iterations": "off"}, TypeError, "iterations: expected an integer"),
        ({"inertia_start": "on"}, TypeError, "inertia_start: expected a number"),
        ({"inertia_start": True}, TypeError, "inertia_start: expected a number"),
        ({"iterations": True}, TypeError, "iterations: expected a number"),
    ],
)
def test_a_value_of_another_type_is_told_what_is_expected(change, error, text) -> None:
    with pytest.raises(error, match=text):
        make_settings("default", change)
