"""Takes the points of what users call a cloud, as the array that the C library reads."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .arrays import contiguous_rows, real_array
from .cloud_files import read_cloud
from .columns import columns_by_name
from .mesh import MESH_POINTS, mesh_of, sample_mesh
from .tensors import is_tensor, plain

# Where objects keep their points, in the order in which they are asked: laspy's ``points`` are raw
# records beside its ``xyz``; a trimesh.PointCloud has vertices; a tensor cloud of Open3D has
# ``point``, a mesh without faces ``vertex``; python-pcl has ``to_array()``.
_ATTRIBUTES = ("xyz", "points", "vertices", "point", "vertex", "to_array")


def as_points(cloud: Any, name: str, mesh_points: int = MESH_POINTS) -> NDArray[Any]:
    """Returns a cloud as float32 or float64 (N, 3), contiguous rows, without a copy if possible.

    Takes what docs/ENTRY_POINTS.md lists under "What a cloud may be". Masked points become NaN, so
    that they are dropped and counted.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N, 3), a file of no known format or with wrong content, a bad mesh.
        OSError: a file that cannot be read.
        ImportError: the package that reads such files is not installed.
    """
    cloud, name = opened(cloud, name)
    values = _coordinates(cloud, name, mesh_points)
    array = _three_columns(real_array(values, name), name)
    if array.dtype not in (np.dtype(np.float32), np.dtype(np.float64)):
        array = array.astype(np.float32 if array.dtype == np.float16 else np.float64)
    return contiguous_rows(array)


def opened(cloud: Any, name: str) -> tuple[Any, str]:
    """Returns what a file has, and how errors name it; anything else as it is.

    Raises OSError, ValueError or ImportError, as :func:`as_points`.
    """
    if not isinstance(cloud, (str, os.PathLike)):
        return cloud, name
    path = os.fspath(cloud)
    return read_cloud(path, name), f"{name}: {path}"


def _coordinates(cloud: Any, name: str, mesh_points: int) -> Any:
    if isinstance(cloud, np.ndarray) and cloud.dtype.names:
        return columns_by_name(cloud.dtype.names, cloud.__getitem__, name)
    if hasattr(cloud, "columns") and hasattr(cloud, "__getitem__"):  # a DataFrame
        named = columns_by_name(cloud.columns, cloud.__getitem__, name, unnamed=3)
        return cloud if named is None else named
    if is_tensor(cloud):
        return plain(cloud)
    if hasattr(cloud, "__array__"):
        return cloud
    if hasattr(cloud, "to_geometry"):  # a scene of trimesh
        cloud = cloud.to_geometry()
    mesh = mesh_of(cloud, name)
    if mesh is not None:
        return sample_mesh(*mesh, mesh_points, name) if mesh_points else mesh[0]
    for attribute in _ATTRIBUTES:
        try:
            return plain(getattr(cloud, attribute))
        except AttributeError:
            continue
        except TypeError as error:
            raise TypeError(f"{name}: {error}") from error
    return cloud


def _three_columns(array: NDArray[Any], name: str) -> NDArray[Any]:
    """Returns the array (N, 3) of coordinates, or those of homogeneous coordinates (N, 4)."""
    if array.ndim == 2 and array.shape[1] == 4 and array.shape[0] > 0 and (array[:, 3] == 1).all():
        return array[:, :3]
    if array.ndim == 2 and array.shape[1] == 3:
        return array
    hint = ""
    if array.ndim == 2 and array.shape[0] == 3:
        hint = "; one point is one row, so transpose it, by .T"
    elif array.ndim == 2 and array.shape[1] == 4:
        hint = (
            "; a fourth column is admitted where it is 1 throughout (homogeneous coordinates): give"
            " the coordinates alone, by [:, :3]"
        )
    elif array.ndim == 2 and array.shape[1] > 4:
        hint = "; give the coordinates alone, by [:, :3], and normals as the argument for normals"
    raise ValueError(f"{name}: expected an array of shape (N, 3), got {array.shape}{hint}")
