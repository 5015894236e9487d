"""Both halves of docs/PORTING.md find the true pose; other libraries where they are installed."""

from __future__ import annotations

import importlib.util
import re
import sys
from pathlib import Path

import numpy as np
import pages
import pytest

PAGE = pages.ROOT / "docs" / "PORTING.md"
SNIPPETS = pages.snippets(PAGE)
POSES = [(language, text) for language, text in SNIPPETS if "T = " in text]
DEGREES = {"python": 0.1, "py": 10}  # an answer of ours is refined

MAIN = """
int main() {
  Cloud::Ptr source(new Cloud), target(new Cloud);
  if (pcl::io::loadPCDFile("source.pcd", *source) < 0) return 2;
  if (pcl::io::loadPCDFile("target.pcd", *target) < 0) return 2;
  std::cout << align(source, target) << std::endl;
}
"""
INCLUDES = "#include <pcl/io/pcd_io.h>\n#include <pcl/point_types.h>\n#include <iostream>\n"


def rotation_degrees(found: np.ndarray, true: np.ndarray) -> float:
    chord = np.linalg.norm(found[:3, :3] - true[:3, :3]) / (2 * np.sqrt(2))
    return float(np.degrees(2 * np.arcsin(min(chord, 1.0))))


def modules(snippet: str) -> list[str]:
    return re.findall(r"^import (\w+)", snippet, re.MULTILINE)


def test_each_section_has_both_halves() -> None:
    assert [language for language, _ in POSES] == ["py", "python"] * 3
    assert [language for language, _ in SNIPPETS if language in ("c++", "cpp")] == ["c++", "cpp"]


def test_the_clouds_are_there(sample: Path) -> None:
    pages.run([sys.executable, "-c", SNIPPETS[0][1]], sample)


@pytest.mark.parametrize(("language", "snippet"), POSES)
def test_python(language: str, snippet: str, sample: Path, tmp_path: Path) -> None:
    compile(snippet, PAGE.name, "exec")  # also where it cannot run
    missing = [name for name in modules(snippet) if importlib.util.find_spec(name) is None]
    if language == "py" and missing:
        pytest.skip(f"{', '.join(missing)}: not installed")
    found = tmp_path / "T.txt"
    pages.run([sys.executable, "-c", f"{snippet}\nnp.savetxt({str(found)!r}, T)"], sample)
    true = np.loadtxt(sample / "T_true.txt")
    assert rotation_degrees(np.loadtxt(found), true) < DEGREES[language]


@pytest.mark.parametrize("language", ["c++", "cpp"])
def test_cpp(language: str, prefix: Path, sample: Path, tmp_path: Path) -> None:
    (types,) = (text for one, text in SNIPPETS if one == "text")
    (align,) = (text for one, text in SNIPPETS if one == language)
    includes = "".join(re.findall(r"^#include.*\n", align, re.MULTILINE))
    program = INCLUDES + includes + types + align.replace(includes, "") + MAIN
    ours = "find_package(emtr CONFIG REQUIRED COMPONENTS pcl)\n"
    link = "target_link_libraries(my_program emtr::pcl pcl_io pcl_features pcl_filters)\n"
    theirs = "target_link_libraries(my_program pcl_io pcl_features pcl_filters pcl_registration)\n"
    cmake = ours + link if language == "cpp" else theirs
    found = pages.run_cpp(program, cmake, prefix, tmp_path, sample)
    assert rotation_degrees(found, np.loadtxt(sample / "T_true.txt")) < (
        DEGREES["python"] if language == "cpp" else DEGREES["py"]
    )
