"""Colors and intensities in the clouds' files, in all their spellings."""

from __future__ import annotations

import json

import cloud_files
import numpy as np
import pytest

SIDES = ((0.0, 0.8), (0.6, 1.0))  # center and exposure of the scans


def wall(center: float, exposure: float, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """A flat wall with patches: points (n, 3) and colors (n, 3), 0 to 1."""
    rng = np.random.default_rng(seed)
    places = rng.uniform([center - 1, -0.8], [center + 1, 0.8], (12000, 2))
    colors = np.full((len(places), 3), 0.8)
    patches = np.random.default_rng(3)
    for _ in range(14):
        corner, size = patches.uniform([-1.2, -0.9], [1.5, 0.7]), patches.uniform(0.1, 0.45, 2)
        inside = ((places > corner) & (places < corner + size)).all(axis=1)
        colors[inside] = patches.uniform(0, 1, 3)
    points = np.column_stack([places, rng.normal(scale=0.002, size=len(places))])
    return points, np.clip(exposure * colors + rng.normal(scale=0.02, size=colors.shape), 0, 1)


@pytest.fixture(scope="module")
def walls():
    (source, source_colors), (target, target_colors) = (
        wall(*side, seed) for seed, side in enumerate(SIDES)
    )
    rotation = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    return source @ rotation.T + [1, 2, 3], source_colors, target, target_colors


TRUTH = np.array([[0.0, 1, 0, -2], [-1, 0, 0, 1], [0, 0, 1, -3], [0, 0, 0, 1]])


def packed(colors: np.ndarray) -> np.ndarray:
    r, g, b = (255 * colors).astype("u4").T
    return r << 16 | g << 8 | b


SPELLINGS = {
    "rgb": lambda c: {"rgb": packed(c).view("f4")},
    "rgba": lambda c: {"rgba": packed(c) | 255 << 24},
    "bytes": lambda c: dict(zip(("red", "green", "blue"), (255 * c).astype("u1").T)),
    "words": lambda c: dict(zip(("r", "g", "b"), (65535 * c).astype("u2").T)),
    "reals": lambda c: dict(zip(("r", "g", "b"), c.astype("f4").T)),
    "intensity": lambda c: {"intensity": (500 * c[:, 0]).astype("f4")},
}


def register(run, folder, walls, spelling, *options, write=cloud_files.write_pcd, ending="pcd"):
    source, source_colors, target, target_colors = walls
    spell = SPELLINGS[spelling]
    for name, points, colors in (("a", source, source_colors), ("b", target, target_colors)):
        rows = cloud_files.table(points.astype("f4"), **spell(colors))
        write(folder / f"{name}.{ending}", rows)
    done = run(f"a.{ending}", f"b.{ending}", "--preset", "fast", "--report", "r.json", *options)
    return done, json.loads((folder / "r.json").read_text())


@pytest.mark.parametrize("spelling", sorted(set(SPELLINGS) - {"intensity"}))
def test_a_flat_wall_is_registered_by_its_colors(run, tmp_path, walls, spelling):
    done, report = register(run, tmp_path, walls, spelling)
    assert done.returncode == 0, done.stderr
    assert report["colors"]["used_colors"] is True
    T = np.array([float(v) for v in done.stdout.split()]).reshape(4, 4)
    np.testing.assert_allclose(T, TRUTH, atol=0.02)


def test_intensities_are_read(run, tmp_path, walls):
    """One channel of three tells less: here it need not decide."""
    done, report = register(run, tmp_path, walls, "intensity", "--use-colors", "on")
    assert done.returncode in (0, 3), done.stderr
    assert report["colors"]["color_correlation"] is not None


def test_ply_has_colors_too(run, tmp_path, walls):
    done, report = register(
        run, tmp_path, walls, "bytes", write=cloud_files.write_ply, ending="ply"
    )
    assert done.returncode == 0, done.stderr
    assert report["colors"]["used_colors"] is True


def test_without_colors_the_wall_is_not_registered(run, tmp_path, walls):
    done, report = register(run, tmp_path, walls, "bytes", "--use-colors", "off")
    assert done.returncode == 3
    assert report["colors"]["used_colors"] is False
    assert report["colors"]["color_evidence"] is None


def test_asked_for_colors_must_be_there(run, tmp_path, walls):
    source, _, target, _ = walls
    cloud_files.write_pcd(tmp_path / "a.pcd", source)
    cloud_files.write_pcd(tmp_path / "b.pcd", target)
    done = run("a.pcd", "b.pcd", "--use-colors", "on")
    assert done.returncode == 2
    assert "a.pcd" in done.stderr and "has neither colors nor intensities" in done.stderr
