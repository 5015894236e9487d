"""Versions of the tools and libraries that the counts depend on."""

from __future__ import annotations

import platform
import re
from pathlib import Path

from ..versions import first_line, pcl_version


def toolchain(build: Path) -> dict[str, str]:
    """Name and version of what has made or counted the instructions of a build."""
    return {
        "compiler": _compiler(build),
        "flags": _cached(build, "CMAKE_CXX_FLAGS_RELEASE"),
        "pcl": pcl_version(),
        "libc": " ".join(platform.libc_ver()),
        "valgrind": first_line("valgrind", "--version"),
        "machine": platform.machine(),
    }


def differences(recorded: dict[str, str], here: dict[str, str]) -> list[str]:
    names = dict.fromkeys([*recorded, *here])
    return [
        f"{name} {recorded.get(name, 'unknown')}, here {here.get(name, 'unknown')}"
        for name in names
        if recorded.get(name) != here.get(name)
    ]


def _compiler(build: Path) -> str:
    for file in build.glob("CMakeFiles/*/CMakeCXXCompiler.cmake"):
        found = dict(re.findall(r'^set\((CMAKE_CXX_COMPILER_(?:ID|VERSION)) "(.*)"\)$',
                                file.read_text(), re.MULTILINE))  # fmt: skip
        return " ".join(found.get(f"CMAKE_CXX_COMPILER_{key}", "?") for key in ("ID", "VERSION"))
    return "unknown"


def _cached(build: Path, name: str) -> str:
    cache = build / "CMakeCache.txt"
    found = (
        re.search(rf"^{name}:\w+=(.*)$", cache.read_text(), re.MULTILINE)
        if cache.exists()
        else None
    )
    return found[1] if found else "unknown"
