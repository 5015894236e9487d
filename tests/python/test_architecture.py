"""The sources keep to docs/ARCHITECTURE.md, and each of its rules finds what breaks it."""

from __future__ import annotations

from pathlib import Path

import architecture
import pytest

ROOT = Path(__file__).resolve().parents[2]
SRC = ROOT / "libemtr" / "src"
PAGE = (ROOT / "docs" / "ARCHITECTURE.md").read_text()
FLOORS = architecture.floors(PAGE)
PCL = architecture.block(PAGE, "pcl")


def test_every_room_is_listed_and_every_listed_room_exists() -> None:
    assert architecture.wrong_rooms(SRC, FLOORS) == []


def test_includes_are_spelled_from_the_root() -> None:
    assert architecture.misspelled_includes(SRC) == []


def test_no_room_includes_one_on_a_higher_floor() -> None:
    assert architecture.upward_includes(SRC, FLOORS) == []


def test_no_two_rooms_include_each_other() -> None:
    assert architecture.cycles(SRC) == []


def test_pcl_is_included_only_where_the_page_says() -> None:
    assert architecture.misplaced_pcl(SRC, PCL) == []
    assert architecture.unused_permissions(SRC, PCL) == []


def test_kernels_know_only_arrays() -> None:
    assert architecture.foreign_to_kernels(SRC) == []


def test_files_are_small() -> None:
    assert len(architecture.sources(SRC)) > 100
    assert architecture.too_large(SRC) == []


@pytest.mark.parametrize("folder", ["libemtr", "tests/cpp", "tools"])
def test_source_lists_are_sorted(folder: str) -> None:
    assert architecture.unsorted_lists(ROOT / folder / "CMakeLists.txt") == []


def test_tests_spell_includes_from_a_root() -> None:
    relative = [
        f"tests/{include}"
        for include in architecture.includes(ROOT / "tests")
        if ".." in include.name
    ]
    assert relative == []


# The rules themselves, over a tree made up for them: two rooms side by side over a third.
PLAN = [["top"], ["left", "right"], ["kernels"]]


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """A tree in which no rule finds anything."""
    write(tmp_path, "top/all.cpp", '#include "left/a.h"\n#include <vector>\n')
    write(tmp_path, "left/a.h", '#include "right/b.h"\n#include <pcl/types.h>\n')
    write(tmp_path, "right/b.h", '#include "kernels/sum.h"\n')
    write(tmp_path, "kernels/sum.h", "#include <cstddef>\n")
    return tmp_path


def write(root: Path, name: str, text: str) -> None:
    (root / name).parent.mkdir(exist_ok=True)
    (root / name).write_text(text)


def findings(root: Path) -> list[str]:
    return [
        *architecture.wrong_rooms(root, PLAN),
        *architecture.misspelled_includes(root),
        *architecture.upward_includes(root, PLAN),
        *architecture.cycles(root),
        *architecture.misplaced_pcl(root, ["left", "top/pcl.h"]),
        *architecture.foreign_to_kernels(root),
        *architecture.too_large(root),
    ]


def test_a_sound_tree_has_no_findings(tree: Path) -> None:
    assert findings(tree) == []


@pytest.mark.parametrize(
    ("name", "text", "finding"),
    [
        ("cellar/c.h", "", "cellar: not listed"),
        ("loose.cpp", "", "loose.cpp: stands in no room"),
        ("left/c.h", '#include "../right/b.h"\n',
         "left/c.h:1: ../right/b.h: expected a path from the root of the sources"),
        ("left/c.h", '\n#include "a.h"\n',
         "left/c.h:2: a.h: expected a path from the root of the sources"),
        ("left/c.h", "#include <right/b.h>\n",
         "left/c.h:1: right/b.h: expected quotes around an own file"),
        ("right/c.h", '#include "top/all.cpp"\n',
         "right/c.h:1: top/all.cpp: right stands below top"),
        ("right/c.h", '#include "left/a.h"\n', "left -> right -> left"),
        ("right/c.h", "#  include <pcl/point_types.h>\n",
         "right/c.h:1: pcl/point_types.h: right is not among the rooms that may include PCL"),
        ("top/c.h", "#include <flann/flann.hpp>\n",
         "top/c.h:1: flann/flann.hpp: top is not among the rooms that may include PCL"),
        ("kernels/avx2.cpp", "#include <vector>\n",
         "kernels/avx2.cpp:1: vector: a kernel knows nothing but arrays"),
        ("left/c.cpp", "\n" * 351, "left/c.cpp: 351 lines, at most 350"),
    ],
)  # fmt: skip
def test_one_wrong_file_is_found(tree: Path, name: str, text: str, finding: str) -> None:
    write(tree, name, text)
    assert finding in findings(tree)


def test_a_file_that_may_include_pcl_is_no_finding(tree: Path) -> None:
    write(tree, "top/pcl.h", "#include <pcl/types.h>\n")
    assert findings(tree) == []


def test_a_room_that_is_gone_is_found(tree: Path) -> None:
    plan = [*PLAN, ["cellar", "top"]]
    assert architecture.wrong_rooms(tree, plan) == [
        "top: listed twice",
        "cellar: listed, but there is no such folder",
    ]
    assert architecture.unused_permissions(tree, ["left", "cellar"]) == [
        "cellar: may include PCL, but does not exist"
    ]


def test_a_cycle_through_three_floors_is_found_once(tree: Path) -> None:
    write(tree, "kernels/up.h", '#include "top/all.cpp"\n')
    assert architecture.cycles(tree) == ["kernels -> top -> left -> right -> kernels"]


def test_a_large_median_is_found(tree: Path) -> None:
    for name in "abcdef":
        write(tree, f"top/{name}.h", "\n" * 91)
    assert "the median file has 91 lines, at most 90" in architecture.too_large(tree)


def test_an_unsorted_list_is_found(tmp_path: Path) -> None:
    cmake = tmp_path / "CMakeLists.txt"
    cmake.write_text("add_library(x OBJECT\n  a.cpp # first\n  c.cpp\n  b.cpp)\n")
    assert architecture.unsorted_lists(cmake) == [f"{cmake}: b.cpp stands behind c.cpp"]
    cmake.write_text("add_library(x OBJECT\n  a/z.cpp\n  b.c)\n")
    assert architecture.unsorted_lists(cmake) == []
    cmake.write_text("project(x)\n")
    with pytest.raises(ValueError, match="expected a list of sources"):
        architecture.unsorted_lists(cmake)


def test_a_page_without_floors_is_refused() -> None:
    with pytest.raises(ValueError, match="the marks of 'floors'"):
        architecture.floors("# Architecture\n")
    page = "<!-- floors: begin -->\n```text\na, b\nc\n```\n<!-- floors: end -->\n"
    assert architecture.floors(page) == [["a", "b"], ["c"]]
