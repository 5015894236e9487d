"""Runs one registration by each API, in processes of their own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .fields import Fields, of_lines, of_report

TOOLS = Path(__file__).resolve().parents[1]


@dataclass(frozen=True)
class Run:
    source: Path  # PCD files
    target: Path
    preset: str
    seed: int = 5
    threads: int = 1
    kernel: str = ""  # value of EMTR_KERNEL; "" for the best of this machine
    old_libm: bool = False  # use glibc's mathematics for a machine without FMA

    @property
    def environment(self) -> dict[str, str]:
        out = {name: value for name, value in os.environ.items() if name != "EMTR_KERNEL"}
        if self.old_libm:
            out["GLIBC_TUNABLES"] = "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2"
        return out | ({"EMTR_KERNEL": self.kernel} if self.kernel else {})


class RunFailure(Exception):
    """A program that failed; the message has its output."""


def by_programs(program: Path, run: Run) -> dict[str, Fields]:
    """Registers by the class, twice with one object, and by the C API, in the program `entries`."""
    words = [str(run.source), str(run.target), str(run.threads), str(run.seed), run.preset]
    results = of_lines(_output([str(program), *words], run.environment))
    return dict(zip(("class", "class again", "C"), results))


def by_shell(command: Path, run: Run) -> Fields:
    with tempfile.TemporaryDirectory() as folder:
        report, matrix = Path(folder, "report.json"), Path(folder, "T.txt")
        words = [str(run.source), str(run.target), "--threads", str(run.threads)]
        words += ["--seed", str(run.seed), "--preset", run.preset, "--quiet"]
        moved = Path(folder, "moved.pcd")
        words += ["--report", str(report), "-o", str(matrix)]
        words += ["--aligned", str(moved), "--residuals"]
        _output([str(command), *words], run.environment, (0, 3))
        data = moved.read_bytes().split(b"DATA binary\n", 1)[1]
        residuals = np.frombuffer(data, "<f4").reshape(-1, 4)[:, 3]  # after x, y, z
        return of_report(json.loads(report.read_text()), residuals)


def by_python(run: Run, package: Path | None = None) -> Fields:
    """Registers in a fresh process with the pyemtr in `package`, or the installed one."""
    environment = run.environment
    paths = [str(TOOLS)] + ([str(package)] if package else [])
    environment["PYTHONPATH"] = os.pathsep.join(paths)
    words = [str(run.source), str(run.target), str(run.threads), str(run.seed), run.preset]
    program = [sys.executable, "-m", "reproducibility_matrix.python_run", *words]
    fields: Fields = json.loads(_output(program, environment))
    return fields


def _output(words: list[str], environment: dict[str, str], good: tuple[int, ...] = (0,)) -> str:
    # The checkout's root has a pyemtr without the compiled module; run elsewhere.
    done = subprocess.run(
        words, capture_output=True, text=True, check=False, env=environment, cwd=TOOLS
    )
    if done.returncode not in good:
        raise RunFailure(f"{' '.join(words)}: status {done.returncode}\n{done.stderr.strip()}")
    return done.stdout
