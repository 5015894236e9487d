"""The programs of examples/c and examples/cpp, built with the installed package, and run."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from installed import run

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def sample(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("sample")
    run(sys.executable, ROOT / "tools/sample_pair.py", "--out", folder)
    for name in ("source", "target"):
        data = (folder / f"{name}.pcd").read_bytes().split(b"DATA binary\n", 1)[1]
        np.savetxt(folder / f"{name}.xyz", np.frombuffer(data, "<f4").reshape(-1, 3))
    return folder


def build_by_cmake(installed, project: Path, build: Path, *options: str) -> None:
    installed.run("cmake", "-S", project, "-B", build, *options, folder=build)
    installed.run("cmake", "--build", build, folder=build)


@pytest.fixture(scope="module")
def cpp(installed, tmp_path_factory) -> Path:
    if not installed.has_class:
        pytest.skip("built without the PCL class (EMTR_BUILD_PCL=OFF)")
    build = tmp_path_factory.mktemp("cpp")
    build_by_cmake(installed, ROOT / "examples/cpp", build)
    return build


@pytest.fixture(scope="module")
def register_xyz(installed, tmp_path_factory) -> Path:
    if installed.static:
        pytest.skip("an archive of C++ code needs a C++ linker and PCL")
    build = tmp_path_factory.mktemp("c")
    strict = "-DCMAKE_C_FLAGS=-std=c99 -pedantic -Wall -Wextra -Werror"
    build_by_cmake(installed, ROOT / "examples/c", build, strict)
    return build / "register_xyz"


def matrices(printed: str) -> list[np.ndarray]:
    rows = [line.split() for line in printed.splitlines()]
    numbers = [row for row in rows if len(row) == 4 and all(is_number(word) for word in row)]
    return list(np.array(numbers, dtype=float).reshape(-1, 4, 4))


def is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def rotation_error(found: np.ndarray, folder: Path) -> float:
    true = np.loadtxt(folder / "T_true.txt")
    chord = np.linalg.norm(found[:3, :3] - true[:3, :3]) / (2 * np.sqrt(2))
    return float(np.degrees(2 * np.arcsin(min(chord, 1.0))))


def test_register_xyz(register_xyz, sample) -> None:
    (found,) = matrices(run(register_xyz, sample / "source.xyz", sample / "target.xyz"))
    assert rotation_error(found, sample) < 0.1


@pytest.mark.parametrize(
    ("content", "message"),
    [(None, "cannot be opened"), ("1 2 3\n4 five 6\n", "point 2"), ("1 2 3\n", "source cloud")],
)
def test_register_xyz_refuses(register_xyz, sample, tmp_path, content, message) -> None:
    bad = tmp_path / "bad.xyz"
    if content is not None:
        bad.write_text(content)
    command = [str(register_xyz), str(bad), str(sample / "target.xyz")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert message in done.stderr
    assert done.stdout == ""


def test_beside_icp(cpp, sample) -> None:
    """ICP has no start near the truth here, which is what the program shows."""
    printed = run(cpp / "beside_icp", sample / "source.pcd", sample / "target.pcd")
    found, by_icp = matrices(printed)
    assert rotation_error(found, sample) < 0.1
    assert rotation_error(by_icp, sample) > 5
    assert "registered, confidence" in printed


def test_relocalize(cpp) -> None:
    printed = run(cpp / "relocalize").splitlines()
    assert sum(line.startswith("registered, ") for line in printed) >= 3
    assert "another storey" in printed[4]
    assert not printed[5].startswith("registered")
