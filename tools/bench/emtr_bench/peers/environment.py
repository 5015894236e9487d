"""The virtual environment that holds the other libraries, apart from the project's own.

Only the standard library is used here: this runs before there is anything else.
"""

from __future__ import annotations

import hashlib
import shutil
import subprocess
import sys
from pathlib import Path

from ..locations import REPOSITORY

REQUIREMENTS = REPOSITORY / "tools" / "bench" / "peers-requirements.txt"
FOLDER = REPOSITORY / "build" / "venv-peers"
#: What pyemtr is built from; any change there means a new installation.
SOURCES = ("pyproject.toml", "setup.py", "CMakeLists.txt", "libemtr", "pyemtr")


class EnvironmentFailure(OSError):
    """The environment could not be made; the message says which command failed."""


def make_environment(folder: Path | None = None) -> Path:
    """Makes or updates the environment in a folder (default: FOLDER) and gives its interpreter.
    Quick when all is there. Raises EnvironmentFailure."""
    folder = (folder or FOLDER).absolute()
    python = folder / "bin" / "python"
    stamp = folder / "peers.stamp"
    libraries, sources = fingerprint([REQUIREMENTS]), fingerprint(source_files())
    have = stamp.read_text().split() if python.exists() and stamp.exists() else []
    if have == [libraries, sources]:
        return python
    if not have:
        print(f"making a virtual environment in {folder}", flush=True)
        _run([sys.executable, "-m", "venv", "--clear", str(folder)])
    stamp.unlink(missing_ok=True)  # half an installation is none
    pip = [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    if have[:1] != [libraries]:
        print(f"installing what {REQUIREMENTS.name} names, from PyPI", flush=True)
        _run([*pip, "--requirement", str(REQUIREMENTS)])
    for left in (REPOSITORY / "build").glob("lib.*"):
        shutil.rmtree(left)  # setuptools would put the old files there into the package again
    print("installing pyemtr from this repository", flush=True)
    _run([*pip, "--force-reinstall", "--no-deps", str(REPOSITORY)])
    stamp.write_text(f"{libraries} {sources}\n")
    return python


def source_files() -> list[Path]:
    files: list[Path] = []
    for name in SOURCES:
        place = REPOSITORY / name
        files += [place] if place.is_file() else sorted(f for f in place.rglob("*") if f.is_file())
    return [file for file in files if "__pycache__" not in file.parts]


def fingerprint(files: list[Path]) -> str:
    digest = hashlib.sha256()
    for file in files:
        digest.update(f"{file.relative_to(REPOSITORY)}\0".encode())
        digest.update(hashlib.sha256(file.read_bytes()).digest())
    return digest.hexdigest()


def _run(command: list[str]) -> None:
    done = subprocess.run(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False
    )
    if done.returncode != 0:
        raise EnvironmentFailure(
            f"{' '.join(command)} failed with status {done.returncode}:\n{done.stdout.strip()}"
        )
