#!/usr/bin/env python3
"""Makes docs/many_scans.png: eight virtual scans of one shape and a scan of something else.

Aligns them by pyemtr.align_all() and saves its picture of the model with a palette, which keeps the
file small. Run it with build/venv/bin/python, which has Pillow. It takes about half a minute.
"""

from __future__ import annotations

import io
import sys
from pathlib import Path

import numpy as np
from PIL import Image

import pyemtr
from pyemtr.multiway.picture import model_picture

DOCS = Path(__file__).resolve().parent
VIEWS = [(45 * k, 18 if k % 2 else 32) for k in range(8)]  # azimuth and elevation, degrees
COLORS = 128
WIDTH = 1400  # pixels


def any_pose(rng: np.random.Generator) -> np.ndarray:
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    pose = np.eye(4)
    pose[:3, :3] = q * np.sign(np.diag(r)) * np.sign(np.linalg.det(q * np.sign(np.diag(r))))
    pose[:3, 3] = rng.uniform(-300, 300, 3)
    return pose


def scans(rng: np.random.Generator) -> list[np.ndarray]:
    """The shape from all sides, in millimeters, and a table of which one scan is among them."""
    sys.path.insert(0, str(DOCS.parent / "tools"))
    from virtual_scan import places, rays, scanner

    made = [scanner.scan(scanner.viewpoint(*view), 12000, 0.1, rng).points for view in VIEWS]
    eye = np.array([0.6, -0.6, 0.7])
    sight = rays.camera(eye, np.zeros(3), half_angle=27.0, columns=140, rows=105)
    made.insert(3, 100 * rays.see(places.table_top(), eye, sight, 0.0015, 3.0, rng))
    return made


def main() -> None:
    rng = np.random.default_rng(4)
    clouds = scans(rng)
    # The first scan stays upright, so the model does.
    poses = [np.eye(4), *(any_pose(rng) for _ in clouds[1:])]
    clouds = [cloud @ pose[:3, :3].T + pose[:3, 3] for cloud, pose in zip(clouds, poses)]
    result = pyemtr.align_all(clouds)
    print(result)
    for scan in result.placed:
        apart = result.scans[scan].pose @ poses[scan]
        degrees = np.degrees(np.arccos(np.clip((np.trace(apart[:3, :3]) - 1) / 2, -1, 1)))
        print(f"{result.scans[scan].name}: {degrees:.3f} degrees from the true pose")
    picture = Image.open(io.BytesIO(model_picture(result, 0))).convert("RGB")
    picture = picture.resize(
        (WIDTH, round(WIDTH * picture.height / picture.width)), Image.Resampling.LANCZOS
    )
    picture.quantize(COLORS).save(DOCS / "many_scans.png", optimize=True)


if __name__ == "__main__":
    main()
