"""Runs a part, and keeps beside its JSON what it was run with."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .. import machine, records
from ..locations import REPOSITORY
from .parts import Part


@dataclass(frozen=True)
class Kept:
    """A part's figures, and how they came about."""

    value: dict[str, Any]
    command: str
    machine: dict[str, str]
    status: int
    seconds: float


def run(part: Part) -> str:
    """Runs the command in the repository; its output is seen. "" or what went wrong, in which
    case the part's old figures are gone: they are not those of this run."""
    _path(part.json).unlink(missing_ok=True)
    _beside(part.json).unlink(missing_ok=True)
    found = machine.describe(("pyemtr",))
    start = time.monotonic()
    # Commands that start with "env python3" are to meet this interpreter.
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ.get('PATH', '')}"
    done = subprocess.run(
        part.command, cwd=REPOSITORY, env={**os.environ, "PATH": path}, check=False
    )
    if not _path(part.json).exists():
        return f"{part.line}: ended with {done.returncode} and wrote no {part.json}"
    records.write(
        _beside(part.json),
        {"command": part.line, "machine": found, "status": done.returncode,
         "seconds": time.monotonic() - start},
    )  # fmt: skip
    return ""


def kept(part: Part) -> Kept | None:
    """Returns the record of a part's last run; None when there is no whole one."""
    beside = _beside(part.json)
    if not (_path(part.json).exists() and beside.exists()):
        return None
    how = json.loads(beside.read_text())
    value = json.loads(_path(part.json).read_text())
    return Kept(value, how["command"], how["machine"], how["status"], how["seconds"])


def _path(path: Path) -> Path:
    return REPOSITORY / path


def _beside(path: Path) -> Path:
    return _path(path.with_name(f"{path.stem}.run.json"))
