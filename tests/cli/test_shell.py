"""What shells offer, the manual page, and colors: they follow the command's own list of options."""

from __future__ import annotations

import os
import pty
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import QUICK, ROOT
from test_help import help_text, options_in

SHELL = ROOT / "tools" / "pcl_emtr" / "shell"


@pytest.fixture
def everything(run) -> set[str]:
    return options_in(help_text(run, "--help-all"))


def completions(command: Path, *words: str) -> list[str]:
    """What bash offers for the last of these words."""
    script = (
        f'source "{SHELL}/pcl_emtr.bash"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _pcl_emtr;'
        'printf "%s\\n" "${COMPREPLY[@]}"'
    )
    done = subprocess.run(
        ["bash", "-c", script, "bash", str(command), *words],
        capture_output=True,
        text=True,
        check=True,
    )
    assert not done.stderr
    return done.stdout.split()


def test_bash_offers_every_option(command, everything):
    assert set(completions(command, "-")) == everything
    assert completions(command, "a.pcd", "--pre") == ["--preset"]


@pytest.mark.parametrize(
    ("words", "offered"),
    [
        (["--preset", ""], {"default", "fast", "thorough", "paper"}),
        (["--preset", "th"], {"thorough"}),
        (["--preset", "=", "fa"], {"fast"}),
        (["--preset", "="], {"default", "fast", "thorough", "paper"}),
        (["--neighbors", ""], {"grid", "kdtree", "brute"}),
        (["--transfer", "o"], {"on", "off"}),
        (["--viewpoint", ""], {"file", "none"}),
        (["--aligned-format", ""], {".pcd", ".ply", ".obj"}),
        (["--seed", ""], set()),
        (["a.p"], set()),
    ],
)
def test_bash_offers_values(command, words, offered):
    assert set(completions(command, *words)) == offered


def test_bash_offers_what_each_choice_accepts(command, run, everything, small):
    """An option that refuses a word in favor of others has these others offered."""
    found = 0
    for option in everything:
        message = run(*small, f"{option}=nonsense").stderr
        choices = re.search(r"'nonsense' is not ((?:[\w.]+, )*[\w.]+ or [\w.]+)", message)
        if not choices or "number" in choices[1]:
            continue
        found += 1
        expected = set(re.split(", | or ", choices[1])) - {"0", "1"}
        assert set(completions(command, option, "")) == expected, option
    assert found > 5


def test_zsh_offers_every_option(command, everything):
    if not shutil.which("zsh"):
        pytest.skip("no zsh")
    script = (
        'words=("$1"); _arguments() { print -rl -- "$@"; }; '
        f"f() {{ {(SHELL / '_pcl_emtr').read_text()}\n }}; f"
    )
    done = subprocess.run(
        ["zsh", "-fc", script, "zsh", str(command)], capture_output=True, text=True, check=True
    )
    specs = done.stdout.splitlines()
    assert {re.match(r"--[\w-]+", spec)[0] for spec in specs if spec.startswith("--")} - {
        "--"
    } == everything
    assert any(re.match(r"--neighbors=\[.*\]:value:\(grid kdtree brute\)$", s) for s in specs)
    assert any(re.match(r"--aligned=\[.*\]:file:_files$", s) for s in specs)
    assert any(re.match(r"--quiet\[.*\]$", s) for s in specs)


def test_manual_page_is_what_the_help_says(command, everything):
    done = subprocess.run(
        [sys.executable, ROOT / "tools" / "man_page.py"],
        env=os.environ | {"EMTR_CLI": str(command)},
        capture_output=True,
        text=True,
        check=True,
    )
    page = (SHELL / "pcl_emtr.1").read_text()
    assert page == done.stdout, "run tools/man_page.py --write"
    for option in everything:
        assert option.replace("-", "\\-") in page


def test_manual_page_has_no_fault(command):
    if not shutil.which("groff"):
        pytest.skip("no groff")
    done = subprocess.run(
        ["groff", "-man", "-ww", "-Tutf8", SHELL / "pcl_emtr.1"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert not done.stderr
    plain = re.sub(r"\x1b\[[0-9;]*m", "", done.stdout)
    assert "--mesh-points" in plain and "pcl_emtr scan1.pcd scan2.pcd -o T.txt" in plain


def on_terminal(command, folder, **variables: str) -> str:
    """What standard error gets when it is a terminal that PCL knows to have colors."""
    master, slave = pty.openpty()
    process = subprocess.Popen(
        [command, "a.pcd", "b.pcd", *QUICK, "-o", "T.txt"],
        cwd=folder,
        stderr=slave,
        env={k: v for k, v in os.environ.items() if k != "NO_COLOR"}
        | {"TERM": "xterm"}
        | variables,
    )
    os.close(slave)
    talk = b""
    try:
        while chunk := os.read(master, 65536):
            talk += chunk
    except OSError:  # the other end is closed
        pass
    os.close(master)
    assert process.wait(timeout=60) in (0, 3)
    return talk.decode()


def test_colors(command, small, tmp_path):
    color = re.compile(r"\033\[[0-9;]*m")
    assert color.search(on_terminal(command, tmp_path))
    assert color.search(on_terminal(command, tmp_path, NO_COLOR=""))
    plain = on_terminal(command, tmp_path, NO_COLOR="1")
    assert not color.search(plain) and "\033[K" in plain  # the progress line is no color
    assert "\033" not in on_terminal(command, tmp_path, TERM="dumb")
