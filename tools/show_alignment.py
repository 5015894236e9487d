#!/usr/bin/env python3
"""Prints a pose that was found beside the true one, and draws the clouds before and after.

Reads source.pcd, target.pcd and T_true.txt, made by sample_pair.py, and T.txt, the pose found,
from one folder; writes alignment.png there. Returns 1 unless the pose is right: less than 5
degrees off, and the source's center moved to within 0.06 of the larger cloud's radius.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from virtual_scan.files import read_pcd

Array = NDArray[np.float64]

UNIT = "mm"  # of the sample pair


def read_transformation(path: Path) -> Array:
    matrix = np.loadtxt(path)
    if matrix.shape != (4, 4):
        raise ValueError(f"{path}: expected 4 rows of 4 numbers, got shape {matrix.shape}")
    return matrix


def side_by_side(found: Array, true: Array) -> str:
    """Both matrices with captions, as lines of text."""
    lines = [f"{'T found':<47}   true T"]
    for left, right in zip(found, true):
        lines.append("   ".join(" ".join(f"{v:11.6f}" for v in row) for row in (left, right)))
    return "\n".join(lines)


def radius(points: Array) -> float:
    return float(np.linalg.norm(points - points.mean(axis=0), axis=1).max())


def show(folder: Path, title: str) -> bool:
    """Prints, draws, and tells whether the pose is right."""
    from pyemtr.metrics import joint_success, rotation_error, translation_error
    from pyemtr.plot import plot_alignment

    source, source_eye = read_pcd(folder / "source.pcd")
    target, target_eye = read_pcd(folder / "target.pcd")
    true = read_transformation(folder / "T_true.txt")
    found = read_transformation(folder / "T.txt")
    center, scale = source.mean(axis=0), max(radius(source), radius(target))
    rotation = rotation_error(found, true)
    translation = translation_error(found, true, center, scale) * scale
    print(side_by_side(found, true))
    print(f"rotation error     {rotation:.4f} degrees")
    print(f"translation error  {translation:.4f} {UNIT}, of the source's center")
    errors = f"{rotation:.2f} degrees and {translation:.2f} {UNIT} from the true pose"
    picture = folder / "alignment.png"
    # from between the two scanners, where both scans are seen from the front
    ways = [found[:3, :3] @ (source_eye - center), target_eye - target.mean(axis=0)]
    view = sum(way / np.linalg.norm(way) for way in ways)
    plot_alignment(source, target, found, picture, title=f"{title}, {errors}", unit=UNIT, view=view)
    print(f"picture            {picture}")
    return bool(joint_success(found, true, center, scale))


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path, help="with the four files")
    parser.add_argument("--title", default="Registration", help="of the picture [%(default)s]")
    options = parser.parse_args()
    try:
        right = show(options.folder, options.title)
    except (ImportError, OSError, ValueError) as error:
        print(f"{parser.prog}: error: {error}", file=sys.stderr)
        return 2
    if not right:
        print(f"{parser.prog}: the pose is not the true one", file=sys.stderr)
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
