"""The ModelNet40 protocol: 1024 points of a shape, rotated by up to 45 degrees about each axis and
moved by up to 0.5; clean (the same points) or noisy (other points, with noise of 0.01 cut at 0.05).

The shapes are the test shapes of the user's ModelNet40, of its last 20 categories where it has all
40, as RPM-Net's unseen categories: 1266 pairs. Where there is no such folder they are made: solids
of revolution, blocks and pipes, put together by chance.
"""

from __future__ import annotations

import time
import zlib
from pathlib import Path
from typing import Any

import numpy as np

import pyemtr
from pyemtr.metrics import rotation_error

from ..convert.modelnet import read_off
from ..pairs import DataError
from ..protocol import apply, euler_zyx
from ..runner import Array

POINTS = 1024
NOISE, MOST_NOISE = 0.01, 0.05
ANGLE, DISTANCE = np.radians(45.0), 0.5
CATEGORIES, UNSEEN = 40, 20
CLEAN, NOISY = "clean", "noisy"
MADE_NAME = "made shape"


def shapes(folder: Path | None, most: int) -> list[str]:
    """Paths of the shapes' files, or the names of made ones. Raises DataError for a folder that
    has no test shapes."""
    if folder is None:
        return [f"{MADE_NAME} {i}" for i in range(most)]
    files: dict[str, list[Path]] = {}
    for path in sorted(folder.rglob("*.off")):
        if path.parent.name == "test":
            files.setdefault(path.parent.parent.name, []).append(path)
    if not files:
        raise DataError(f"--modelnet {folder}: expected CATEGORY/test/SHAPE.off below it")
    names = sorted(files)
    chosen = names[UNSEEN:] if len(names) == CATEGORIES else names
    every = [path for name in chosen for path in files[name]]
    step = max(1, len(every) // most)  # of each category some, when not all are wanted
    return [str(path) for path in every[::step][:most]]


def run(method: str, shape: str, seed: int, threads: int) -> dict[str, Any]:
    """One run of a preset; `method` is "PRESET, clean" or "PRESET, noisy"."""
    preset, _, kind = method.partition(", ")
    vertices, faces = made(shape) if shape.startswith(MADE_NAME) else read_off(Path(shape))
    source, target, T = pair(vertices, faces, kind, zlib.crc32(Path(shape).stem.encode()))
    start = time.perf_counter()
    found = pyemtr.register(source, target, preset=preset, seed=seed, threads=threads)
    seconds = time.perf_counter() - start
    pose = found.transformation
    return {
        "E_R": rotation_error(pose, T),
        "E_t": float(np.linalg.norm(pose[:3, 3] - T[:3, 3])),
        "seconds": seconds, "registered": found.registered, "reason": found.reason,
    }  # fmt: skip


def pair(vertices: Array, faces: Array, kind: str, seed: int) -> tuple[Array, Array, Array]:
    """Source and target (1024, 3), and the pose (4, 4) that maps the one into the other."""
    rng = np.random.default_rng(seed)
    middle = (vertices.max(axis=0) + vertices.min(axis=0)) / 2
    unit = (vertices - middle) / np.linalg.norm(vertices - middle, axis=1).max()
    cloud = sampled(unit, faces, 2 * POINTS, rng)
    source = cloud[rng.permutation(len(cloud))[:POINTS]]
    target = source.copy()
    if kind == NOISY:
        target = cloud[rng.permutation(len(cloud))[:POINTS]]
        source, target = (points + np.clip(rng.normal(0.0, NOISE, points.shape),
                                           -MOST_NOISE, MOST_NOISE)
                          for points in (source, target))  # fmt: skip
    T = np.eye(4)
    T[:3, :3] = euler_zyx(rng.uniform(0.0, ANGLE, 3))
    T[:3, 3] = rng.uniform(-DISTANCE, DISTANCE, 3)
    return source, apply(T, rng.permutation(target)), T


def sampled(vertices: Array, faces: Array, count: int, rng: np.random.Generator) -> Array:
    """Points (count, 3), uniform over the surface."""
    a, b, c = (vertices[faces[:, i]] for i in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    chosen = rng.choice(len(faces), count, p=areas / areas.sum())
    u, v = rng.random((2, count, 1))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    return np.asarray(a[chosen] + u * (b - a)[chosen] + v * (c - a)[chosen])


def made(name: str) -> tuple[Array, Array]:
    """Vertices (n, 3) and triangles (m, 3) of a made shape: a body and three to six parts on it."""
    rng = np.random.default_rng(zlib.crc32(name.encode()))
    vertices, faces, count = [], [], 0
    for i in range(int(rng.integers(4, 8))):
        part, triangles = (_block, _revolved, _pipe)[int(rng.integers(3))](rng)
        size = 1.0 if i == 0 else rng.uniform(0.15, 0.5)
        place = np.zeros(3) if i == 0 else rng.uniform(-0.9, 0.9, 3)
        R = euler_zyx(rng.choice([0.0, np.pi / 2], 3) if i else np.zeros(3))
        vertices.append(size * part @ R.T + place)
        faces.append(triangles + count)
        count += len(part)
    return np.concatenate(vertices), np.concatenate(faces)


def _block(rng: np.random.Generator) -> tuple[Array, Array]:
    sides = rng.uniform(0.2, 1.0, 3)
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * sides
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def _revolved(rng: np.random.Generator) -> tuple[Array, Array]:
    radii = rng.uniform(0.1, 0.8, 6)
    return _rings(radii, np.linspace(-1.0, 1.0, 6), np.zeros((6, 2)))


def _pipe(rng: np.random.Generator) -> tuple[Array, Array]:
    bend = np.outer(np.linspace(-1.0, 1.0, 8) ** 2, rng.uniform(-0.8, 0.8, 2))
    return _rings(np.full(8, rng.uniform(0.1, 0.3)), np.linspace(-1.0, 1.0, 8), bend)


def _rings(radii: Array, heights: Array, middles: Array, around: int = 24) -> tuple[Array, Array]:
    angle = 2.0 * np.pi * np.arange(around) / around
    rings = [np.column_stack([middle[0] + r * np.cos(angle), middle[1] + r * np.sin(angle),
                              np.full(around, z)])
             for r, z, middle in zip(radii, heights, middles)]  # fmt: skip
    triangles = []
    for i in range(len(radii) - 1):
        for j in range(around):
            a, b = i * around + j, i * around + (j + 1) % around
            triangles += [(a, b, b + around), (a, b + around, a + around)]
    return np.concatenate(rings), np.array(triangles)
