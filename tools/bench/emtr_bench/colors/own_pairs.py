"""Cases of the user's own pairs of clouds, with the colors or intensities of their files."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from plyfile import PlyData, PlyParseError

from pyemtr.colors import brought_along

from ..data import chosen
from ..pairs import DataError, Pair, load
from ..protocol import apply, frame_scale, motion
from .paint import Array
from .scenes import Case

#: What a right pose of a real pair may be off: its ground truth has an error of its own.
DEGREES, SHARE = 5.0, 0.05  # the second of the larger cloud's radius


def own_pairs(arguments: argparse.Namespace) -> Iterator[tuple[Pair, list[Case]]]:
    """Reads the chosen pairs one by one; each source is moved by motions of the protocol, those of
    numbers `seed` to `seed + cases`. Raises DataError where a cloud has neither colors nor
    intensities, or a file is not what was expected."""
    for pair in chosen(arguments):
        looks = [_looks(pair.folder / name) for name in ("source.ply", "target.ply")]
        if pair.related:
            clouds = load(pair)
            source, target = apply(clouds.T_gt, clouds.source), clouds.target
        else:
            source, target = (look["points"] for look in looks)
        numbers = range(arguments.seed, arguments.seed + arguments.cases)
        yield pair, [_moved(pair.name, number, source, target, looks) for number in numbers]


def _moved(
    name: str, number: int, source: Array, target: Array, looks: list[dict[str, Any]]
) -> Case:
    made = motion(name, number, source)
    return Case(
        apply(made.matrix, source),
        target,
        looks[0]["colors"],
        looks[1]["colors"],
        made.T_true,
        looks[0]["intensity"],
        looks[1]["intensity"],
        tolerance=SHARE * frame_scale(source, target),
        degrees=DEGREES,
    )


def _looks(path: Path) -> dict[str, Any]:
    """Reads points (n, 3), and colors (n, 3), 0 to 1, or intensities (n,); None for none."""
    try:
        vertex = PlyData.read(str(path))["vertex"].data
        points = np.stack([np.asarray(vertex[axis], dtype=np.float64) for axis in "xyz"], axis=1)
    except (OSError, PlyParseError, KeyError, ValueError) as error:
        raise DataError(f"{path}: expected a PLY file with vertices x, y, z: {error}") from error
    colors, intensity = brought_along(vertex, str(path), len(points))
    if colors is None and intensity is None:
        raise DataError(
            f"{path}: has neither colors nor intensities, expected properties red, green and blue,"
            " or intensity"
        )
    return {"points": points, "colors": colors,
            "intensity": None if intensity is None else intensity.reshape(-1)}  # fmt: skip
