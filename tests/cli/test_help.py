"""--help fits on one screen, and --help-all tells what there is."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT
from test_settings import NAMES


def help_text(run, flag: str) -> str:
    done = run(flag)
    assert done.returncode == 0
    assert not done.stderr
    return done.stdout


def options_in(text: str) -> set[str]:
    """The options that have a line of their own, by their long names."""
    return set(re.findall(r"^  (?:-\w, ?)?(--[\w-]+)", text, re.MULTILINE))


@pytest.mark.parametrize("flag", ["-h", "--help"])
def test_help_fits_on_one_screen(run, flag):
    text = help_text(run, flag)
    lines = text.splitlines()
    assert len(lines) < 24  # the prompt takes one
    assert max(map(len, lines)) < 80
    assert text.isascii() and text.endswith("\n")
    for part in (
        "Usage: pcl_emtr [OPTIONS] source target",
        "q = R p + t",
        "-o, --output FILE",
        "--aligned FILE",
        "--report FILE",
        "--preset NAME",
        "--guess FILE",
        "-q, --quiet",
        "--help-all",
        "Example: pcl_emtr",
        "Exit codes: 0 registered, 1 ",
    ):
        assert part in text, part
    assert 10 <= len(options_in(text)) <= 14


def test_help_names_the_presets(run, small):
    presets = re.search(r"is not one of: (.*)", run(*small, "--preset", "quick").stderr).group(1)
    line = re.search(r"--preset NAME *(.*)", help_text(run, "--help")).group(1)
    assert set(re.split(", | or ", presets)) <= set(re.findall(r"\w+", line))


def test_help_is_part_of_help_all(run):
    assert options_in(help_text(run, "--help")) <= options_in(help_text(run, "--help-all"))


def test_help_all(run):
    text = help_text(run, "--help-all")
    for part in (
        "Usage: pcl_emtr [OPTIONS] source target",
        "Examples:",
        "Exit codes:",
        "q = R p + t",
        "-o,--output FILE",
        "--aligned FILE",
        "--report FILE",
        "--guess FILE",
        "--preset NAME",
        "--viewpoint-source X Y Z",
        "--viewpoint file|none",
        "--reference",
        "-q,--quiet",
        "--version",
    ):
        assert part in text
    for code, meaning in enumerate(["registered", "usage", "input or output", "not registered"]):
        assert re.search(rf"^  {code}  {meaning}", text, re.MULTILINE)
    assert max(map(len, text.splitlines())) <= 100
    assert "\n\n\n" not in text.partition("Examples:")[0].rstrip()


def test_help_all_has_every_setting_by_group(run):
    groups = re.split(r"^(\S.*):\n", help_text(run, "--help-all"), flags=re.MULTILINE)
    found: dict[str, str] = {}
    for title, text in zip(groups[1::2], groups[2::2], strict=True):
        for option in options_in(text):
            assert option not in found, option
            found[option] = title
    for name in NAMES:
        assert "--" + name.replace("_", "-") in found, name
    assert found["--population"] == "Settings of the method: particle swarm"
    assert found["--output"] == "Output files" and found["--seed"] == "Options"
    assert found["--use-normals"] == "User-provided data"


def test_every_format_is_on_its_page(run):
    section = help_text(run, "--help-all").partition("Formats, by")[2].partition("Notes:")[0]
    listed = re.findall(r"^  (\.\w+) ", section, re.MULTILINE)
    assert len(listed) >= 14
    table = (ROOT / "docs" / "FORMATS.md").read_text().partition("## Text")[0]
    for extension in listed:
        assert f"`{extension}`" in table
        assert extension in help_text(run, "--help")


def test_help_wins_over_whatever_else_is_given(run):
    assert run("a.pcd", "--help", "--nonsense").stdout == help_text(run, "--help")
    assert run("a.pcd", "--help-all", "--nonsense").stdout == help_text(run, "--help-all")
