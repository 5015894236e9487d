"""Runs programs, and says what they said when they fail."""

from __future__ import annotations

import subprocess
from collections.abc import Mapping
from pathlib import Path


class Failure(Exception):
    """Something could not be built; the message has the program's last lines."""


def run(
    *words: str | Path, environment: Mapping[str, str] | None = None, folder: Path | None = None
) -> str:
    """Returns what the program wrote to its output; raises Failure unless it ends with 0."""
    command = [str(word) for word in words]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, check=False, env=environment, cwd=folder
        )
    except OSError as error:
        raise Failure(f"{command[0]}: {error.strerror or error}") from error
    if done.returncode != 0:
        said = "\n".join((done.stdout + done.stderr).splitlines()[-40:])
        raise Failure(f"{' '.join(command)}: status {done.returncode}\n{said}")
    return done.stdout
