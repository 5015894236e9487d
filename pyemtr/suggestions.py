"""What a mistyped setting, or one by another name, may mean."""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping

# Names of other libraries that are neither close to ours nor in the text of a setting.
_ELSEWHERE = {
    "random_state": "seed",
    "rng": "seed",
    "init": "guess",
    "initial_guess": "guess",
    "initial_transform": "guess",
    "trans_init": "guess",
    "init_T_target_source": "guess",
    "n_jobs": "threads",
    "workers": "threads",
    "maxiter": "iterations",
    "popsize": "population",
    "verbose": "callback",
}
# Lengths that other libraries ask for.
_NEEDLESS = ("voxel_size", "downsampling_resolution", "max_correspondence_distance")


def unknown_setting(name: str, known: Mapping[str, str]) -> str:
    """Returns the message for a name that is not among those ``known`` with their meaning.

    It suggests names that are spelled alike, those whose meaning has the name as a word (the
    paper's ``rmp`` and ``MaxIt``), and what other libraries call so.
    """
    if name in _NEEDLESS:
        return f"unknown setting {name!r}; none is needed: all lengths come from the clouds"
    found = [setting for setting, text in known.items() if _has_word(text, name)]
    found += [_ELSEWHERE[name]] if name in _ELSEWHERE else []
    found += difflib.get_close_matches(name, known, n=3)
    first = list(dict.fromkeys(found))[:3]
    hint = f"did you mean {' or '.join(first)}?" if first else "see pyemtr.settings()"
    return f"unknown setting {name!r}; {hint}"


def _has_word(text: str, word: str) -> bool:
    return re.search(rf"(?<![\w.-]){re.escape(word)}(?![\w.-])", text, re.IGNORECASE) is not None
