"""The fixed programs whose instructions are counted."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from ..locations import REPOSITORY

#: Small, as a counted program runs some fifty times slower.
SAMPLE_POINTS = 3000


class RegressFailure(Exception):
    """Nothing could be counted; the message says what was missing or failed."""


@dataclass(frozen=True)
class Program:
    """A registration of the generated pair by the command, on one thread, with a fixed seed."""

    name: str
    kernel: str  # EMTR_KERNEL; no AVX-512, which valgrind does not know
    needs: str = ""  # flag of the processor

    def command(self, build: Path, sample: Path) -> list[str]:
        clouds = [str(sample / f"{name}.pcd") for name in ("source", "target")]
        return [str(command_of(build)), *clouds, "--seed", "1", "--threads", "1", "--quiet",
                "-o", str(sample / "T.txt")]  # fmt: skip

    def environment(self) -> dict[str, str]:
        return {**os.environ, "EMTR_KERNEL": self.kernel, "OMP_NUM_THREADS": "1", "LC_ALL": "C"}

    def runs_here(self) -> bool:
        return not self.needs or self.needs in processor_flags()


PROGRAMS = (Program("register-generic", "generic"), Program("register-avx2", "avx2", "avx2"))


def command_of(build: Path) -> Path:
    """The command pcl_emtr of a build folder."""
    command = build / "tools" / "pcl_emtr"
    if not command.exists():
        raise RegressFailure(
            f"{build}: no {command}: tools/quickstart builds it in build, and "
            "cmake -DEMTR_BUILD_TOOLS=ON in another folder"
        )
    return command


def make_sample(folder: Path) -> None:
    """source.pcd and target.pcd, the same bytes every time."""
    script = REPOSITORY / "tools" / "sample_pair.py"
    command = [sys.executable, str(script), "--out", str(folder), "--points", str(SAMPLE_POINTS)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RegressFailure(f"{' '.join(command)} failed:\n{done.stderr.strip()}")


def processor_flags() -> set[str]:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        name, _, value = line.partition(":")
        if name.strip() == "flags":
            return set(value.split())
    return set()
