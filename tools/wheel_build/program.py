"""Builds, checks and tries the wheels."""

from __future__ import annotations

import importlib.util
import json
import sys
import zipfile
from collections.abc import Sequence
from pathlib import Path

from . import build, empty_system, interpreters, libraries, licenses
from .arguments import REPOSITORY, parse
from .run import Failure, run

LARGEST = 25_000_000  # bytes
SCRIPT = Path(__file__).with_name("registered_pair.py")


class Defect(Exception):
    """A wheel that does not do what it should."""


def main(words: Sequence[str] | None = None) -> int:
    arguments = parse(words)
    try:
        if arguments.smoke:
            smoke(built_module())
            return 0
        make(arguments.python, arguments.folder, arguments.empty_system, arguments.systems)
    except Defect as defect:
        print(f"tools/wheels: {defect}", file=sys.stderr)
        return 1
    except (Failure, OSError) as failure:
        print(f"tools/wheels: error: {failure}", file=sys.stderr)
        return 2
    return 0


def built_module() -> Path:
    """Returns the extension module of the pyemtr that is installed, or of the build."""
    package = importlib.util.find_spec("pyemtr")
    places = (
        [Path(place) for place in (package.submodule_search_locations or [])] if package else []
    )
    for place in [*places, REPOSITORY / "build" / "python" / "pyemtr"]:
        for module in sorted(place.glob("_emtr.*.so")):
            return module
    raise Failure("--smoke: no pyemtr is installed for this Python, and none built in build/python")


def smoke(module: Path) -> None:
    needed = libraries.needed(module)
    unexpected = libraries.unexpected(needed)
    if unexpected:
        raise Defect(f"{module}: would load {', '.join(unexpected)}, which no wheel is to bundle")
    print(f"{module}: loads {', '.join(needed)}: as it should")


def make(programs: Sequence[str], folder: Path, empty: bool, systems: Path) -> None:
    plans = interpreters.plans(interpreters.found(programs))
    tools = build.tools(folder)
    bits: dict[str, object] = {}
    wheels = []
    for plan in plans:
        raw = build.built(plan, folder)
        wheel = licenses.add(build.repaired(raw, tools), tools, folder / "out")
        wheels.append(wheel)
        check(wheel)
        print(f"{wheel}: {wheel.stat().st_size / 1e6:.1f} MB", flush=True)
        for user in plan.users:
            python = build.installed(wheel, user, folder)
            compare(bits, f"Python {user.name}", run(python, SCRIPT, folder=folder))
    if empty:
        fitting = [wheel for wheel in wheels if "abi3" in wheel.name or "cp311" in wheel.name]
        if not fitting:
            raise Failure("--empty-system: its Python is 3.11, and no wheel is for that")
        root = empty_system.made(systems)
        said = empty_system.registered(root, fitting[0], tools, SCRIPT)
        compare(bits, f"the empty system {root}", said)


def compare(bits: dict[str, object], name: str, said: str) -> None:
    """Prints one line; raises Defect if the bits are not those that others found."""
    found = json.loads(said)
    print(f"{name}: registered, kernel {found['kernel']}", flush=True)
    if bits.setdefault("bits", found["bits"]) != found["bits"]:
        raise Defect(f"{name}: other bits than the first Python's")


def check(wheel: Path) -> None:
    """Raises Defect if the wheel is too large, or bundles what it should not."""
    if wheel.stat().st_size > LARGEST:
        raise Defect(f"{wheel}: {wheel.stat().st_size} bytes, expected at most {LARGEST}")
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
    bundled = [Path(name).name for name in names if ".libs/" in name]
    unexpected = [name for name in bundled if libraries.stem(name) not in libraries.BUNDLED]
    if unexpected:
        raise Defect(f"{wheel}: bundles {', '.join(unexpected)}")
