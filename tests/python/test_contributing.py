"""The files that the pages for developers name are there."""

from __future__ import annotations

from pathlib import Path

import pages
import pytest
from pages import ROOT

SRC = ROOT / "libemtr" / "src"
NAMED = [ROOT / "CONTRIBUTING.md", *(ROOT / "docs" / f"{page}.md" for page in
         ("ARCHITECTURE", "HOW_IT_WORKS", "METHOD", "RESULT", "TESTING"))]  # fmt: skip

# Made by a build or by a run, and not of the sources.
MADE = ("build/",)


def exists(path: str) -> bool:
    """Whether a path is there from the root, or below the engine's sources, there also unended."""
    if path.startswith(MADE) or (ROOT / path).exists() or (SRC / path).exists():
        return True
    return any((SRC / f"{path}{suffix}").is_file() for suffix in (".cpp", ".h", ".inl"))


@pytest.mark.parametrize("page", NAMED, ids=pages.name)
def test_paths_exist(page: Path) -> None:
    named = pages.paths(page)
    assert named
    assert [path for path in named if not exists(path)] == []


def test_a_path_that_is_not_there_is_found(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "See `kernels/`, `libemtr/gone.h`, `seeds/seeds`, `a / b` and\n```\n`x/y`\n```\n"
    )
    assert pages.paths(page) == ["kernels/", "libemtr/gone.h", "seeds/seeds"]
    assert [path for path in pages.paths(page) if not exists(path)] == ["libemtr/gone.h"]


def test_every_recipe_names_a_file() -> None:
    recipes = (ROOT / "CONTRIBUTING.md").read_text().split("## Recipes")[1].split("### ")[1:]
    assert len(recipes) >= 5
    for recipe in recipes:
        assert "`" in recipe and "/" in recipe, recipe.splitlines()[0]
