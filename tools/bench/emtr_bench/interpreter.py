"""Finds a Python that has what a benchmark needs; the standard library alone."""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path

from .locations import REPOSITORY


def python_with(*modules: str) -> Path:
    """This interpreter, or else that of the environment which the check makes. Raises
    FileNotFoundError when neither has the modules."""
    if all(importlib.util.find_spec(module) for module in modules):
        return Path(sys.prefix, "bin", "python")
    made = REPOSITORY / "build" / "venv" / "bin" / "python"
    if not made.exists() or _is_running(made):
        raise FileNotFoundError(
            f"{sys.executable} has no {' or no '.join(modules)}: run tools/check, which makes "
            f"{made.parents[1]}"
        )
    return made


def go_on_with(python: Path) -> None:
    """Starts this command again by another interpreter, unless it is that already."""
    if not _is_running(python):
        os.execv(python, [str(python), *sys.argv])


def require(program: str, *modules: str) -> None:
    """Goes on by a Python that has the modules; where there is none, says so and exits with 2."""
    try:
        go_on_with(python_with(*modules))
    except OSError as failure:
        print(f"{program}: {failure}", file=sys.stderr)
        sys.exit(2)


def _is_running(python: Path) -> bool:
    return Path(sys.prefix).resolve() == python.parents[1].resolve()
