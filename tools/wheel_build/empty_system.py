"""A Debian with nothing but Python in it, where a wheel has to do without PCL."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

from .arguments import PLATFORM
from .run import Failure, run

SUITE = "bookworm"
MIRROR = "http://deb.debian.org/debian"
PYTHON = "3.11"  # of that Debian
PICTURE = "alignment.png"
PNG = b"\x89PNG"


def made(systems: Path) -> Path:
    """Makes the system unless it is there; raises Failure without root or debootstrap."""
    if os.geteuid() != 0:
        raise Failure("--empty-system: expected root, who alone may change the root folder")
    if shutil.which("debootstrap") is None:
        raise Failure("--empty-system: no debootstrap: apt-get install debootstrap")
    root = systems / SUITE
    if (root / "complete").exists():
        return root
    shutil.rmtree(root, ignore_errors=True)
    systems.mkdir(parents=True, exist_ok=True)
    run("debootstrap", "--variant=minbase", "--include=python3,python3-venv", SUITE, root, MIRROR)
    (root / "complete").touch()
    return root


def registered(root: Path, wheel: Path, programs: Path, script: Path) -> str:
    """Installs the wheel there, registers and plots a pair; returns what the script printed."""
    libraries = [
        str(file) for file in (root / "usr").rglob("libpcl*") if "pyemtr.libs" not in str(file)
    ]
    if libraries:
        raise Failure(f"{root}: expected a system without PCL, found {libraries[0]}")
    place = root / "root" / "wheels"
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir()
    _download(wheel, place, programs)
    shutil.copy(script, place)
    _inside(root, "python3", "-m", "venv", "--clear", "/root/venv")
    _inside(root, "/root/venv/bin/pip", "install", "--no-index", "--find-links", "/root/wheels",
            "pyemtr[plot]")  # fmt: skip
    said = _inside(root, "/root/venv/bin/python", f"/root/wheels/{script.name}", f"/root/{PICTURE}")
    if not (root / "root" / PICTURE).read_bytes().startswith(PNG):
        raise Failure(f"{root}/root/{PICTURE}: expected a PNG")
    return said


def _download(wheel: Path, place: Path, programs: Path) -> None:
    """Downloads what the wheel depends on, for the Python there: that system needs no network."""
    words = ["download", "--dest", place, "--only-binary=:all:", "--python-version", PYTHON]
    for tag in (PLATFORM, PLATFORM.replace("_36_", "_28_"), PLATFORM.replace("_36_", "_17_")):
        words += ["--platform", tag]
    words += ["--implementation", "cp", "--abi", f"cp{PYTHON.replace('.', '')}", "--abi", "abi3",
              "--abi", "none"]  # fmt: skip
    run(programs / "python", "-m", "pip", *words, f"{wheel}[plot]")


def _inside(root: Path, *words: str) -> str:
    environment = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LC_ALL": "C.UTF-8"}
    return run("chroot", root, *words, environment=environment)
