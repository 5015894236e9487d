"""Reads clouds from files, each format by the package that is made for it."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from .mesh import triangles
from .text_clouds import read_text

_TEXT = (".asc", ".csv", ".pts", ".txt", ".xyz")
_NAMES = ("points", "xyz", "vertices")  # of the array that is the cloud, in an archive of several
_HINTS = {
    **dict.fromkeys(
        (".glb", ".gltf", ".obj", ".off", ".stl"), "give the mesh that trimesh.load_mesh() returns"
    ),
    ".bin": "give numpy.fromfile(path, numpy.float32).reshape(-1, 4)[:, :3], if it is KITTI's",
    ".e57": "give the points that pye57 returns",
}


class MeshFile(NamedTuple):
    """A mesh as a file has it."""

    vertices: Any
    faces: Any


def read_cloud(path: str, name: str) -> Any:
    """Returns what a file has: an array, a table with named columns, or a :class:`MeshFile`.

    The format is that of the file's ending; docs/ENTRY_POINTS.md has the list.

    Raises:
        ValueError: an ending that is not on the list, or content that does not fit the format.
        OSError: the file cannot be read.
        ImportError: the package that reads the format is not installed.
    """
    ending = Path(path).suffix.lower()
    if ending in _TEXT:
        read: Any = read_text
    elif ending in _READERS:
        read = _READERS[ending]
    else:
        hint = _HINTS.get(ending, f"known are {', '.join(FORMATS)}")
        raise ValueError(f"{name}: {path}: no format that pyemtr reads: {hint}")
    with open(path, "rb"):  # the error of a file that is not there is the system's for all formats
        pass
    try:
        return read(path)
    except ImportError as error:
        raise ImportError(
            f"{name}: {path}: {ending[1:].upper()} files need the package {error.name}, which is"
            " not installed: pip install 'pyemtr[files]'"
        ) from error
    except (OSError, MemoryError):
        raise
    except Exception as error:  # each package has errors of its own
        raise ValueError(f"{name}: {path}: {error}") from error


def _read_npy(path: str) -> Any:
    return np.load(path, allow_pickle=False)


def _read_npz(path: str) -> Any:
    with np.load(path, allow_pickle=False) as archive:
        if not hasattr(archive, "files"):
            raise ValueError("expected an archive of arrays, got one array: name it .npy")
        known = [one for one in _NAMES if one in archive.files]
        if len(archive.files) != 1 and not known:
            raise ValueError(
                f"expected one array, or one named {', '.join(_NAMES[:-1])} or {_NAMES[-1]}, got"
                f" {', '.join(archive.files) or 'none'}"
            )
        return archive[known[0] if known else archive.files[0]]


def _read_ply(path: str) -> Any:
    content = import_module("plyfile").PlyData.read(path)
    vertices = content["vertex"].data
    if "face" not in content or content["face"].count == 0:
        return vertices
    face = content["face"]
    rows = next(
        (p.name for p in face.properties if p.name in ("vertex_indices", "vertex_index")), ""
    )
    if not rows:
        return vertices
    return MeshFile(
        np.column_stack([vertices[axis] for axis in "xyz"]), triangles(list(face[rows]))
    )


def _read_pcd(path: str) -> Any:
    return import_module("pypcd4").PointCloud.from_path(path).pc_data


class LasPoints(NamedTuple):
    """The points of a LAS file, with what it has beside them."""

    xyz: Any
    colors: Any
    intensity: Any


def _read_las(path: str) -> Any:
    content = import_module("laspy").read(path)
    known = set(content.point_format.dimension_names)
    colors = intensity = None
    if {"red", "green", "blue"} <= known and np.any(content.red):
        colors = np.column_stack([content.red, content.green, content.blue])
    if "intensity" in known and np.any(content.intensity):
        intensity = np.asarray(content.intensity)
    return LasPoints(np.asarray(content.xyz), colors, intensity)


_READERS = {
    ".las": _read_las,
    ".laz": _read_las,
    ".npy": _read_npy,
    ".npz": _read_npz,
    ".pcd": _read_pcd,
    ".ply": _read_ply,
}

#: The endings of the files that :func:`read_cloud` reads.
FORMATS = tuple(sorted([*_TEXT, *_READERS]))
