"""Counts the instructions of a program by callgrind, in all and by function."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from .programs import Program, RegressFailure

#: Functions that do less than this share of the work are not told apart.
SMALLEST_SHARE = 0.005
_LINE = re.compile(r"^\s*([\d,]+)\s+\([^)]*\)\s+[^:]*:(.*?)(?:\s+\[([^\]]*)\])?$")


@dataclass(frozen=True)
class Count:
    instructions: int  # from main's first to its last: the loading of libraries left out
    functions: dict[str, int]  # inclusive, of the project's own code


def count(program: Program, build: Path, sample: Path) -> Count:
    """Runs the program once. Raises RegressFailure when it or valgrind fails."""
    for tool in ("valgrind", "callgrind_annotate"):
        if shutil.which(tool) is None:
            raise RegressFailure(f"there is no {tool}; on Debian: apt-get install valgrind")
    with tempfile.NamedTemporaryFile(prefix="regress-") as profile:
        _run(
            ["valgrind", "--tool=callgrind", "--toggle-collect=main",
             "--toggle-collect=cli::pcl_module*",  # in main: not counted, since it loads libraries
             f"--callgrind-out-file={profile.name}", *program.command(build, sample)],
            program,
        )  # fmt: skip
        total = re.search(
            r"^(?:summary|totals): (\d+)", Path(profile.name).read_text(), re.MULTILINE
        )
        listing = _run(
            ["callgrind_annotate", "--inclusive=yes", "--threshold=100", profile.name], program
        )
    if total is None or int(total[1]) == 0:
        raise RegressFailure(f"{program.name}: callgrind counted nothing; has main no symbol?")
    return Count(int(total[1]), own_functions(listing, SMALLEST_SHARE * int(total[1])))


def own_functions(listing: str, least: float) -> dict[str, int]:
    """The functions of namespace emtr with at least so many instructions, by callgrind_annotate's
    inclusive listing. A function that is listed twice, once a depth of recursion, counts most."""
    found: dict[str, int] = {}
    for line in listing.splitlines():
        match = _LINE.match(line)
        if match is None or not match[2].startswith(("emtr::", "emtr_")):
            continue
        name, instructions = short_name(match[2]), int(match[1].replace(",", ""))
        if instructions >= least:
            found[name] = max(instructions, found.get(name, 0))
    return found


def short_name(function: str) -> str:
    """Without the arguments and what the compiler adds, so that a new argument is no new function:
    ``emtr::Team::with(int) [clone ._omp_fn.0]`` is ``emtr::Team::with``."""
    name = function.replace("(anonymous namespace)::", "")
    name = re.sub(r"'\d+$", "", name)
    depth, kept = 0, ""
    for character in name:
        if character in "(<":
            depth += 1
        elif character in ")>":
            depth -= 1
        elif character == " " and depth == 0:
            break
        elif depth == 0:
            kept += character
    return kept


def _run(command: list[str], program: Program) -> str:
    environment = program.environment()
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    # 3: the command doubts its result. It has done the whole work all the same.
    if done.returncode not in (0, 3):
        raise RegressFailure(
            f"{program.name}: {' '.join(command)} failed with status {done.returncode}:\n"
            f"{done.stderr.strip()}"
        )
    return done.stdout
