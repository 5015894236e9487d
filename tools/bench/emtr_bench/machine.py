"""Describes the machine that a benchmark ran on, for its report."""

from __future__ import annotations

import datetime
import os
import platform
from collections.abc import Iterable
from importlib import metadata
from pathlib import Path

from .locations import REPOSITORY
from .versions import first_line, pcl_version


def describe(packages: Iterable[str] = ()) -> dict[str, str]:
    """Name and value of what matters to a figure, with the versions of these Python packages."""
    known = {
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
        "cpu": cpu_model(),
        "cpus": str(len(os.sched_getaffinity(0))),
        "load average": f"{os.getloadavg()[0]:.2f} before the run",
        "system": _system(),
        "compiler": first_line("c++", "--version"),
        "pcl": pcl_version(),
        "python": platform.python_version(),
        "revision": first_line("git", "-C", str(REPOSITORY), "describe", "--always", "--dirty"),
    }
    for package in packages:
        known[package] = _version(package)
    return known


def _version(package: str) -> str:
    """The version of a package that is installed, or of pyemtr as it runs: from a build folder it
    has no metadata."""
    if package == "pyemtr":
        import pyemtr

        return pyemtr.__version__
    return metadata.version(package)


def cpu_model() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        name, _, value = line.partition(":")
        if name.strip() == "model name":
            return value.strip()
    return platform.processor() or platform.machine()


def _system() -> str:
    release = platform.freedesktop_os_release() if hasattr(
        platform, "freedesktop_os_release") else {}  # fmt: skip
    return f"{release.get('PRETTY_NAME', platform.system())}, kernel {platform.release()}"
