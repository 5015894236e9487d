"""Every snippet of the README runs as it stands there, and its table is the library's own."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text()
BUILD = Path(os.environ.get("EMTR_BUILD_DIR", ROOT / "build"))

SNIPPETS = re.findall(r"^```(\w+)\n(.*?)^```", README, re.MULTILINE | re.DOTALL)
RUNNABLE = {"bash", "python", "cpp", "cmake", "c"}


def snippets(language: str) -> list[str]:
    return [text for name, text in SNIPPETS if name == language]


def run(command: list[str], folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    done = subprocess.run(
        command,
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=600,
        env={**os.environ, **environment},
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done


@pytest.fixture(scope="session")
def built() -> Path:
    if not (BUILD / "CMakeCache.txt").exists():
        pytest.skip(f"no build in {BUILD}: run tools/check, or set EMTR_BUILD_DIR")
    return BUILD


@pytest.fixture(scope="session")
def prefix(built: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("prefix")
    run(["cmake", "--install", str(built), "--prefix", str(folder)], ROOT)
    return folder


@pytest.fixture(scope="session")
def sample(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("sample")
    run([sys.executable, str(ROOT / "tools" / "sample_pair.py"), "--out", str(folder)], ROOT)
    return folder


def test_every_language_is_accounted_for() -> None:
    assert {name for name, _ in SNIPPETS} == RUNNABLE | {"text"}


@pytest.mark.parametrize("snippet", snippets("python"))
def test_python(snippet: str, tmp_path: Path) -> None:
    run([sys.executable, "-c", snippet], tmp_path)


@pytest.mark.parametrize("snippet", snippets("bash"))
def test_shell(snippet: str, prefix: Path, sample: Path) -> None:
    path = f"{prefix / 'bin'}{os.pathsep}{os.environ['PATH']}"
    run(["bash", "-euo", "pipefail", "-c", snippet], sample, PATH=path)
    assert np.loadtxt(sample / "T.txt").shape == (4, 4)


def test_class_and_cmake(prefix: Path, sample: Path, tmp_path: Path) -> None:
    (program,), (link,) = snippets("cpp"), snippets("cmake")
    (tmp_path / "main.cpp").write_text(program)
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.18)\nproject(readme C CXX)\n"
        "find_package(PCL REQUIRED QUIET COMPONENTS io)\n"
        "add_executable(my_program main.cpp)\n"
        + link
        + "target_link_libraries(my_program pcl_io)\n"
    )
    run(
        [
            "cmake",
            "-S",
            ".",
            "-B",
            "build",
            f"-DCMAKE_PREFIX_PATH={prefix}",
            "-DCMAKE_BUILD_TYPE=Release",
        ],
        tmp_path,
    )
    run(["cmake", "--build", "build"], tmp_path)
    printed = run([str(tmp_path / "build" / "my_program")], sample).stdout
    found = np.array(printed.split(), dtype=float).reshape(4, 4)
    true = np.loadtxt(sample / "T_true.txt")
    np.testing.assert_allclose(found[:3, :3], true[:3, :3], atol=0.02)
    np.testing.assert_allclose(found[:3, 3], true[:3, 3], atol=1)  # mm, far from the origin


def test_c(prefix: Path, tmp_path: Path) -> None:
    (program,) = snippets("c")
    (tmp_path / "main.c").write_text(program)
    pkgconfig = next(prefix.rglob("emtr.pc")).parent
    flags = run(
        ["pkg-config", "--cflags", "--libs", "emtr"], tmp_path, PKG_CONFIG_PATH=str(pkgconfig)
    ).stdout.split()
    run(["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "main.c", "-o", "main", *flags], tmp_path)
    printed = run([str(tmp_path / "main")], tmp_path, LD_LIBRARY_PATH=str(pkgconfig.parent)).stdout
    assert "0.0000" in printed


def test_settings_table() -> None:
    printed = run([sys.executable, str(ROOT / "tools" / "settings_table.py")], ROOT).stdout
    table = README.split("<!-- settings: begin -->\n")[1].split("<!-- settings: end -->")[0]
    assert table == printed, "run tools/settings_table.py --write"
