"""The version stands in emtr.h; everything else takes it from there."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pyemtr

ROOT = Path(__file__).resolve().parents[2]
HEADER = (ROOT / "libemtr/include/emtr/emtr.h").read_text()
VERSION = ".".join(re.findall(r"^#define EMTR_VERSION_[A-Z]+ (\d+)$", HEADER, re.MULTILINE))


def test_it_has_three_numbers() -> None:
    assert re.fullmatch(r"\d+\.\d+\.\d+", VERSION)


def test_python_and_setuptools_have_it() -> None:
    printed = subprocess.run(
        [sys.executable, "setup.py", "--version"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    assert printed.split()[-1] == VERSION == pyemtr.__version__


def test_the_newest_change_is_of_it() -> None:
    changes = re.findall(r"^## (\S+)", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
    assert changes[0] == VERSION


def test_it_is_written_nowhere_else() -> None:
    suffixes = {".cmake", ".in", ".txt", ".py", ".md", ".h", ".hpp", ".cpp", ".pyx"}
    folders = [ROOT / folder for folder in ("libemtr", "pyemtr", "tools", "docs")]
    files = [path for folder in folders for path in folder.rglob("*") if path.suffix in suffixes]
    files += [ROOT / name for name in ("CMakeLists.txt", "setup.py", "pyproject.toml", "README.md")]
    literal = re.compile(rf"(?<![\d.]){re.escape(VERSION)}(?![\d.]*\d)")
    assert len(files) > 200
    assert [str(path) for path in files if literal.search(path.read_text())] == []
