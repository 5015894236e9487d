"""Finds a Python that has the modules a command needs. Imports the standard library alone."""

from __future__ import annotations

import importlib.util
import os
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from .locations import REPOSITORY

#: Names of modules that a package index has under another name.
_PACKAGES = {"sklearn": "scikit-learn"}


def require(program: str, *modules: str, environment: Callable[[], Path] | None = None) -> None:
    """Goes on with a Python that has the modules: this one, or that of build/venv, or the one that
    `environment` makes. Where there is none it says so, and what to do, and exits with 2."""
    try:
        _go_on_with(environment() if environment else python_with(*modules))
    except OSError as failure:
        print(f"{program}: {failure}", file=sys.stderr)
        sys.exit(2)


def python_with(*modules: str) -> Path:
    """Returns this interpreter, or else the one of build/venv.

    Raises FileNotFoundError, which names the next step, when neither has the modules.
    """
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    if not missing:
        return Path(sys.prefix, "bin", "python")
    made = REPOSITORY / "build" / "venv" / "bin" / "python"
    if not made.exists() or _is_running(made):
        raise FileNotFoundError(
            f"{sys.executable} has no {' and no '.join(missing)}. {_next_step(modules, missing)}"
        )
    return made


def _next_step(modules: Sequence[str], missing: Sequence[str]) -> str:
    """What to type: into the virtual environment that this runs in, or else a new build/venv."""
    venv = REPOSITORY / "build" / "venv"
    inside = sys.prefix != sys.base_prefix
    packages = [_PACKAGES.get(name, name) for name in (missing if inside else modules)]
    hint = ""
    if "pyemtr" in packages:  # with all that the benchmarks need
        packages = [f"'{REPOSITORY}[bench]'"]
        hint = "\nBuilding pyemtr takes Debian packages, which tools/quickstart installs."
    line = f"-m pip install {' '.join(packages)}"
    if inside:
        return f"Install it by\n  '{sys.executable}' {line}{hint}"
    return (
        f"Make an environment that has it by\n  python3 -m venv '{venv}' && "
        f"'{venv}/bin/python' {line}\nand run this again: it finds that one.{hint}"
    )


def _go_on_with(python: Path) -> None:
    """Runs this command again with another interpreter, unless it is that one already."""
    if not _is_running(python):
        os.execv(python, [str(python), *sys.argv])


def _is_running(python: Path) -> bool:
    return Path(sys.prefix).resolve() == python.parents[1].resolve()
