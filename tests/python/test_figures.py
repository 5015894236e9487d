"""The figures of docs/HOW_IT_WORKS.md are drawn from runs, and are those that the page shows."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pages
import pytest
from pages import ROOT

FIGURES = ROOT / "docs" / "figures"
SHOWN = re.findall(r"\]\(figures/([\w.]+)\)", (ROOT / "docs" / "HOW_IT_WORKS.md").read_text())


def draw(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    script = [sys.executable, str(FIGURES / "draw.py"), *map(str, arguments)]
    return subprocess.run(script, capture_output=True, text=True, timeout=600, check=False)


def test_the_page_shows_what_is_drawn() -> None:
    there = {path.name for path in FIGURES.iterdir() if path.suffix in (".svg", ".png")}
    assert set(SHOWN) == there
    assert all((FIGURES / name).stat().st_size < 150_000 for name in SHOWN)


@pytest.mark.parametrize("name", ["matches.png", "candidates.svg"])
def test_a_figure_is_drawn(name: str, tmp_path: Path) -> None:
    done = draw("--out", tmp_path, "--points", "4000", name)
    assert done.returncode == 0, done.stderr
    assert [path.name for path in tmp_path.iterdir()] == [name]
    assert (tmp_path / name).stat().st_size > 5000


def test_an_unknown_figure_is_refused(tmp_path: Path) -> None:
    done = draw("--out", tmp_path, "graph.png")
    assert done.returncode == 2
    assert "graph.png" in done.stderr and "swarms.svg" in done.stderr
    assert pages.run([sys.executable, str(FIGURES / "draw.py"), "--help"], tmp_path).stdout
