"""The programs of the pages, built by exactly the build lines that stand beside them."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pages
import pytest

README = pages.ROOT / "README.md"


def snippet(page: Path, language: str) -> str:
    (text,) = (text for one, text in pages.snippets(page) if one == language)
    return text


def build_line(page: Path, compiler: str) -> str:
    """The line of a page that calls this compiler."""
    (line,) = (
        line
        for _, text in pages.snippets(page)
        for line in text.splitlines()
        if line.startswith(f"{compiler} ")
    )
    return line


@pytest.fixture(scope="module")
def clouds(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with source.pcd and target.pcd: the source is rotated by 2 about z and moved."""
    folder = tmp_path_factory.mktemp("clouds")
    u, v = np.random.default_rng(1).uniform(-1, 1, (2, 8000))
    relief = 0.3 * np.sin(3 * u + v) * np.cos(2 * v) + 0.2 * np.exp(-8 * ((u - 0.3) ** 2 + v**2))
    target = np.column_stack([u, v, relief])
    c, s = np.cos(2.0), np.sin(2.0)
    source = target[u > -0.6] @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) + [5, 6, 7]
    for name, points in (("source", source), ("target", target)):
        head = (
            "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
            f"WIDTH {len(points)}\nHEIGHT 1\nPOINTS {len(points)}\nDATA ascii\n"
        )
        rows = "\n".join(" ".join(f"{x:.7g}" for x in point) for point in points)
        (folder / f"{name}.pcd").write_text(f"{head}{rows}\n")
    return folder


def check_pose(printed: str) -> None:
    found = np.array(printed.split(), float).reshape(4, 4)
    c, s = np.cos(2.0), np.sin(2.0)
    rotation = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    np.testing.assert_allclose(found[:3, :3], rotation, atol=0.02)
    np.testing.assert_allclose(found[:3, 3], -rotation @ [5, 6, 7], atol=0.2)


def by_cmake(installed, folder: Path) -> Path:
    build = ["cmake", "-S", ".", "-B", "build", "-DCMAKE_BUILD_TYPE=Release"]
    installed.run(*build, folder=folder)
    installed.run("cmake", "--build", "build", folder=folder)
    return folder / "build" / "my_program"


def by_line(installed, line: str, folder: Path) -> Path:
    if installed.static:  # what an archive is linked with besides it does not tell by itself
        line = line.replace("--libs", "--libs --static")
    installed.run("sh", "-euc", line, folder=folder)
    return folder / "my_program"


@pytest.mark.parametrize("page", [README, pages.ROOT / "docs" / "ENTRY_POINTS.md"], ids=pages.name)
def test_class_by_cmake(installed, clouds, tmp_path, page) -> None:
    if not installed.has_class:
        pytest.skip("built without the PCL class (EMTR_BUILD_PCL=OFF)")
    (tmp_path / "main.cpp").write_text(snippet(README, "cpp"))
    (tmp_path / "CMakeLists.txt").write_text(snippet(page, "cmake"))
    check_pose(installed.run(by_cmake(installed, tmp_path), folder=clouds))


def test_class_by_pkg_config(installed, clouds, needs_pkg_config, tmp_path) -> None:
    if not installed.has_class:
        pytest.skip("built without the PCL class (EMTR_BUILD_PCL=OFF)")
    (tmp_path / "main.cpp").write_text(snippet(README, "cpp"))
    program = by_line(installed, build_line(README, "c++"), tmp_path)
    check_pose(installed.run(program, folder=clouds))


def test_c_by_pkg_config(installed, needs_pkg_config, tmp_path) -> None:
    (tmp_path / "main.c").write_text(snippet(README, "c"))
    strict = build_line(README, "cc").replace("cc ", "cc -std=c99 -Wall -Wextra -Werror ")
    printed = installed.run(by_line(installed, strict, tmp_path), folder=tmp_path)
    check_rotation = [line.split() for line in printed.splitlines()[:3]]
    found = np.array([row[:3] for row in check_rotation], float)
    np.testing.assert_allclose(found, [[0, 1, 0], [0, 0, 1], [1, 0, 0]], atol=0.02)


def test_own_point_type(installed, needs_pkg_config, tmp_path) -> None:
    """The program with a point type of its own, by CMake and by pkg-config."""
    if not installed.has_class:
        pytest.skip("built without the PCL class (EMTR_BUILD_PCL=OFF)")
    page = pages.ROOT / "docs" / "INSTALL.md"
    (tmp_path / "main.cpp").write_text(snippet(page, "cpp"))
    (tmp_path / "CMakeLists.txt").write_text(snippet(page, "cmake"))
    programs = [
        by_cmake(installed, tmp_path),
        by_line(installed, build_line(page, "c++"), tmp_path),
    ]
    said = [installed.run(program, folder=tmp_path) for program in programs]
    assert said[0] == said[1] and re.fullmatch(r"registered, ring 7\n", said[0])


def test_unknown_scale(installed, needs_pkg_config, tmp_path) -> None:
    """The programs of its page, with the build lines of the README."""
    page = pages.ROOT / "docs" / "UNKNOWN_SCALE.md"
    (tmp_path / "main.c").write_text(snippet(page, "c"))
    printed = installed.run(by_line(installed, build_line(README, "cc"), tmp_path), folder=tmp_path)
    assert printed == "registered, scale 2.54\n"
    if not installed.has_class:
        return
    (tmp_path / "main.cpp").write_text(snippet(page, "cpp"))
    printed = installed.run(
        by_line(installed, build_line(README, "c++"), tmp_path), folder=tmp_path
    )
    assert printed == "registered, scale 0.001\n"


def test_no_program_of_the_pages_is_forgotten() -> None:
    found = {
        (pages.name(page), language)
        for page in pages.PAGES
        for language, _ in pages.snippets(page)
        if language in {"c", "cpp", "cmake"}
    }
    assert found == {
        ("README.md", "c"),
        ("README.md", "cpp"),
        ("README.md", "cmake"),
        ("docs/ENTRY_POINTS.md", "cmake"),
        ("docs/INSTALL.md", "cpp"),
        ("docs/INSTALL.md", "cmake"),
        ("docs/UNKNOWN_SCALE.md", "c"),
        ("docs/UNKNOWN_SCALE.md", "cpp"),
        ("docs/PORTING.md", "cpp"),  # built by tests/python/test_porting.py
    }
