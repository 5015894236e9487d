"""Finds a Python that has the modules a command needs. Imports the standard library alone."""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path

from .locations import REPOSITORY


def python_with(*modules: str) -> Path:
    """Returns this interpreter, or else the one of the environment that tools/check makes.

    Raises FileNotFoundError when neither has the modules.
    """
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    if not missing:
        return Path(sys.prefix, "bin", "python")
    made = REPOSITORY / "build" / "venv" / "bin" / "python"
    if not made.exists() or _is_running(made):
        raise FileNotFoundError(
            f"{sys.executable} has no {' and no '.join(missing)}: run tools/check, which makes "
            f"{made.parents[1]}, or pip install '{REPOSITORY}[test]'"
        )
    return made


def go_on_with(python: Path) -> None:
    """Runs this command again with another interpreter, unless it is that one already."""
    if not _is_running(python):
        os.execv(python, [str(python), *sys.argv])


def require(program: str, *modules: str) -> None:
    """Goes on with a Python that has the modules; says so and exits with 2 where there is none."""
    try:
        go_on_with(python_with(*modules))
    except OSError as failure:
        print(f"{program}: {failure}", file=sys.stderr)
        sys.exit(2)


def _is_running(python: Path) -> bool:
    return Path(sys.prefix).resolve() == python.parents[1].resolve()
