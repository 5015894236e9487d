"""The pages tell of every reason and of every status that the library has."""

from __future__ import annotations

import ctypes
import re

import pages
import pytest
from pages import ROOT

FAILURES = ROOT / "docs" / "TROUBLESHOOTING.md"
RESULT = ROOT / "docs" / "RESULT.md"
HEADER = (ROOT / "libemtr" / "include" / "emtr" / "emtr.h").read_text()


@pytest.fixture(scope="module")
def reasons(built) -> list[str]:
    """The names of all reasons, as the library tells them."""
    library = built / "libemtr" / "libemtr.so"
    if not library.is_file():
        pytest.skip(f"no shared library {library}")
    name = ctypes.CDLL(str(library)).emtr_reason_name
    name.restype = ctypes.c_char_p
    names: list[str] = []
    while (text := name(len(names)).decode()) != "unknown":
        names.append(text)
    return names


def test_the_library_names_each_reason_of_its_header(reasons) -> None:
    declared = re.findall(r"EMTR_REASON_(\w+) = ", HEADER)
    assert [name.upper() for name in reasons] == declared


def test_each_reason_has_a_section_with_an_action(reasons) -> None:
    text = FAILURES.read_text().split("## The reasons\n")[1].split("\n## ")[0]
    sections = dict(
        re.findall(r"^### `(\w+)`\n\n(.+?)(?=^### |\Z)", text, re.MULTILINE | re.DOTALL)
    )
    assert sorted(sections) == sorted(reasons)
    assert all(len(section.split()) > 15 for section in sections.values())


def test_each_reason_has_a_meaning(reasons) -> None:
    table = RESULT.read_text().split("| reason | what it means |\n")[1].split("\n\n")[0]
    assert sorted(re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE)) == sorted(reasons)


def test_each_error_has_an_action() -> None:
    declared = set(re.findall(r"EMTR_ERROR_\w+(?= = )", HEADER))
    told = re.findall(r"^\| `(EMTR_ERROR_\w+)` \|", FAILURES.read_text(), re.MULTILINE)
    assert sorted(told) == sorted(declared)


def test_the_page_names_fields_settings_and_presets_that_exist() -> None:
    import pyemtr

    code = {word for word in re.findall(r"`([a-z_]+)`", pages.prose(FAILURES)) if "_" in word}
    known = {*pyemtr.Result.__annotations__, *pyemtr.settings()}
    reasons = {name.lower() for name in re.findall(r"EMTR_REASON_(\w+) = ", HEADER)}
    assert code - known - reasons == {"translation_bounds"}
