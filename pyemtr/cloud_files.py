"""Reads clouds from files, each format by the package that is made for it."""

from __future__ import annotations

import gzip
import shutil
import tempfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from .e57_files import ScannedPoints, read_e57
from .mesh_files import read_obj, read_off, surface_or_points
from .stl_files import read_stl
from .text_clouds import read_text

_TEXT = (".asc", ".csv", ".pts", ".txt", ".xyz")
_NAMES = ("points", "xyz", "vertices")  # of the array that is the cloud, in an archive of several
_PACKED = ".gz"
_HINTS = {
    **dict.fromkeys((".glb", ".gltf"), "give the mesh that trimesh.load_mesh() returns"),
    ".bin": "give numpy.fromfile(path, numpy.float32).reshape(-1, 4)[:, :3], if it is KITTI's",
}


def read_cloud(path: str, name: str) -> Any:
    """Returns what a file has: an array, a table with named columns, a mesh, or scanned points.

    The format is that of the file's ending, before ".gz" if gzip has compressed it;
    docs/ENTRY_POINTS.md has the list.

    Raises:
        ValueError: an ending that is not on the list, or content that does not fit the format.
        OSError: the file cannot be read.
        ImportError: the package that reads the format is not installed.
    """
    ending = ending_of(path)
    if ending not in _READERS:
        hint = _HINTS.get(ending, f"known are {', '.join(FORMATS)}, and {_PACKED} behind them")
        raise ValueError(f"{name}: {path}: no format that pyemtr reads: {hint}")
    with open(path, "rb"):  # the error of a file that is not there is the system's for all formats
        pass
    try:
        if Path(path).suffix.lower() != _PACKED:
            return _READERS[ending](path)
        with _unpacked(path, ending) as place:
            return _READERS[ending](place)
    except ImportError as error:
        raise ImportError(
            f"{name}: {path}: {ending[1:].upper()} files need the package {error.name}, which is"
            f" not installed: pip install 'pyemtr[{_EXTRAS.get(ending, 'files')}]'"
        ) from error
    except (gzip.BadGzipFile, EOFError, zlib.error) as error:
        raise ValueError(f"{name}: {path}: {error}") from error
    except (OSError, MemoryError):
        raise
    except Exception as error:  # each package has errors of its own
        raise ValueError(f"{name}: {path}: {error}") from error


def ending_of(path: str) -> str:
    """Returns what a file's format is known by, as ".ply": its ending, before ".gz", in lower
    case."""
    whole = Path(path)
    packed = whole.suffix.lower() == _PACKED
    return (whole.with_suffix("") if packed else whole).suffix.lower()


@contextmanager
def _unpacked(path: str, ending: str) -> Iterator[str]:
    """Unpacks a file into a temporary one, for readers that want a path."""
    with tempfile.NamedTemporaryFile(prefix="pyemtr-", suffix=ending) as file:
        with gzip.open(path, "rb") as packed:
            shutil.copyfileobj(packed, file, 1 << 20)
        file.flush()
        yield file.name


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
    corners = np.column_stack([vertices[axis] for axis in "xyz"])
    return surface_or_points(corners, list(face[rows]), vertices)


def _read_pcd(path: str) -> Any:
    return import_module("pypcd4").PointCloud.from_path(path).pc_data


def _read_las(path: str) -> Any:
    laspy = import_module("laspy")
    if Path(path).suffix.lower() == ".laz" and not laspy.LazBackend.detect_available():
        raise ImportError("laspy has no LAZ backend", name="lazrs")
    content = laspy.read(path)
    known = set(content.point_format.dimension_names)
    colors = intensity = None
    if {"red", "green", "blue"} <= known and np.any(content.red):
        colors = np.column_stack([content.red, content.green, content.blue])
    if "intensity" in known and np.any(content.intensity):
        intensity = np.asarray(content.intensity)
    return ScannedPoints(np.asarray(content.xyz), colors, intensity)


_READERS: dict[str, Callable[[str], Any]] = {
    **dict.fromkeys(_TEXT, read_text),
    ".e57": read_e57,
    ".las": _read_las,
    ".laz": _read_las,
    ".npy": _read_npy,
    ".npz": _read_npz,
    ".obj": read_obj,
    ".off": read_off,
    ".pcd": _read_pcd,
    ".ply": _read_ply,
    ".stl": read_stl,
}
_EXTRAS = {".e57": "e57"}  # of the package that reads a format; "files" for all others

#: The endings of the files that :func:`read_cloud` reads; ".gz" may follow each.
FORMATS = tuple(sorted(_READERS))
