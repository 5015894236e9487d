"""User-provided data through four APIs: the same bits, for any kernel and number of threads."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from reproducibility_matrix.clouds import generated
from test_entries import BUILD

import pyemtr

PROGRAM, COMMAND = BUILD.program, BUILD.command
KERNELS = ["generic", pyemtr.kernel_name()]


def with_fields(points: np.ndarray, source: bool) -> np.ndarray:
    """Returns x y z, a normal (NaN for every 50th point) and 33 numbers (NaN for every 30th)."""
    # The source's axes are y, z, x of the target's, see generated().
    at = (points - [4, 5, 6])[:, [2, 0, 1]] if source else points
    waves = np.random.default_rng(2).normal(scale=3, size=(3, 33))
    codes = np.sin(at @ waves)
    codes[::30, 5] = np.nan
    normals = 3 * (points - points.mean(axis=0))
    normals[::50] = np.nan
    return np.column_stack([points, normals, codes]).astype("<f4")


def write_pcd(path: Path, rows: np.ndarray) -> Path:
    header = (
        "VERSION 0.7\nFIELDS x y z normal_x normal_y normal_z fpfh\n"
        "SIZE 4 4 4 4 4 4 4\nTYPE F F F F F F F\nCOUNT 1 1 1 1 1 1 33\n"
        f"WIDTH {len(rows)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(rows)}\nDATA binary\n"
    )
    path.write_bytes(header.encode() + rows.tobytes())
    return path


def outcome(words: list[str], kernel: str) -> str:
    done = subprocess.run(
        words,
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
        env={**os.environ, "EMTR_KERNEL": kernel},
    )
    assert done.returncode in (0, 3), done.stderr
    return done.stdout


@pytest.mark.parametrize("what", ["normals", "features", "correspondences"])
@pytest.mark.parametrize("preset", ["default", "thorough"])
def test_same_bits(what: str, preset: str, tmp_path: Path) -> None:
    for program in (PROGRAM, COMMAND):
        if not program.is_file():
            pytest.skip(f"no {program}: run tools/check, or set EMTR_BUILD_DIR")
    clouds = [with_fields(points, i == 0) for i, points in enumerate(generated())]
    clouds[0][17, 1] = np.nan
    files = [write_pcd(tmp_path / f"{i}.pcd", rows) for i, rows in enumerate(clouds)]
    source, target = (rows[:, :3] for rows in clouds)

    given: dict[str, Any] = {}
    program_word, options = what, ["--use-" + what]
    if what == "normals":
        given = {"source_normals": clouds[0][:, 3:6], "target_normals": clouds[1][:, 3:6]}
    elif what == "features":
        given = {"source_features": clouds[0][:, 6:], "target_features": clouds[1][:, 6:]}
    else:
        rng = np.random.default_rng(8)
        pairs = np.column_stack([rng.integers(0, len(rows), 1500) for rows in clouds])
        pairs = pairs[pairs[:, 0] != 17]  # not finite
        given = {"correspondences": pairs}
        program_word = str(tmp_path / "pairs.txt")
        np.savetxt(program_word, pairs, fmt="%d")
        options = ["--correspondences", program_word]

    first = pyemtr.register(source, target, seed=5, threads=1, preset=preset, **given)
    plain = pyemtr.register(source, target, seed=5, preset=preset)
    assert (first.transformation != plain.transformation).any() or what == "correspondences"
    for threads, kernel in zip((1, 3), KERNELS, strict=True):
        again = pyemtr.register(source, target, seed=5, threads=threads, preset=preset, **given)
        np.testing.assert_array_equal(again.transformation, first.transformation)
        words = [*map(str, files), str(threads), "5", preset, program_word]
        printed = outcome([str(PROGRAM), *words], kernel)
        found = [
            [float.fromhex(word) for word in line.split()[1:]]
            for line in printed.splitlines()
            if line.startswith("transformation ")
        ]
        assert len(found) == 3
        words = ["--threads", str(threads), "--seed", "5", "--preset", preset, *options]
        shell = outcome([str(COMMAND), *map(str, files), *words], kernel)
        found.append([float(word) for word in shell.split()])
        for numbers in found:
            np.testing.assert_array_equal(np.reshape(numbers, (4, 4)), first.transformation)
