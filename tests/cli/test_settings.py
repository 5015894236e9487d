"""Every setting of the library is an option, in --help-all and in the report, and acts."""

from __future__ import annotations

import json
import re
import subprocess

import numpy as np
import pytest
from conftest import ROOT

# From the C API's header, not from the command.
HEADER = (ROOT / "libemtr" / "include" / "emtr" / "emtr.h").read_text()
STRUCT = re.search(
    r"typedef struct emtr_settings \{(.*?)\} emtr_settings;", HEADER, re.DOTALL
).group(1)
NAMES = re.findall(r"^  (?:uint64_t|int32_t|double) (?!has_)(\w+);", STRUCT, re.MULTILINE)
NUMBER = r"(-?[\d.]+(?:e[+-]\d+)?)"
NEEDED = {
    "dense_points": ["--sparse-points", "50"],
    "feature_radius": ["--normal-radius", "1"],
    "complement_scale_start": ["--complement-scale-end", "0.001"],
    "scale_minimum": ["--scale", "bounded"],
    "scale_maximum": ["--scale", "bounded"],
    "guess_rotation": ["--guess", "guess.txt"],
    "guess_translation": ["--guess", "guess.txt"],
    "axis_tilt": ["--axis", "0", "0", "1"],
    "axis_angle_minimum": ["--axis", "0", "0", "1"],
    "axis_angle_maximum": ["--axis", "0", "0", "1", "--axis-angle-minimum", "-360"],
}


@pytest.fixture(scope="module")
def entries(command) -> dict[str, tuple[str, str]]:
    """The kind of value and the text, on one line, of each setting in --help-all."""
    asked = [command, "--help-all"]
    text = subprocess.run(asked, capture_output=True, text=True, check=True).stdout
    return {
        name.replace("-", "_"): (kind, " ".join(words.split()))
        for name, kind, words in re.findall(
            r"^  --(\S+) (\S+) (.*?)(?=^  -|^$)", text, re.MULTILINE | re.DOTALL
        )
    }


def test_the_header_was_understood():
    assert len(NAMES) > 40 and {"seed", "refine", "minimum_fitness_gap"} <= set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_help_gives_kind_and_default(entries, name):
    kind, text = entries[name]
    assert kind in ("N", "X", "NAME", "on|off")
    assert re.search(r"default \S+\]$", text)
    if kind in ("N", "X"):
        assert re.search(rf"{NUMBER} to {NUMBER}; default", text)


def other(name: str, kind: str, text: str) -> tuple[str, object]:
    """A value that is not the default, and how the report writes it: the least number, the last
    choice, the other position of a switch."""
    if name in ("seed", "threads"):
        return "2", 2
    if name == "scale_maximum":  # the least leaves nothing of the source beside the target
        return "2", 2
    if name == "use_colors":  # "on" needs some
        return "off", "off"
    if kind == "on|off":
        on = "default off" in text
        return ("on" if on else "off"), on
    if kind == "NAME":
        names = re.search(r"\[(.*?);", text).group(1).replace(" or ", ", ").split(", ")
        choice = [word for word in names if f"default {word}]" not in text][-1]
        return choice, choice
    least, most, usual = re.search(rf"{NUMBER} to {NUMBER}; default {NUMBER}\]", text).groups()
    return (most, float(most)) if least == usual else (least, float(least))


@pytest.mark.parametrize("name", NAMES)
def test_report_repeats_what_was_set(run, small, tmp_path, entries, name):
    """Sets it together with the options that it needs."""
    np.savetxt(tmp_path / "guess.txt", np.eye(4))
    value, expected = other(name, *entries[name])
    quick = [] if name in ("iterations", "population") else ["--iterations", "1"]
    done = run(
        *small,
        "--" + name.replace("_", "-"),
        value,
        *NEEDED.get(name, []),
        *quick,
        "--quiet",
        "--report",
        "r.json",
    )
    assert done.returncode in (0, 3), done.stderr
    settings = json.loads((tmp_path / "r.json").read_text())["settings"]
    assert list(settings) and set(settings) == set(NAMES)
    assert settings[name] == expected


@pytest.mark.parametrize(("on", "off"), [("on", "off"), ("1", "0")])
def test_switches_take_words_and_digits(run, small, tmp_path, on, off):
    for value, expected in ((on, True), (off, False)):
        run(*small, "--iterations", "1", "--transfer", value, "--report", "r.json")
        assert json.loads((tmp_path / "r.json").read_text())["settings"]["transfer"] is expected


def test_a_setting_changes_the_run(run, clouds, tmp_path):
    run(*clouds, "--iterations", "3", "--population", "6", "--report", "r.json")
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["counts"]["iterations"] == 3
    assert len(report["history"]["alpha"]) == len(report["history"]["beta"]) == 3


@pytest.mark.parametrize("seed", [0, 2**53 + 1, 2**64 - 1])
def test_seed_keeps_all_its_bits(run, small, tmp_path, seed):
    done = run(*small, "--iterations", "1", "--seed", seed, "--report", "r.json")
    assert done.returncode in (0, 3), done.stderr
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["seed"] == report["settings"]["seed"] == seed


def test_neighboring_large_seeds_differ(run, clouds):
    """As doubles they would be one number."""
    few = ["--preset", "paper", "--iterations", "5"]
    found = {run(*clouds, *few, "--seed", 2**60 + i).stdout for i in range(3)}
    assert len(found) == 3
