#!/usr/bin/env python3
"""Makes a sample pair: two virtual scans of one shape, each in a frame of its own.

Writes source.pcd, target.pcd (binary, VIEWPOINT = the sensor's position in the file's own
frame) and T_true.txt, the 4x4 transformation that maps source into target, q = R p + t. The
shape is a dragon about 105 mm high; all lengths are in millimetres. The same options give the
same bytes.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from virtual_scan.files import write_pcd, write_transformation
from virtual_scan.overlap import overlap, resolution
from virtual_scan.scanner import Scan, scan, viewpoint

Array = NDArray[np.float64]

# Azimuth and elevation of the sensors, degrees: about 60 % of each scan is in the other.
SOURCE_VIEW = (-42.0, 22.0)
TARGET_VIEW = (28.0, 14.0)


@dataclass
class Pair:
    """Two scans in the frame of the shape, and the poses (4, 4) that take them to the files."""

    source: Scan
    target: Scan
    source_pose: Array
    target_pose: Array

    @property
    def transformation(self) -> Array:
        """The true pose (4, 4), source file into target file."""
        return np.asarray(self.target_pose @ np.linalg.inv(self.source_pose))


def apply(pose: Array, points: Array) -> Array:
    """Points (N, 3) or (3,) moved by a pose (4, 4)."""
    return np.asarray(points @ pose[:3, :3].T + pose[:3, 3])


def rigid(rotation: Array, translation: Array) -> Array:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation, translation
    return pose


def random_rotation(rng: np.random.Generator) -> Array:
    """A rotation (3, 3), uniform over SO(3), from a random unit quaternion."""
    q = rng.normal(size=4)
    w, x, y, z = q / np.linalg.norm(q)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + 2 * w * cross + 2 * cross @ cross)


def make_pair(seed: int = 5, points: int = 40000, noise: float = 0.1) -> Pair:
    """Scans the shape twice; about `points` points each, `noise` in mm along the rays."""
    rng = np.random.default_rng(seed)
    source = scan(viewpoint(*SOURCE_VIEW), points, noise, rng)
    target = scan(viewpoint(*TARGET_VIEW), points, noise, rng)
    # The target's scanner stood level, so z is up in target.pcd; the source's lay anyhow.
    azimuth = rng.uniform(-np.pi, np.pi)
    level = np.array(
        [[np.cos(azimuth), -np.sin(azimuth), 0], [np.sin(azimuth), np.cos(azimuth), 0], [0, 0, 1]]
    )
    target_pose = rigid(level, rng.uniform(-60, 60, 3))
    source_pose = rigid(random_rotation(rng), rng.uniform(-60, 60, 3))
    return Pair(source, target, source_pose, target_pose)


def write_pair(pair: Pair, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, seen, pose in (
        ("source.pcd", pair.source, pair.source_pose),
        ("target.pcd", pair.target, pair.target_pose),
    ):
        write_pcd(folder / name, apply(pose, seen.points), apply(pose, seen.viewpoint))
    write_transformation(folder / "T_true.txt", pair.transformation)


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    add = parser.add_argument
    add("--out", type=Path, required=True, metavar="DIR", help="folder, made if need be")
    add("--seed", type=int, default=5, metavar="N", help="of noise and frames, >= 0 [%(default)s]")
    add(
        "--points",
        type=int,
        default=40000,
        metavar="N",
        help="of each scan, about; 1000 to 1000000 [%(default)s]",
    )
    add(
        "--noise",
        type=float,
        default=0.1,
        metavar="MM",
        help="standard deviation along the rays, 0 to 5 mm [%(default)s]",
    )
    options = parser.parse_args()
    if options.seed < 0:
        parser.error(f"--seed: expected 0 or more, got {options.seed}")
    if not 1000 <= options.points <= 1000000:
        parser.error(f"--points: expected 1000 to 1000000, got {options.points}")
    if not 0 <= options.noise <= 5:
        parser.error(f"--noise: expected 0 to 5 mm, got {options.noise}")

    pair = make_pair(options.seed, options.points, options.noise)
    try:
        write_pair(pair, options.out)
    except OSError as error:
        print(f"{parser.prog}: error: --out {options.out}: {error}", file=sys.stderr)
        return 1
    source, target = pair.source.points, pair.target.points
    radius = 2 * max(resolution(source), resolution(target))
    print(f"source {len(source)} points, target {len(target)} points")
    print(f"resolution {radius / 2:.3f} mm, noise {options.noise:g} mm")
    print(
        f"overlap within {radius:.2f} mm: {overlap(source, target, radius):.0%} of the source, "
        f"{overlap(target, source, radius):.0%} of the target"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
