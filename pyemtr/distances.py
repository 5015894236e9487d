"""Distances of one cloud's points to the other cloud."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _emtr
from .arrays import Floats, as_transformation
from .mesh import MESH_POINTS, as_mesh_points
from .options import thread_setting
from .points import as_points


def residuals(
    source: Any,
    target: Any,
    transformation: Any = None,
    *,
    of: str = "source",
    threads: int = 0,
    mesh_points: int = MESH_POINTS,
) -> Floats:
    """Returns the distance of each point to the nearest point of the other cloud.

    Args:
        source: points (N, 3) as :func:`pyemtr.register` takes them; of a :class:`pyemtr.Cloud` all
            points, if it keeps them.
        target: points (M, 3), likewise.
        transformation: (4, 4), source into target, q = R p + t, in the clouds' unit, or a
            :class:`pyemtr.Result`; None for the identity.
        of: "source" for the distances of the moved source points to the target, "target" for the
            distances of the target's points to the moved source.
        threads: 0 for as many as OpenMP would use; the distances do not depend on it.
        mesh_points: as in :func:`pyemtr.register`; a mesh has that many points.

    Returns:
        float64 (N,), or (M,) for the target, in the clouds' unit, exact to 1e-6 of the other
        cloud's size, or of the distance where that is larger. NaN for points with a NaN or an
        infinity (or masked ones).

    Raises:
        TypeError: an argument of a wrong type.
        ValueError: a wrong shape, a matrix that is not rigid, a cloud without a finite point, or
            one that is a million times its size away from the other.
        OSError, ImportError: of files, as :func:`pyemtr.register`.
        MemoryError: an allocation failed.
    """
    if of not in ("source", "target"):
        raise ValueError(f'of: expected "source" or "target", got {of!r}')
    count = as_mesh_points(mesh_points)
    clouds = as_points(source, "source", count), as_points(target, "target", count)
    pose = (
        np.eye(4) if transformation is None else as_transformation(transformation, "transformation")
    )
    out = np.empty(len(clouds[of == "target"]), dtype=np.float64)
    _emtr.residuals(*clouds, pose.reshape(16), thread_setting(threads), of == "target", out)
    return out
