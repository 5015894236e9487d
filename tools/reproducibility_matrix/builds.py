"""Builds everything with one compiler at one level of optimization, in a folder of its own."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
COMPILERS = {"gcc": ("gcc", "g++"), "clang": ("clang", "clang++")}
LEVELS = ("-O0", "-O2", "-O3")
TARGETS = ("emtr_command", "entries", "_emtr")


@dataclass(frozen=True)
class Build:
    name: str
    folder: Path
    slow: bool = False

    @property
    def program(self) -> Path:
        return self.folder / "tests" / "entries" / "entries"

    @property
    def command(self) -> Path:
        return self.folder / "tools" / "pcl_emtr"

    @property
    def package(self) -> Path | None:
        """The folder with the Python package; None stands for the installed one."""
        folder = self.folder / "python"
        return folder if (folder / "pyemtr").is_dir() else None


class BuildFailure(Exception):
    """A build that failed; the message ends with the last lines of the compiler."""


def available(compiler: str) -> bool:
    return all(shutil.which(program) for program in COMPILERS[compiler])


def make(compiler: str, level: str) -> Build:
    """Configures and builds; quick when nothing changed. CMAKE_ARGS adds arguments for CMake."""
    build = Build(
        f"{compiler} {level}",
        REPOSITORY / "build" / "reproducibility" / f"{compiler}{level}",
        level == "-O0",
    )
    c, cxx = COMPILERS[compiler]
    flags = f"{level} -DNDEBUG"
    configure = ["cmake", "-S", str(REPOSITORY), "-B", str(build.folder), "-G", "Ninja"]
    configure += ["-DCMAKE_BUILD_TYPE=Release", f"-DPython3_EXECUTABLE={sys.executable}"]
    configure += [f"-DCMAKE_C_COMPILER={c}", f"-DCMAKE_CXX_COMPILER={cxx}"]
    configure += [f"-DCMAKE_{language}_FLAGS_RELEASE={flags}" for language in ("C", "CXX")]
    configure += ["-DEMTR_BUILD_TOOLS=ON", "-DEMTR_BUILD_TESTS=ON", "-DEMTR_BUILD_PYTHON=ON"]
    _run(configure + os.environ.get("CMAKE_ARGS", "").split())
    jobs = str(os.cpu_count() or 1)
    _run(["cmake", "--build", str(build.folder), "--parallel", jobs, "--target", *TARGETS])
    return build


def _run(words: list[str]) -> None:
    done = subprocess.run(
        words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False
    )
    if done.returncode != 0:
        said = "\n".join(done.stdout.splitlines()[-40:])
        raise BuildFailure(f"{' '.join(words)}: status {done.returncode}\n{said}")
