"""The benchmarks' commands as a stranger meets them: help, names, the pairs by default."""

import os
import re
import subprocess
import sys

import pytest
from accuracy_fakes import REPOSITORY

FOLDER = REPOSITORY / "tools" / "bench"
COMMANDS = sorted(file.name for file in FOLDER.iterdir() if os.access(file, os.X_OK)
                  and file.is_file())  # fmt: skip
OF_PAIRS = (
    "ablation",
    "accuracy",
    "align_all",
    "calibration",
    "fit_confidence",
    "matches",
    "peers",
    "reproduce",
    "stages",
)


def run(name, *words):
    """With a Python that has the standard library alone."""
    path = FOLDER / name
    in_python = "python3" in path.read_text().splitlines()[0]
    start = [sys.executable, "-S", "-E", "-W", "error"] if in_python else []
    return subprocess.run(
        [*start, str(path), *words], capture_output=True, text=True, timeout=60, check=False
    )


def test_all_commands_are_found():
    others = {"batch", "cancel", "colors", "convert", "neighbors", "regress", "report", "scaling"}
    assert {*OF_PAIRS, *others} <= set(COMMANDS)


@pytest.mark.parametrize("name", COMMANDS)
def test_help_needs_no_more_than_python(name):
    done = run(name, "--help")
    assert done.returncode == 0 and not done.stderr, done.stderr
    assert re.match(rf"(?i)usage: (tools/bench/)?{name} ", done.stdout)
    if name in OF_PAIRS:
        assert "--data DIR" in done.stdout and "docs/BENCHMARKING.md" in done.stdout


@pytest.mark.parametrize("name", [name for name in COMMANDS if name != "neighbors"])
def test_a_bad_option_is_told_under_the_commands_name(name):
    done = run(name, *(["from", "to"] if name == "convert" else []), "--no-such-option")
    assert done.returncode == 2
    assert f"{name}: error: unrecognized arguments: --no-such-option" in done.stderr


@pytest.mark.parametrize("name", OF_PAIRS)
def test_data_that_are_not_there_are_told_under_the_commands_name(name):
    smoke = ["--smoke"] if name == "peers" else []  # which installs nothing
    done = subprocess.run(
        [sys.executable, str(FOLDER / name), "--data", "/nowhere", *smoke],
        capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    assert done.returncode == 2
    assert done.stderr.startswith(f"{name}: --data /nowhere: no such folder")


@pytest.mark.parametrize(
    ("name", "first", "step"),
    [("neighbors", "neighbors: error: no /nowhere/tools/bench/bench_neighbors", "cmake --build"),
     ("regress", "regress: /nowhere: no /nowhere/tools/pcl_emtr", "tools/quickstart builds it")],
)  # fmt: skip
def test_a_program_that_is_not_built_is_told_with_the_next_step(name, first, step):
    done = subprocess.run(
        [sys.executable, str(FOLDER / name)] if name == "regress" else [str(FOLDER / name)],
        capture_output=True, text=True, timeout=60, check=False,
        env={**os.environ, "EMTR_BUILD_DIR": "/nowhere"},
    )  # fmt: skip
    assert done.returncode == 2
    assert done.stderr.startswith(first) and step in done.stderr
