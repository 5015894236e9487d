"""Every snippet of the pages runs as it is there, links lead somewhere, tables are true."""

from __future__ import annotations

import os
import re
import shutil
import sys
from pathlib import Path

import numpy as np
import pages
import pytest
from pages import PAGES, ROOT, run

README = ROOT / "README.md"

SNIPPETS = [
    (f"{pages.name(page)}-{number}", language, text)
    for page in PAGES
    for number, (language, text) in enumerate(pages.snippets(page), 1)
]
RUNNABLE = {"bash", "python", "cpp", "cmake", "c"}
OTHERS = {"py", "c++"}  # code of other libraries; test_porting.py runs it, and all of its page
PORTING = "docs/PORTING.md"


def snippets(language: str) -> list[pytest.param]:
    """The snippets of all pages in one language, each with its page's name and its number there."""
    return [
        pytest.param(text, id=name)
        for name, one, text in SNIPPETS
        if one == language and not name.startswith(PORTING)
    ]


def test_every_language_is_accounted_for() -> None:
    assert {language for _, language, _ in SNIPPETS} == RUNNABLE | OTHERS | {"text"}
    assert all(name.startswith(PORTING) for name, language, _ in SNIPPETS if language in OTHERS)


def test_the_readme_begins_with_each_entry_point() -> None:
    text = README.read_text()
    assert text.count("\n") <= 250
    assert {language for language, _ in pages.snippets(README)} == RUNNABLE | {"text"}


@pytest.mark.parametrize("page", PAGES, ids=pages.name)
def test_links_lead_somewhere(page: Path) -> None:
    broken = []
    for link in re.findall(r"\]\(([^)\s]+)\)", pages.prose(page)):
        if link.startswith("https://"):
            continue
        file, _, anchor = link.partition("#")
        target = page.parent / file if file else page
        if not target.exists() or (anchor and anchor not in pages.anchors(target)):
            broken.append(link)
    assert broken == []


@pytest.mark.parametrize("snippet", snippets("python"))
def test_python(snippet: str, sample: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(sample, tmp_path / "sample")
    run([sys.executable, "-c", snippet], folder)


def test_the_tour_prints_what_it_says(sample: Path, tmp_path: Path) -> None:
    snippets = pages.snippets(ROOT / "docs" / "TOUR.md")
    (number,) = (n for n, (language, _) in enumerate(snippets) if language == "python")
    folder = shutil.copytree(sample, tmp_path / "sample")
    printed = run([sys.executable, "-c", snippets[number][1]], folder).stdout
    told = snippets[number + 1][1]
    assert re.sub(r"[\d.]+", "#", printed) == re.sub(r"[\d.]+", "#", told)
    # The sample is made by numpy, whose last digits differ between processors.
    numbers = [[float(n) for n in re.findall(r"\d+\.?\d*", text)] for text in (printed, told)]
    assert numbers[0] == pytest.approx(numbers[1], rel=0.04)
    assert (folder / "picture.png").stat().st_size > 50_000
    source = np.loadtxt(folder / "source.xyz")
    np.testing.assert_array_equal(source, np.load(sample / "source.npy"))


@pytest.mark.parametrize("snippet", snippets("bash"))
def test_shell(snippet: str, prefix: Path, sample: Path) -> None:
    path = f"{prefix / 'bin'}{os.pathsep}{os.environ['PATH']}"
    run(["bash", "-euo", "pipefail", "-c", snippet], sample, PATH=path)
    assert np.loadtxt(sample / "T.txt").shape == (4, 4)


def test_settings_table() -> None:
    printed = run([sys.executable, str(ROOT / "tools" / "settings_table.py")], ROOT).stdout
    table = pages.marked(ROOT / "docs" / "SETTINGS.md", "settings")
    assert table == printed, "run tools/settings_table.py --write"


def test_result_page_has_every_field() -> None:
    header = (ROOT / "libemtr" / "include" / "emtr" / "emtr.h").read_text()
    struct = re.search(r"typedef struct emtr_result \{(.*?)\} emtr_result;", header, re.DOTALL)
    assert struct is not None
    code = re.sub(r"/\*.*?\*/", "", struct[1], flags=re.DOTALL)
    declared = re.findall(r"(\w+)(?:\[\d+\])?;", code)
    table = pages.marked(ROOT / "docs" / "RESULT.md", "fields")
    told = re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE)
    assert len(told) == len(set(told))
    assert set(told) == set(declared) - {"size", "alternative_count"}
