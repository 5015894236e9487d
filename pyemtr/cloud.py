"""One cloud, preprocessed once for many registrations."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _emtr
from .arrays import Floats, as_features, as_normals
from .colors import as_colors, as_intensity, brought_along
from .mesh import MESH_POINTS, as_mesh_points, mesh_of
from .options import thread_setting
from .points import as_points, opened

_ALWAYS_KEPT = 200_000  # points; the library keeps those of smaller clouds too


class Cloud:
    """Points that are read, measured and, above 200 000, downsampled: once for many registrations.

    :func:`pyemtr.register`, :class:`pyemtr.Problem` and the tasks take it in place of an array,
    as source or as target, and give the same bits::

        model = pyemtr.Cloud(points)
        results = [pyemtr.register(scan, model) for scan in scans]

    It never changes and does not refer to the caller's memory; threads may share it. It can be
    pickled, and is then preprocessed again where it is read, to the same bits.

    While it is one of the sixteen clouds of the process that were used last, it remembers what
    registrations made of it, such as features and fine surfaces: 5 to 15 MB. The next registration
    with the same settings beside a cloud of like size then takes some three fifths of the time.

    Args:
        points: as :func:`pyemtr.register` takes them: an array (N, 3) in any unit, a file, a mesh
            or an object with points.
        normals: (N, 3) or None, as ``source_normals`` of :func:`pyemtr.register`.
        features: (N, D) or None, as its ``source_features``.
        colors: (N, 3) or None, as its ``source_colors``.
        intensity: (N,) or None, as its ``source_intensity``.
        keep_points: keep all points of a cloud of more than 200 000: 12 bytes each, so that it can
            be registered with ``correspondences``, and the array as it was given, with normals,
            features and colors, for ``points`` and pickles. A smaller cloud always keeps them.
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
        colors: Any = None,
        intensity: Any = None,
        keep_points: bool = False,
        threads: int = 0,
        mesh_points: int = MESH_POINTS,
    ) -> None:
        beside = Beside(normals, features, colors, intensity)
        rows = _Rows.of(points, "points", beside, "", as_mesh_points(mesh_points))
        self._raw = _emtr.Preprocessed(rows.buffer(keep_points), "", thread_setting(threads))
        self._info: dict[str, Any] = self._raw.describe()
        self._options = {"keep_points": keep_points, "threads": threads}
        self._kept = rows.copied() if keep_points or len(rows.points) <= _ALWAYS_KEPT else None
        self._given = len(rows.points)
        self._colors = rows.colors is not None
        self._intensity = rows.intensity is not None

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
    def has_colors(self) -> bool:
        """True when it has colors, given or brought along."""
        return self._colors

    @property
    def has_intensity(self) -> bool:
        """True when it has intensities, given or brought along."""
        return self._intensity

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
        normals and features, and those that ``points`` gives; not what registrations made."""
        info = self._info
        parts = 1 + bool(info["normals"]) + (self._colors or self._intensity)
        base = int(info["base_points"]) * 12 * parts
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
        colors = ", colors" if self.has_colors else ""
        intensity = ", intensity" if self.has_intensity else ""
        features = f", {self.keypoints} features of {self._info['feature_dimension']}"
        return (
            f"<pyemtr.Cloud: {len(self)} points{dropped}{strays}{normals}"
            f"{colors}{intensity}{features if self.keypoints else ''}, radius {self.radius:.6g}>"
        )


class Beside(NamedTuple):
    """What the user provides beside a cloud, as it was given; None for none."""

    normals: Any = None
    features: Any = None
    colors: Any = None
    intensity: Any = None


def as_cloud(
    cloud: Any,
    name: str,
    beside: Beside | None = None,
    keep_points: bool = False,
    mesh_points: int = MESH_POINTS,
) -> _emtr.CloudBuffer | _emtr.Preprocessed:
    """Returns what the C library reads: a preprocessed cloud, or points with what is beside them.
    Raises TypeError when a :class:`Cloud` comes with something beside it."""
    if not isinstance(cloud, Cloud):
        return rows_of(cloud, name, beside or Beside(), mesh_points).buffer(keep_points)
    for what, given in (beside or Beside())._asdict().items():
        if given is not None:
            raise TypeError(
                f"{name}_{what}: a pyemtr.Cloud has its own; give them to pyemtr.Cloud()"
            )
    return cloud._raw


def rows_of(cloud: Any, name: str, beside: Beside, mesh_points: int) -> _Rows:
    """Returns a cloud's points with what is beside them; a :class:`Cloud` has its own, and raises
    TypeError where it did not keep them."""
    if isinstance(cloud, Cloud):
        return cloud._rows()
    return _Rows.of(cloud, name, beside, f"{name}_", mesh_points)


class _Rows(NamedTuple):
    """A cloud's points with normals, features, colors and intensities, one row a point."""

    points: NDArray[Any]
    normals: NDArray[Any] | None = None
    features: NDArray[np.float32] | None = None
    colors: NDArray[np.float32] | None = None
    intensity: NDArray[np.float32] | None = None

    @classmethod
    def of(cls, points: Any, name: str, beside: Beside, prefix: str, mesh_points: int) -> _Rows:
        """Returns the arguments as arrays; errors call the points ``name``."""
        cloud, title = opened(points, name)
        array = as_points(cloud, title, mesh_points)
        normals, features, colors, intensity = beside
        if colors is None and intensity is None and mesh_of(cloud, title) is None:
            colors, intensity = brought_along(cloud, title, len(array))
        else:
            colors = None if colors is None else as_colors(colors, f"{prefix}colors", len(array))
            if intensity is not None:
                intensity = as_intensity(intensity, f"{prefix}intensity", len(array))
        return cls(
            array,
            None if normals is None else as_normals(normals, f"{prefix}normals", array),
            None if features is None else as_features(features, f"{prefix}features", array),
            colors,
            intensity,
        )

    def buffer(self, keep_points: bool) -> _emtr.CloudBuffer:
        return _emtr.CloudBuffer(*self, keep_points)

    def copied(self) -> _Rows:
        """Returns rows that refer to nobody's memory and cannot be changed."""
        beside = (None if array is None else _frozen(array) for array in self[1:])
        return _Rows(_frozen(self.points), *beside)


def _frozen(rows: NDArray[Any]) -> NDArray[Any]:
    copied = rows.copy()
    copied.flags.writeable = False
    return copied


def _again(rows: tuple[Any, ...], options: dict[str, Any]) -> Cloud:
    """Makes a cloud of what a pickle has."""
    points, normals, features, colors, intensity = rows
    plain = None if intensity is None else intensity.reshape(-1)
    return Cloud(
        points, normals=normals, features=features, colors=colors, intensity=plain, **options
    )
