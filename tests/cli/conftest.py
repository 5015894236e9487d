"""The real binary, and a pair of clouds with a known transformation for it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import cloud_files
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
QUICK = ["--iterations", "2", "--population", "4", "--threads", "1"]  # where T does not matter
ENDLESS = ["--iterations", "1000000", "--stall-iterations", "0"]  # for days

# A shell ignores it in what it runs in the background, and the command would go on ignoring it.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def command() -> Path:
    """The variable EMTR_CLI, or where the build directory `build` has it."""
    path = Path(os.environ.get("EMTR_CLI", ROOT / "build" / "tools" / "pcl_emtr"))
    if not path.is_file():
        pytest.skip(f"no pcl_emtr at {path} (build it, or set EMTR_CLI)")
    return path


@pytest.fixture
def run(command, tmp_path):
    """Runs pcl_emtr in a folder of its own; every output is captured."""

    def call(*arguments, **options) -> subprocess.CompletedProcess[str]:
        options.setdefault("stdout", subprocess.PIPE)
        return subprocess.run(
            [str(command), *map(str, arguments)],
            cwd=tmp_path,
            text=True,
            stderr=subprocess.PIPE,
            timeout=300,
            check=False,
            **options,
        )

    return call


@pytest.fixture
def refused(run, tmp_path):
    """Runs pcl_emtr, which must fail with this code, in one line, and leave no file behind."""

    def call(code: int, *arguments, **options) -> str:
        before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
        done = run(*arguments, **options)
        after = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
        assert done.returncode == code, done.stderr
        assert not done.stdout
        lines = [line for line in done.stderr.splitlines() if not line.startswith("> Loading")]
        assert len(lines) == 1, done.stderr
        assert lines[0].startswith("pcl_emtr: error: ")
        assert after == before
        return lines[0]

    return call


def surface(count: int, seed: int) -> np.ndarray:
    """Points on a bumpy shape without symmetry, about 2 units across."""
    rng = np.random.default_rng(seed)
    u = rng.uniform(-1, 1, (count, 2))
    x, y = u.T
    z = (
        0.35 * np.sin(3 * x + 1) * np.cos(2.5 * y)
        + 0.25 * np.exp(-8 * ((x - 0.4) ** 2 + y**2))
        - 0.3 * np.exp(-12 * ((x + 0.5) ** 2 + (y - 0.3) ** 2))
        + 0.2 * x * x * y
    )
    return np.column_stack([x, y, z])


def rotation(axis, angle: float) -> np.ndarray:
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


class Pair:
    """Two samplings of one surface: target = R surface + t, and each covers most of it."""

    def __init__(self) -> None:
        self.T = np.eye(4)
        self.T[:3, :3] = rotation([1, 2, -1], 2.0)
        self.T[:3, 3] = [3.0, -2.0, 5.0]
        source = surface(4000, 1)
        target = surface(4000, 2)
        self.source = source[source[:, 0] < 0.8]
        self.target = target[target[:, 0] > -0.8] @ self.T[:3, :3].T + self.T[:3, 3]

    def error(self, found: np.ndarray) -> tuple[float, float]:
        """Degrees, and how far the center of the source ends from where it should."""
        chord = np.linalg.norm(found[:3, :3] - self.T[:3, :3]) / (2 * np.sqrt(2))
        center = np.append(self.source.mean(axis=0), 1)
        return (
            float(np.degrees(2 * np.arcsin(min(1.0, chord)))),
            float(np.linalg.norm((found @ center - self.T @ center)[:3])),
        )


@pytest.fixture(scope="session")
def pair() -> Pair:
    return Pair()


@pytest.fixture
def clouds(tmp_path, pair) -> tuple[str, str]:
    """The pair as a.pcd and b.pcd in the folder where the command runs."""
    cloud_files.write_pcd(tmp_path / "a.pcd", pair.source)
    cloud_files.write_pcd(tmp_path / "b.pcd", pair.target)
    return "a.pcd", "b.pcd"


@pytest.fixture
def small(tmp_path) -> tuple[str, str]:
    """Few points, for tests in which only reading, writing and messages matter."""
    cloud_files.write_pcd(tmp_path / "a.pcd", surface(240, 3))
    cloud_files.write_pcd(tmp_path / "b.pcd", surface(240, 4))
    return "a.pcd", "b.pcd"


@pytest.fixture
def python_with_pyemtr(tmp_path) -> dict[str, str]:
    """An environment whose python3 has the package that the tests have."""
    pyemtr = pytest.importorskip("pyemtr", reason="pyemtr is not installed")
    place = Path(pyemtr.__file__).parent.parent
    (tmp_path / "bin").mkdir()
    program = tmp_path / "bin" / "python3"
    program.write_text(f'#!/bin/sh\nPYTHONPATH="{place}" exec "{sys.executable}" "$@"\n')
    program.chmod(0o755)
    return {**os.environ, "PATH": f"{tmp_path / 'bin'}:/usr/bin:/bin"}
