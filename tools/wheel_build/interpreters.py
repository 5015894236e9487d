"""The Pythons that get wheels."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from .run import Failure, run

USUAL = ("python3.10", "python3.11", "python3.12", "python3.13")
STABLE = (3, 11)  # the first whose stable ABI has the buffer protocol


@dataclass(frozen=True)
class Interpreter:
    program: Path
    version: tuple[int, int]

    @property
    def name(self) -> str:
        return f"{self.version[0]}.{self.version[1]}"

    @property
    def tag(self) -> str:
        return f"cp{self.version[0]}{self.version[1]}"


@dataclass(frozen=True)
class Plan:
    """One wheel: who builds it, and who is served by it."""

    builder: Interpreter
    users: tuple[Interpreter, ...]
    stable: bool


def found(programs: Sequence[str]) -> list[Interpreter]:
    """Returns the interpreters, oldest first; raises Failure if one cannot run or none is there."""
    paths = list(programs) or [path for path in map(shutil.which, USUAL) if path]
    if not paths:
        raise Failure(f"none of {', '.join(USUAL)} is on PATH: name interpreters by --python")
    by_version: dict[tuple[int, int], Interpreter] = {}
    for path in paths:
        major, minor = run(path, "-c", "import sys; print(*sys.version_info[:2])").split()
        version = int(major), int(minor)
        by_version.setdefault(version, Interpreter(Path(path), version))
    return [by_version[version] for version in sorted(by_version)]


def plans(interpreters: Sequence[Interpreter]) -> list[Plan]:
    old = [each for each in interpreters if each.version < STABLE]
    new = tuple(each for each in interpreters if each.version >= STABLE)
    return [Plan(each, (each,), False) for each in old] + ([Plan(new[0], new, True)] if new else [])
