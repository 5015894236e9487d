"""Every setting of the library is an option, in --help and in the report, and acts."""

from __future__ import annotations

import json
import re

import pytest
from conftest import ROOT

# From the C API's header, not from the command.
HEADER = (ROOT / "libemtr" / "include" / "emtr" / "emtr.h").read_text()
STRUCT = re.search(r"typedef struct emtr_settings \{(.*?)\} emtr_settings;", HEADER,
                   re.DOTALL).group(1)
NAMES = [name for name in
         re.findall(r"^  (?:size_t|uint64_t|int32_t|double) (\w+)[;\[]", STRUCT, re.MULTILINE)
         if name not in ("size", "has_guess", "guess")]

OTHER = {"seed": "5", "threads": "2", "transfer": "off", "complement": "0",
         "sparse_to_dense": "off", "neighbors": "brute"}


def test_the_header_was_understood():
    assert len(NAMES) > 30 and "seed" in NAMES and "minimum_mode_gap" in NAMES


@pytest.mark.parametrize("name", NAMES)
def test_help_gives_kind_and_default(run, name):
    option = "--" + name.replace("_", "-")
    entry = re.search(rf"^  {option} (\S+) (.*?)(?=^  -|^$)", run("--help").stdout,
                      re.MULTILINE | re.DOTALL)
    assert entry, f"{option} is not in --help"
    text = " ".join(entry.group(2).split())
    assert entry.group(1) in ("N", "X", "NAME", "on|off")
    assert re.search(r"default \S+\]$", text)
    if entry.group(1) in ("N", "X"):
        assert re.search(r"[\d.]+ to [\d.]+; default", text)


def bounds(run, name: str) -> str:
    option = "--" + name.replace("_", "-")
    text = " ".join(run("--help").stdout.split())
    return re.search(rf"{option} [NX] .*?([\d.]+) to ", text).group(1)


@pytest.mark.parametrize("name", NAMES)
def test_report_repeats_what_was_set(run, small, tmp_path, name):
    """The least value of each is allowed, if need be together with its partner's."""
    value = OTHER.get(name) or bounds(run, name)
    partner = {"dense_points": ["--sparse-points", "50"],
               "feature_radius": ["--normal-radius", value],
               "complement_scale_start": ["--complement-scale-end", value]}.get(name, [])
    quick = [] if name in ("iterations", "population") else ["--iterations", "1"]
    done = run(*small, "--" + name.replace("_", "-"), value, *partner, *quick, "--quiet",
               "--report", "r.json")
    assert done.returncode in (0, 3), done.stderr
    settings = json.loads((tmp_path / "r.json").read_text())["settings"]
    assert list(settings) and set(settings) == set(NAMES)
    expected = {"off": False, "0": False}.get(value, value) if name in (
        "transfer", "complement", "sparse_to_dense") else value
    if isinstance(expected, str) and expected != "brute":
        expected = float(expected)
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


def test_neighbouring_large_seeds_differ(run, clouds):
    """As doubles they would be one number."""
    found = {run(*clouds, "--iterations", "5", "--seed", 2**60 + i).stdout for i in range(3)}
    assert len(found) == 3
