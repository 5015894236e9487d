"""The installed package, as a program that uses it finds it.

Installs the build in EMTR_BUILD_DIR (default: build/ in the checkout) into a temporary prefix,
then moves the prefix: everything here also holds after a move. If EMTR_PREFIX names a prefix, it
tests what is installed there, and gives the compilers and the programs no hint where that is.
"""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest
from installed import Installed, installed_at, run

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def prefix(tmp_path_factory) -> Path:
    """Returns the prefix of the installed package, moved after the installation."""
    build = Path(os.environ.get("EMTR_BUILD_DIR", ROOT / "build"))
    if "EMTR_BUILD_DIR" not in os.environ and not (build / "cmake_install.cmake").is_file():
        pytest.skip(f"no build at {build} (set EMTR_BUILD_DIR)")
    folder = tmp_path_factory.mktemp("install")
    run("cmake", "--install", build, "--prefix", folder / "first")
    return (folder / "first").rename(folder / "moved")


@pytest.fixture(scope="session")
def installed(request: pytest.FixtureRequest) -> Installed:
    """The prefix EMTR_PREFIX as it is, or the moved one with the variables that lead to it."""
    if where := os.environ.get("EMTR_PREFIX"):
        return installed_at(Path(where), dict(os.environ))
    moved = installed_at(request.getfixturevalue("prefix"), {})
    variables = {
        "CMAKE_PREFIX_PATH": str(moved.prefix),
        "PKG_CONFIG_PATH": str(moved.libdir / "pkgconfig"),
        "LD_LIBRARY_PATH": str(moved.libdir),
        "OMP_NUM_THREADS": "2",
    }
    return Installed(moved.prefix, moved.libdir, {**os.environ, **variables})


@pytest.fixture(scope="session")
def needs_pkg_config() -> None:
    if shutil.which("pkg-config") is None:
        pytest.skip("no pkg-config")
