"""Priors given through four APIs: the same bits, for any kernel and number of threads."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from reproducibility_matrix.clouds import generated, write_pcd
from test_user_input import COMMAND, KERNELS, PROGRAM, outcome

import pyemtr

# The same in entries.cpp.
GUESS = [[0, 0, 1, -5.5], [1, 0, 0, -4.5], [0, 1, 0, -5], [0, 0, 0, 1]]
PRIORS: dict[str, Any] = {
    "guess": GUESS,
    "guess_rotation": 40,
    "guess_translation": 3,
    "axis": [1, 1.1, 1],
    "axis_tilt": 4,
    "axis_angle_minimum": -170,
    "axis_angle_maximum": 200,
    "translation_bounds": [[-9, -9, -9], [9, 9, 9]],
    "maximum_rotation": 170,
}


def options(folder: Path) -> list[str]:
    """Returns the priors as options of the shell."""
    words = []
    np.savetxt(folder / "guess.txt", GUESS)
    for name, value in PRIORS.items():
        numbers = [folder / "guess.txt"] if name == "guess" else np.ravel(value).tolist()
        words += ["--" + name.replace("_", "-"), *map(str, numbers)]
    return words


@pytest.mark.parametrize("preset", ["default", "thorough", "paper"])
def test_same_bits(preset: str, tmp_path: Path) -> None:
    for program in (PROGRAM, COMMAND):
        if not program.is_file():
            pytest.skip(f"no {program}: run tools/check, or set EMTR_BUILD_DIR")
    source, target = generated()
    files = [write_pcd(tmp_path / "s.pcd", source), write_pcd(tmp_path / "t.pcd", target)]
    first = pyemtr.register(source, target, seed=5, threads=1, preset=preset, **PRIORS)
    plain = pyemtr.register(source, target, seed=5, preset=preset)
    assert (first.transformation != plain.transformation).any()
    for threads, kernel in zip((1, 3), KERNELS, strict=True):
        again = pyemtr.register(source, target, seed=5, threads=threads, preset=preset, **PRIORS)
        np.testing.assert_array_equal(again.transformation, first.transformation)
        np.testing.assert_array_equal(again.history["alpha"], first.history["alpha"])
        words = [*map(str, files), str(threads), "5", preset]
        printed = outcome([str(PROGRAM), *words, "priors"], kernel).splitlines()
        for name, wanted in (
            ("transformation", first.transformation.ravel()),
            ("history_alpha", first.history["alpha"]),
        ):
            lines = [line.split()[1:] for line in printed if line.startswith(name + " ")]
            assert len(lines) == 3
            for line in lines:
                np.testing.assert_array_equal([float.fromhex(word) for word in line], wanted)
        words = ["--threads", str(threads), "--seed", "5", "--preset", preset, *options(tmp_path)]
        shell = outcome([str(COMMAND), *map(str, files), *words], kernel)
        np.testing.assert_array_equal(
            [float(word) for word in shell.split()], first.transformation.ravel()
        )
