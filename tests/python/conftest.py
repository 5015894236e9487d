"""Fixtures of the tests that run the pages' snippets and the examples."""

from __future__ import annotations

import sys
from pathlib import Path

import pages
import pytest


@pytest.fixture(scope="session")
def built() -> Path:
    if not (pages.BUILD / "CMakeCache.txt").exists():
        pytest.skip(f"no build in {pages.BUILD}: run tools/check, or set EMTR_BUILD_DIR")
    return pages.BUILD


@pytest.fixture(scope="session")
def prefix(built: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("prefix")
    pages.run(["cmake", "--install", str(built), "--prefix", str(folder)], pages.ROOT)
    return folder


@pytest.fixture(scope="session")
def sample(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the sample pair, as files of PCD and of numpy, and with matches, many wrong."""
    folder = tmp_path_factory.mktemp("sample")
    script = pages.ROOT / "tools" / "sample_pair.py"
    pages.run([sys.executable, str(script), "--out", str(folder)], pages.ROOT)
    pages.write_arrays(folder)
    return folder
