"""The project's pages, what they are made of, and how to run what they show."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("EMTR_BUILD_DIR", ROOT / "build"))
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")])


def name(page: Path) -> str:
    return page.relative_to(ROOT).as_posix()


def snippets(page: Path) -> list[tuple[str, str]]:
    """Language and text of each fenced block."""
    return re.findall(r"^```([\w+]*)\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL)


def prose(page: Path) -> str:
    """The page without its fenced blocks; their lines stay, empty."""
    return re.sub(
        r"^```.*?^```$|\A---\n.*?^---$",
        lambda block: "\n" * block[0].count("\n"),
        page.read_text(),
        flags=re.MULTILINE | re.DOTALL,
    )


def anchors(page: Path) -> set[str]:
    """What a link to one of the page's headings has behind its #."""
    heads = re.findall(r"^#+ (.+)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


def paths(page: Path) -> list[str]:
    """What stands in backticks and is a path, or a command line that begins with one."""
    quoted = [text.split()[0] for text in re.findall(r"`([^`\n]+)`", prose(page)) if text.strip()]
    return [text for text in quoted if "/" in text and re.fullmatch(r"\w[\w.\-/]*", text)]


def marked(page: Path, mark: str) -> str:
    """What stands between <!-- mark: begin --> and <!-- mark: end -->."""
    return page.read_text().split(f"<!-- {mark}: begin -->\n")[1].split(f"<!-- {mark}: end -->")[0]


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


def run_cpp(program: str, cmake: str, prefix: Path, folder: Path, sample: Path) -> np.ndarray:
    """Builds a program, runs it beside the sample pair, and returns the matrix that it prints."""
    (folder / "main.cpp").write_text(program)
    (folder / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.18)\nproject(page C CXX)\n"
        "find_package(PCL REQUIRED QUIET COMPONENTS io features filters registration)\n"
        "add_executable(my_program main.cpp)\n" + cmake
    )
    options = [f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release"]
    run(["cmake", "-S", ".", "-B", "build", *options], folder)
    run(["cmake", "--build", "build"], folder)
    printed = run([str(folder / "build" / "my_program")], sample).stdout
    return np.array(printed.split(), dtype=float).reshape(4, 4)


def write_arrays(folder: Path) -> None:
    """Writes the clouds of a sample pair as source.npy and target.npy, and beside them pairs.csv,
    a list of this pair, and matches.npy: rows of 500 matches, of which 400 are wrong."""
    (folder / "pairs.csv").write_text("source,target\nsource.npy,target.npy\n")
    true = np.loadtxt(folder / "T_true.txt")
    clouds = []
    for name in ("source", "target"):
        data = (folder / f"{name}.pcd").read_bytes().split(b"DATA binary\n", 1)[1]
        clouds.append(np.frombuffer(data, "<f4").reshape(-1, 3))
        np.save(folder / f"{name}.npy", clouds[-1])
    source, target = clouds
    distances, nearest = cKDTree(target).query(source @ true[:3, :3].T + true[:3, 3])
    rng = np.random.default_rng(1)
    rows = rng.choice(np.flatnonzero(distances < 0.5), 500, replace=False)
    matches = np.column_stack([rows, nearest[rows]])
    matches[100:, 1] = rng.integers(len(target), size=400)
    np.save(folder / "matches.npy", matches)
