"""The rules of docs/ARCHITECTURE.md as functions over a tree of sources.

Each function returns what it finds wrong, one line a finding: empty means that the rule holds.
"""

from __future__ import annotations

import re
import statistics
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

LARGEST_FILE = 350  # lines
LARGEST_MEDIAN = 90  # lines
SUFFIXES = {".cpp", ".h", ".inl"}
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
SOURCE_LIST = re.compile(r"\b(?:add_executable|add_library|target_sources)\s*\(([^)]*)\)")


@dataclass(frozen=True)
class Include:
    """One #include line of a file below the root of the sources."""

    file: Path  # relative to the root
    line: int
    quoted: bool
    name: str

    @property
    def room(self) -> str:
        return self.file.parts[0]

    @property
    def included_room(self) -> str:
        return Path(self.name).parts[0]

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.name}"


def block(page: str, name: str) -> list[str]:
    """The lines of the fenced block between <!-- name: begin --> and <!-- name: end -->."""
    found = re.search(
        rf"<!-- {name}: begin -->\n```text\n(.*?)```\n<!-- {name}: end -->", page, re.DOTALL
    )
    if found is None:
        raise ValueError(f"expected a fenced block of text between the marks of {name!r}")
    return found[1].splitlines()


def floors(page: str) -> list[list[str]]:
    """The rooms of each floor, top first."""
    return [[room.strip() for room in line.split(",")] for line in block(page, "floors")]


def sources(root: Path) -> list[Path]:
    return sorted(path for path in root.rglob("*") if path.suffix in SUFFIXES)


def includes(root: Path) -> Iterator[Include]:
    for path in sources(root):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if found := INCLUDE.match(line):
                yield Include(path.relative_to(root), number, found[1] == '"', found[2])


def wrong_rooms(root: Path, plan: list[list[str]]) -> list[str]:
    """Rooms that the plan lacks or the tree lacks, and files that stand in no room."""
    planned = [room for floor in plan for room in floor]
    found = {path.name for path in root.iterdir() if path.is_dir()}
    return (
        [f"{room}: listed twice" for room in sorted({r for r in planned if planned.count(r) > 1})]
        + [f"{room}: not listed" for room in sorted(found - set(planned))]
        + [f"{room}: listed, but there is no such folder" for room in planned if room not in found]
        + [f"{path.name}: stands in no room" for path in sources(root) if path.parent == root]
    )


def misspelled_includes(root: Path) -> list[str]:
    """Includes of own files that are not quoted and spelled from the root."""
    findings = []
    for include in includes(root):
        from_root = ".." not in include.name and (root / include.name).is_file()
        if include.quoted and not from_root:
            findings.append(f"{include}: expected a path from the root of the sources")
        elif not include.quoted and from_root:
            findings.append(f"{include}: expected quotes around an own file")
    return findings


def upward_includes(root: Path, plan: list[list[str]]) -> list[str]:
    """Includes of a room on a higher floor."""
    level = {room: number for number, floor in enumerate(plan) for room in floor}
    return [
        f"{include}: {include.room} stands below {include.included_room}"
        for include in includes(root)
        if include.quoted
        and include.room in level
        and level.get(include.included_room, len(plan)) < level[include.room]
    ]


def cycles(root: Path) -> list[str]:
    """Rooms that include each other, directly or through others; each cycle once."""
    uses: dict[str, set[str]] = defaultdict(set)
    for include in includes(root):
        if include.quoted and include.room != include.included_room:
            uses[include.room].add(include.included_room)
    findings: set[tuple[str, ...]] = set()

    def walk(way: list[str]) -> None:
        for room in sorted(uses.get(way[-1], ())):
            if room in way:
                loop = way[way.index(room) :]
                first = loop.index(min(loop))
                findings.add((*loop[first:], *loop[:first]))
            else:
                walk([*way, room])

    for room in sorted(uses):
        walk([room])
    return [" -> ".join((*loop, loop[0])) for loop in sorted(findings)]


def misplaced_pcl(root: Path, allowed: list[str]) -> list[str]:
    """Includes of PCL or FLANN outside the rooms and files that may have them."""
    return [
        f"{include}: {include.room} is not among the rooms that may include PCL"
        for include in includes(root)
        if not include.quoted
        and include.included_room in {"pcl", "flann"}
        and include.room not in allowed
        and include.file.as_posix() not in allowed
    ]


def unused_permissions(root: Path, allowed: list[str]) -> list[str]:
    """Rooms and files that may include PCL and are not there."""
    return [f"{name}: may include PCL, but does not exist" for name in allowed
            if not (root / name).exists()]  # fmt: skip


def foreign_to_kernels(root: Path) -> list[str]:
    """Includes of a kernel that is compiled for one instruction set beyond bare arrays.

    Everything that such a file includes is compiled with those instructions. Only the kernels' own
    files and headers of the C library and the compiler may be.
    """
    plain = {"cmath", "cstddef", "cstdint", "cstring", "immintrin.h"}
    return [
        f"{include}: a kernel knows nothing but arrays"
        for include in includes(root)
        if include.room == "kernels"
        and include.file.name not in {"kernels.cpp", "kernels.h"}  # the choice of one, at run time
        and not (include.quoted and include.included_room == "kernels")
        and include.name not in plain
    ]


def sizes(root: Path) -> dict[str, int]:
    return {
        path.relative_to(root).as_posix(): len(path.read_text().splitlines())
        for path in sources(root)
    }


def too_large(root: Path) -> list[str]:
    lines = sizes(root)
    findings = [
        f"{name}: {count} lines, at most {LARGEST_FILE}"
        for name, count in lines.items()
        if count > LARGEST_FILE
    ]
    median = statistics.median(lines.values())
    if median > LARGEST_MEDIAN:
        findings.append(f"the median file has {median:g} lines, at most {LARGEST_MEDIAN}")
    return findings


def unsorted_lists(cmake: Path) -> list[str]:
    """Source files of a CMakeLists.txt that stand behind one that sorts after them."""
    lists = [
        [word for word in words.split() if Path(word).suffix in {".c", ".cpp"}]
        for words in SOURCE_LIST.findall(re.sub(r"#.*", "", cmake.read_text()))
    ]
    if not any(lists):
        raise ValueError(f"{cmake}: expected a list of sources")
    return [
        f"{cmake}: {later} stands behind {earlier}"
        for files in lists
        for earlier, later in zip(files, files[1:])
        if earlier >= later
    ]
