"""One cloud, preprocessed once for many registrations."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _emtr
from .arrays import Floats, as_features, as_normals, as_points
from .options import thread_setting


class Cloud:
    """Points that are read, measured and, above 200 000, downsampled: once for many registrations.

    :func:`pyemtr.register`, :class:`pyemtr.Problem` and the tasks take it in place of an array,
    as source or as target, and give the same bits::

        model = pyemtr.Cloud(points)
        results = [pyemtr.register(scan, model) for scan in scans]

    It never changes and does not refer to the caller's memory; threads may share it.

    Args:
        points: as :func:`pyemtr.register` takes them, (N, 3) in any unit.
        normals: (N, 3) or None, as ``source_normals`` of :func:`pyemtr.register`.
        features: (N, D) or None, as its ``source_features``.
        keep_points: keep all points of a cloud of more than 200 000, 12 bytes each, so that it can
            be registered with ``correspondences``. A smaller cloud always keeps them.
        threads: 0 for as many as OpenMP would use; the cloud does not depend on it.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N, 3), not as many normals or features as points, or a cloud that cannot
            be registered (fewer than 10 finite points, all on one point or one line).
    """

    def __init__(
        self,
        points: Any,
        *,
        normals: Any = None,
        features: Any = None,
        keep_points: bool = False,
        threads: int = 0,
    ) -> None:
        self._raw = _emtr.Preprocessed(
            _buffer(points, "points", normals, "normals", features, "features", keep_points),
            "",
            thread_setting(threads),
        )
        self._info: dict[str, Any] = self._raw.describe()

    def __len__(self) -> int:
        """The number of finite points."""
        return int(self._info["points"])

    @property
    def dropped(self) -> int:
        """The number of points dropped because of a NaN or an infinity."""
        return int(self._info["dropped"])

    @property
    def strays(self) -> int:
        """The number of finite points far outside of all the others, which are left out."""
        return int(self._info["strays"])

    @property
    def has_normals(self) -> bool:
        """True when the user provided normals."""
        return bool(self._info["normals"])

    @property
    def keypoints(self) -> int:
        """The number of points with user-provided features; counted after downsampling when the
        cloud has more than 200 000 points."""
        return int(self._info["keypoints"])

    @property
    def center(self) -> Floats:
        """The centroid of the finite points but strays: float64 (3,), in their unit."""
        return np.array(self._info["center"], dtype=np.float64)

    @property
    def radius(self) -> float:
        """The largest distance of a point but strays from the centroid, in their unit."""
        return float(self._info["radius"])

    def __repr__(self) -> str:
        dropped = f", {self.dropped} dropped" if self.dropped else ""
        strays = f", {self.strays} strays" if self.strays else ""
        normals = ", normals" if self.has_normals else ""
        features = f", {self.keypoints} features of {self._info['feature_dimension']}"
        return (
            f"<pyemtr.Cloud: {len(self)} points{dropped}{strays}{normals}"
            f"{features if self.keypoints else ''}, radius {self.radius:.6g}>"
        )


def as_cloud(
    cloud: Any, name: str, normals: Any = None, features: Any = None, keep_points: bool = False
) -> _emtr.CloudBuffer | _emtr.Preprocessed:
    """Returns what the C library reads: a preprocessed cloud, or points with their normals and
    features. Raises TypeError when a :class:`Cloud` comes with normals or features beside it."""
    if not isinstance(cloud, Cloud):
        return _buffer(
            cloud, name, normals, f"{name}_normals", features, f"{name}_features", keep_points
        )
    for given, what in ((normals, "normals"), (features, "features")):
        if given is not None:
            raise TypeError(
                f"{name}_{what}: a pyemtr.Cloud has its own; give them to pyemtr.Cloud()"
            )
    return cloud._raw


def _buffer(
    points: Any,
    points_name: str,
    normals: Any,
    normals_name: str,
    features: Any,
    features_name: str,
    keep_points: bool,
) -> _emtr.CloudBuffer:
    array = as_points(points, points_name)
    return _emtr.CloudBuffer(
        array,
        None if normals is None else as_normals(normals, normals_name, array),
        None if features is None else as_features(features, features_name, array),
        keep_points,
    )
