"""The site of tools/docs is whole: its settings can be read, and each page is in its contents."""

from __future__ import annotations

import re
import runpy
import subprocess
import sys
from pathlib import Path

import pages
import pytest
from pages import ROOT

DOCS = ROOT / "docs"
CONF = runpy.run_path(str(DOCS / "conf.py"))
INDEX = (DOCS / "index.md").read_text()
HEADER = ROOT / "libemtr" / "include" / "emtr" / "emtr.h"


def contents() -> list[str]:
    """The entries of the start page's toctrees, without the titles given to them."""
    lines = [
        line
        for block in re.findall(r"^:::\{toctree\}\n(.*?)^:::$", INDEX, re.MULTILINE | re.DOTALL)
        for line in block.splitlines()
        if line and not line.startswith(":")
    ]
    return [re.sub(r".*<(.*)>", r"\1", line) for line in lines]


def files(entry: str) -> list[Path]:
    found = [(DOCS / f"{entry}{suffix}").resolve() for suffix in (".md", ".rst")]
    return [path for path in found if path.is_file()]


def filtered() -> str:
    script = [sys.executable, str(DOCS / "doxygen_comments.py"), str(HEADER)]
    return subprocess.run(script, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("entry", contents())
def test_each_entry_is_one_page(entry: str) -> None:
    assert len(files(entry)) == 1


def test_each_page_is_in_the_contents() -> None:
    listed = {path for entry in contents() for path in files(entry)}
    there = {path for pattern in CONF["include_patterns"] for path in ROOT.glob(pattern)}
    assert there - listed == {DOCS / "index.md"}
    assert len(contents()) == len(set(contents()))


def test_the_settings_name_what_is_there() -> None:
    assert (ROOT / f"{CONF['root_doc']}.md").is_file()
    for folder in (*CONF["html_static_path"], *CONF["html_extra_path"]):
        assert (DOCS / folder).is_dir(), folder
    for style in CONF["html_css_files"]:
        assert (DOCS / CONF["html_static_path"][0] / style).is_file(), style
    assert re.fullmatch(r"\d+\.\d+\.\d+", CONF["version"])


def test_each_requirement_has_a_version_and_each_extension_a_requirement() -> None:
    lines = (DOCS / "requirements.txt").read_text().splitlines()
    required = [line for line in lines if line and not line.startswith("#")]
    assert all(re.fullmatch(r"[\w-]+==[\d.]+", line) for line in required)
    names = {line.split("==")[0].lower().replace("-", "_") for line in required}
    modules = {name.replace("sphinxcontrib.", "sphinxcontrib_") for name in CONF["extensions"]}
    assert {name for name in modules if not name.startswith("sphinx.ext.")} <= names
    assert CONF["html_theme"] in names


@pytest.mark.parametrize("page", sorted(DOCS.rglob("*.[mr][ds]*")), ids=pages.name)
def test_included_files_are_there(page: Path) -> None:
    for name in re.findall(r"(?:\.\. |\{)literalinclude(?:::|\}) (\S+)", page.read_text()):
        assert (page.parent / name).is_file(), name


def test_the_reference_of_c_has_all_of_the_header() -> None:
    groups = re.findall(r"@defgroup (\w+)", filtered())
    shown = re.findall(r"doxygengroup:: (\w+)", (DOCS / "reference" / "c.rst").read_text())
    assert shown == groups
    assert len(groups) == HEADER.read_text().count("/* ---- ")


def test_doxygen_gets_the_same_lines() -> None:
    given, got = HEADER.read_text().splitlines(), filtered().splitlines()
    assert len(given) == len(got)
    (struct,) = (number for number, line in enumerate(given) if "struct emtr_cloud {" in line)
    assert got[struct] == "struct emtr_cloud {"
    assert any("/**< bytes, 0: packed */" in line for line in got)


def test_the_reference_of_python_has_each_public_name() -> None:
    import pyemtr

    page = (DOCS / "reference" / "python.rst").read_text()
    shown = set(re.findall(r"auto(?:function|class):: pyemtr\.(\w+)", page))
    assert set(pyemtr.__all__) - {"__version__"} <= shown
