"""The files of an alignment."""

from __future__ import annotations

import io
import json
import os
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Floats
from ..whole_file import write_whole
from .fuse import FusedCloud
from .picture import has_matplotlib, model_picture

if TYPE_CHECKING:
    from .result import MultiwayResult

POSES = "poses"  # the folder of the poses, one text file a scan


def save(result: MultiwayResult, folder: str | os.PathLike[str], voxel: float | None) -> list[str]:
    """Does what :meth:`pyemtr.MultiwayResult.save` says."""
    require_plyfile()
    out = Path(folder)
    (out / POSES).mkdir(parents=True, exist_ok=True)
    written = []

    def write(name: str, content: bytes | str) -> None:
        write_whole(out / name, content)
        written.append(name)

    for i in result.placed:
        write(f"{POSES}/{result.scans[i].name}.txt", matrix_text(result.scans[i].pose))
    for model in range(len(result.models)):
        end = f"_{model}" if model else ""
        result.write_g2o(out / f"graph{end}.g2o", model)
        result.write_open3d(out / f"posegraph{end}.json", model)
        written += [f"graph{end}.g2o", f"posegraph{end}.json"]
        write(f"fused{end}.ply", ply_bytes(result.fuse(model, voxel)))
        if has_matplotlib():
            write(f"model{end}.png", model_picture(result, model))
    write("report.json", json.dumps(result.to_dict(), indent=1) + "\n")
    return written


def matrix_text(matrix: Floats) -> str:
    """Returns four rows of four numbers that read back to the same bits."""
    return "".join(" ".join(f"{value:.17g}" for value in row) + "\n" for row in matrix)


def require_plyfile() -> None:
    """Raises ImportError when plyfile is not installed."""
    try:
        import_module("plyfile")
    except ImportError as error:
        raise ImportError(
            "the fused cloud is written by plyfile, which is not installed:"
            " pip install 'pyemtr[align]'"
        ) from error


def ply_bytes(cloud: FusedCloud) -> bytes:
    """Returns a binary PLY file: x y z as double, and what the cloud has of nx ny nz (float) and
    red green blue (uchar)."""
    plyfile = import_module("plyfile")
    columns: list[tuple[str, str, Floats]] = [
        (name, "f8", cloud.points[:, i]) for i, name in enumerate("xyz")
    ]
    if cloud.normals is not None:
        columns += [(f"n{name}", "f4", cloud.normals[:, i]) for i, name in enumerate("xyz")]
    if cloud.colors is not None:
        bright = np.rint(255 * np.clip(cloud.colors, 0, 1))
        columns += [(n, "u1", bright[:, i]) for i, n in enumerate(("red", "green", "blue"))]
    table = np.empty(len(cloud.points), dtype=[(name, kind) for name, kind, _ in columns])
    for name, _, values in columns:
        table[name] = values
    content = io.BytesIO()
    element = plyfile.PlyElement.describe(table, "vertex")
    plyfile.PlyData([element], byte_order="<").write(content)
    return content.getvalue()
