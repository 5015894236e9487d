"""A mesh gives one pose, whether the shell or Python samples it."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import pyemtr

CLI = Path(os.environ.get("EMTR_CLI", Path(__file__).parents[2] / "build/tools/pcl_emtr"))


def relief(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (n * n, 3) and triangles (2 (n - 1)^2, 3) of a hilly square, uneven on purpose."""
    u, v = np.meshgrid(np.linspace(-1, 1, n) ** 3, np.linspace(-1, 1, n), indexing="ij")
    height = 0.3 * np.sin(3 * u + v) * np.cos(2 * v) + 0.3 * np.exp(-8 * ((u - 0.3) ** 2 + v**2))
    at = np.arange(n * n).reshape(n, n)
    a, b, c, d = at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]
    faces = np.concatenate(
        [np.stack(corners, -1).reshape(-1, 3) for corners in ((a, b, c), (a, c, d))]
    )
    return np.stack([u, v, height], -1).reshape(-1, 3), faces


def write_obj(path: Path, vertices: np.ndarray, faces: np.ndarray) -> None:
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (faces + 1).tolist()]
    path.write_text("\n".join(lines) + "\n")


def test_a_mesh_by_shell_and_python(tmp_path: Path) -> None:
    if not CLI.exists():
        pytest.skip(f"no command at {CLI} (set EMTR_CLI)")
    vertices, faces = relief(40)
    rotation = np.array([[0.0, -1, 0], [0, 0, -1], [1, 0, 0]])
    scan = np.round(np.random.default_rng(1).uniform(-1, 0.9, (6000, 2)), 6)
    u, v = scan.T
    height = 0.3 * np.sin(3 * u + v) * np.cos(2 * v) + 0.3 * np.exp(-8 * ((u - 0.3) ** 2 + v**2))
    source = np.round(np.column_stack([u, v, height]) @ rotation.T + [3, 4, 5], 6)
    np.savetxt(tmp_path / "source.xyz", source, fmt="%.6f")
    write_obj(tmp_path / "target.obj", vertices, faces)

    class Mesh:
        def __init__(self) -> None:
            self.vertices, self.faces = vertices, faces

    by_python = pyemtr.register(source, Mesh(), threads=1)
    command = [CLI, "source.xyz", "target.obj", "--threads", "1", "--report", "r.json"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
    report = json.loads((tmp_path / "r.json").read_text())
    by_shell = np.reshape(report["transformation"], (4, 4))
    assert by_python.registered and report["registered"]
    np.testing.assert_allclose(by_python.transformation, by_shell, atol=1e-5)
    np.testing.assert_allclose(by_python.transformation[:3, :3], rotation.T, atol=0.01)
