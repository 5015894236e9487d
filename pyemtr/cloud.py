"""One cloud, preprocessed once for many registrations."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _emtr
from .arrays import Floats, as_features, as_normals
from .mesh import MESH_POINTS, as_mesh_points
from .options import thread_setting
from .points import as_points

_ALWAYS_KEPT = 200_000  # points; the library keeps those of smaller clouds too


class Cloud:
    """Points that are read, measured and, above 200 000, downsampled: once for many registrations.

    :func:`pyemtr.register`, :class:`pyemtr.Problem` and the tasks take it in place of an array,
    as source or as target, and give the same bits::

        model = pyemtr.Cloud(points)
        results = [pyemtr.register(scan, model) for scan in scans]

    It never changes and does not refer to the caller's memory; threads may share it. It can be
    pickled, and is then preprocessed again where it is read, to the same bits.

    Args:
        points: as :func:`pyemtr.register` takes them: an array (N, 3) in any unit, a file, a mesh
            or an object with points.
        normals: (N, 3) or None, as ``source_normals`` of :func:`pyemtr.register`.
        features: (N, D) or None, as its ``source_features``.
        keep_points: keep all points of a cloud of more than 200 000: 12 bytes each, so that it can
            be registered with ``correspondences``, and the array as it was given, with normals
            and features, for ``points`` and pickles. A smaller cloud always keeps them.
        threads: 0 for as many as OpenMP would use; the cloud does not depend on it.
        mesh_points: as in :func:`pyemtr.register`.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N, 3), not as many normals or features as points, or a cloud that cannot
            be registered (fewer than 10 finite points, all on one point or one line).
        OSError, ImportError: of files, as :func:`pyemtr.register`.
    """

    def __init__(
        self,
        points: Any,
        *,
        normals: Any = None,
        features: Any = None,
        keep_points: bool = False,
        threads: int = 0,
        mesh_points: int = MESH_POINTS,
    ) -> None:
        rows = _Rows.of(points, "points", normals, features, "", as_mesh_points(mesh_points))
        self._raw = _emtr.Preprocessed(rows.buffer(keep_points), "", thread_setting(threads))
        self._info: dict[str, Any] = self._raw.describe()
        self._options = {"keep_points": keep_points, "threads": threads}
        self._kept = rows.copied() if keep_points or len(rows.points) <= _ALWAYS_KEPT else None
        self._given = len(rows.points)

    @property
    def points(self) -> NDArray[Any]:
        """All points as they were given, those that were dropped too: float32 or float64 (N, 3),
        read-only; of a mesh those that were taken of it.

        Raises TypeError when they were not kept: a cloud of more than 200 000 points keeps them
        with ``keep_points=True``.
        """
        return self._rows().points

    def _rows(self) -> _Rows:
        if self._kept is None:
            raise TypeError(
                f"a pyemtr.Cloud of {self._given} points keeps them only if it is made with"
                " keep_points=True"
            )
        return self._kept

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (tuple(self._rows()), self._options)

    def __copy__(self) -> Cloud:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Cloud:
        return self

    def __len__(self) -> int:
        """The number of finite points."""
        return int(self._info["points"])

    @property
    def dropped(self) -> int:
        """The number of points dropped because of a NaN or an infinity."""
        return int(self._info["dropped"])

    @property
    def strays(self) -> int:
        """The number of finite points that are left out: far outside of all the others or, in a
        cloud of at most 3000 points, scattered off its surface."""
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

    @property
    def nbytes(self) -> int:
        """About how many bytes of memory it takes: the points that the library works with, with
        normals and features, and those that ``points`` gives."""
        info = self._info
        base = int(info["base_points"]) * (24 if info["normals"] else 12)
        found = int(info["keypoints"]) * (4 * int(info["feature_dimension"]) + 24)
        kept = 0
        if self._kept is not None:
            kept = sum(array.nbytes for array in self._kept if array is not None)
            kept += 12 * len(self) if len(self) > _ALWAYS_KEPT else 0
        left_out = 8 * len(self) if self.dropped or self.strays else 0
        return base + found + kept + left_out

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
    cloud: Any,
    name: str,
    normals: Any = None,
    features: Any = None,
    keep_points: bool = False,
    mesh_points: int = MESH_POINTS,
) -> _emtr.CloudBuffer | _emtr.Preprocessed:
    """Returns what the C library reads: a preprocessed cloud, or points with their normals and
    features. Raises TypeError when a :class:`Cloud` comes with normals or features beside it."""
    if not isinstance(cloud, Cloud):
        rows = _Rows.of(cloud, name, normals, features, f"{name}_", mesh_points)
        return rows.buffer(keep_points)
    for given, what in ((normals, "normals"), (features, "features")):
        if given is not None:
            raise TypeError(
                f"{name}_{what}: a pyemtr.Cloud has its own; give them to pyemtr.Cloud()"
            )
    return cloud._raw


class _Rows(NamedTuple):
    """A cloud's points, normals and features, one row a point."""

    points: NDArray[Any]
    normals: NDArray[Any] | None
    features: NDArray[np.float32] | None

    @classmethod
    def of(
        cls,
        points: Any,
        name: str,
        normals: Any,
        features: Any,
        prefix: str,
        mesh_points: int,
    ) -> _Rows:
        """Returns the arguments as arrays; errors call the points ``name``."""
        array = as_points(points, name, mesh_points)
        return cls(
            array,
            None if normals is None else as_normals(normals, f"{prefix}normals", array),
            None if features is None else as_features(features, f"{prefix}features", array),
        )

    def buffer(self, keep_points: bool) -> _emtr.CloudBuffer:
        return _emtr.CloudBuffer(*self, keep_points)

    def copied(self) -> _Rows:
        """Returns rows that refer to nobody's memory and cannot be changed."""
        normals = None if self.normals is None else _frozen(self.normals)
        features = None if self.features is None else _frozen(self.features)
        return _Rows(_frozen(self.points), normals, features)


def _frozen(rows: NDArray[Any]) -> NDArray[Any]:
    copied = rows.copy()
    copied.flags.writeable = False
    return copied


def _again(rows: tuple[Any, Any, Any], options: dict[str, Any]) -> Cloud:
    """Makes a cloud of what a pickle has."""
    points, normals, features = rows
    return Cloud(points, normals=normals, features=features, **options)
