"""Every snippet of the pages runs as it is there, links lead somewhere, tables are true."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pages
import pytest
from pages import PAGES, ROOT

README = ROOT / "README.md"
BUILD = Path(os.environ.get("EMTR_BUILD_DIR", ROOT / "build"))

SNIPPETS = [
    (f"{pages.name(page)}-{number}", language, text)
    for page in PAGES
    for number, (language, text) in enumerate(pages.snippets(page), 1)
]
RUNNABLE = {"bash", "python", "cpp", "cmake", "c"}


def snippets(language: str) -> list[pytest.param]:
    """The snippets of all pages in one language, each with its page's name and its number there."""
    return [pytest.param(text, id=name) for name, one, text in SNIPPETS if one == language]


def run(command: list[str], folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    done = subprocess.run(
        command,
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=600,
        env={**os.environ, **environment},
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done


@pytest.fixture(scope="session")
def built() -> Path:
    if not (BUILD / "CMakeCache.txt").exists():
        pytest.skip(f"no build in {BUILD}: run tools/check, or set EMTR_BUILD_DIR")
    return BUILD


@pytest.fixture(scope="session")
def prefix(built: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("prefix")
    run(["cmake", "--install", str(built), "--prefix", str(folder)], ROOT)
    return folder


@pytest.fixture(scope="session")
def sample(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("sample")
    run([sys.executable, str(ROOT / "tools" / "sample_pair.py"), "--out", str(folder)], ROOT)
    return folder


def test_every_language_is_accounted_for() -> None:
    assert {language for _, language, _ in SNIPPETS} == RUNNABLE | {"text"}


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
def test_python(snippet: str, tmp_path: Path) -> None:
    run([sys.executable, "-c", snippet], tmp_path)


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
