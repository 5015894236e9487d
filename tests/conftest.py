"""Fixtures that all Python tests share."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent

# `python -m pytest` in the checkout would put the sources, which hold no compiled module, before
# the installed package.
if not list((ROOT / "pyemtr").glob("_emtr*.so")):
    sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != ROOT]


@pytest.fixture(scope="session")
def data_dir() -> Path:
    """The folder of real pairs: the variable EMTR_DATA, or ../shared/data beside the checkout."""
    folder = Path(os.environ.get("EMTR_DATA", ROOT.parent / "shared" / "data"))
    if not folder.is_dir():
        pytest.skip(f"no real test data at {folder} (set EMTR_DATA)")
    return folder


@pytest.fixture(scope="session")
def pair():
    """A synthetic pair with its true transformation."""
    import shapes

    return shapes.make_pair(seed=1)


@pytest.fixture(scope="session")
def problem(pair):
    """The preprocessed pair; tests change nothing of it but its count of queries."""
    import pyemtr

    return pyemtr.Problem(pair.source, pair.target, threads=2)


@pytest.fixture(scope="session")
def paper_problem(pair):
    """The same with the settings of the published method."""
    import pyemtr

    return pyemtr.Problem(pair.source, pair.target, preset="paper", threads=2)
