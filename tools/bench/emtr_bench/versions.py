"""Asks the system's tools for their versions; the standard library alone."""

from __future__ import annotations

import shutil
import subprocess

UNKNOWN = "unknown"


def first_line(*command: str, pick: str = "") -> str:
    """The first line that a command prints (with `pick` in it), or "unknown"."""
    if shutil.which(command[0]) is None:
        return UNKNOWN
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    lines = [line for line in done.stdout.splitlines() if pick in line]
    return lines[0].strip() if done.returncode == 0 and lines else UNKNOWN


def pcl_version() -> str:
    """Returns the version of PCL, whose pkg-config files may carry it in their names."""
    listed = first_line("pkg-config", "--list-all", pick="pcl_common")
    return UNKNOWN if listed == UNKNOWN else first_line(
        "pkg-config", "--modversion", listed.split()[0])  # fmt: skip
