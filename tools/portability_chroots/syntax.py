"""A check of the syntax by the compilers of this machine, with the build's own commands."""

from __future__ import annotations

import json
import shlex
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .arguments import COMPILERS, REPOSITORY

CHECKED = ("headers/", "libemtr/src/", "tools/pcl_emtr/")


def only_checked(command: str) -> list[str]:
    """The words of a compiler's command, changed so that it writes nothing."""
    words = shlex.split(command)
    output = words.index("-o")
    del words[output : output + 2]
    return [word for word in words if word != "-c"] + ["-fsyntax-only"]


def check(compiler: str, folder: Path, jobs: int) -> list[str] | None:
    """What the compiler says of each file that it refuses; None if it is not installed."""
    c, cxx = COMPILERS[compiler]
    if not (shutil.which(c) and shutil.which(cxx)):
        return None
    build = folder / f"syntax-{compiler}"
    configure = ["cmake", "-S", str(REPOSITORY), "-B", str(build), "-DEMTR_BUILD_TESTS=ON"]
    configure += ["-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"]
    configure += [f"-DCMAKE_C_COMPILER={c}", f"-DCMAKE_CXX_COMPILER={cxx}"]
    configured = run(configure, REPOSITORY)
    if configured.returncode != 0:
        return [configured.stdout]
    entries = [
        entry
        for entry in json.loads((build / "compile_commands.json").read_text())
        if any(part in entry["file"] for part in CHECKED)
    ]
    with ThreadPoolExecutor(jobs) as workers:
        done = workers.map(
            lambda entry: run(only_checked(entry["command"]), Path(entry["directory"])), entries
        )
        refused = [
            f"{entry['file']}\n{one.stdout}" for entry, one in zip(entries, done) if one.returncode
        ]
    print(f"{compiler}: {len(entries)} files checked, {len(refused)} refused", flush=True)
    return refused


def run(words: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        words,
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
