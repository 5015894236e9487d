"""Registration of two clouds in one call."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _emtr
from .inputs import Inputs
from .mesh import MESH_POINTS
from .progress import Callback, as_raw_callback
from .result import Result, make_result

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .setting_types import MethodSettings


def register(
    source: Any,
    target: Any,
    *,
    seed: int = 0,
    threads: int = 0,
    preset: str = "default",
    guess: Any = None,
    source_viewpoint: Any = None,
    target_viewpoint: Any = None,
    axis: Any = None,
    translation_bounds: Any = None,
    source_normals: Any = None,
    target_normals: Any = None,
    source_features: Any = None,
    target_features: Any = None,
    source_colors: Any = None,
    target_colors: Any = None,
    source_intensity: Any = None,
    target_intensity: Any = None,
    correspondences: Any = None,
    mesh_points: int = MESH_POINTS,
    callback: Callback | None = None,
    **settings: Unpack[MethodSettings],
) -> Result:
    """Registers two partially overlapping clouds by EMTR-SSC, from any starting pose.

    The same clouds and seed give the same bits, for any number of threads. The GIL is released
    while the library works.

    Args:
        source: points (N, 3) in any unit: an array of any real dtype, byte order and strides, or
            nested lists; homogeneous coordinates (N, 4) whose last column is 1 throughout; a table
            with columns x, y and z (DataFrame, structured array); an object with ``.points`` or
            ``.vertices`` (clouds of Open3D, trimesh, small_gicp); a file (NPY, NPZ, text, OBJ, OFF,
            STL, with ``pip install 'pyemtr[files]'`` PLY, PCD and LAS, with ``[e57]`` E57; each
            perhaps with .gz); or a mesh, which is taken as a surface. float32 and float64 rows are
            read in place; anything else is copied once. Points with a NaN or an infinity (or masked
            ones) are dropped and counted. Use a :class:`pyemtr.Cloud` for points that are
            registered more than once: they are then read once.
        target: points (M, 3), likewise.
        seed: 0 <= seed < 2**64.
        threads: 0 for as many as OpenMP would use; the result does not depend on it.
        preset: one of :func:`pyemtr.presets`; "paper" is the method as published.
        guess: (4, 4), source into target, in the clouds' unit, or a result that has one. It is
            tried as one hypothesis; the search does not stay near it unless the settings
            ``guess_rotation`` (degrees) or ``guess_translation`` (the clouds' unit, of the source's
            centroid) say how near.
        source_viewpoint: (3,), the position of the source's sensor, in the source's own frame and
            unit. It tells candidates apart: no surface lies in front of what the sensor saw.
            None when not known; it is then estimated where it is needed.
        target_viewpoint: (3,), likewise for the target, in the target's frame and unit.
        axis: (3,), a direction that is the same in both clouds' frames, such as up for leveled
            scanners: only rotations about it are admitted. Settings: ``axis_tilt``,
            ``axis_angle_minimum``, ``axis_angle_maximum`` (degrees).
        translation_bounds: (2, 3), smallest and largest translation of the resulting matrix, in
            the clouds' unit. All priors, ``maximum_rotation`` (degrees) included, hold at once for
            the transformation and for the alternatives.
        source_normals: (N, 3), user-provided normals of the source's points, used in place of
            estimated ones. They may have any length; NaN or zero marks a point without a normal.
            Where both clouds have normals, their direction counts. An object's ``.normals`` are
            not used by themselves.
        target_normals: (M, 3), likewise for the target.
        source_features: (N, D), user-provided descriptors of the source's points. Mutual nearest
            neighbors by Euclidean distance become correspondences, in place of those by FPFH. NaN
            marks a point without a descriptor. Used as float32; give both clouds' or none, with
            the same D.
        target_features: (M, D), likewise for the target.
        source_colors: (N, 3), red, green and blue of the source's points: whole numbers from 0 to
            255 (65535 if they are uint16), or real ones from 0 to 1; NaN for a point without a
            color. None takes what the cloud brings along: the colors of a file or of an object with
            ``.colors``, of a table's columns red, green and blue (or r, g and b). The setting
            ``use_colors`` says what they are used for.
        target_colors: (M, 3), likewise for the target.
        source_intensity: (N,), what the source's sensor received of each point, not below 0, in
            any unit; NaN for none. Used as colors are, where the clouds have no colors. None takes
            the column or field ``intensity`` of the cloud.
        target_intensity: (M,), likewise for the target.
        correspondences: (K, 2) integers, rows of source and target that show the same place; many
            may be wrong. They replace feature matching. At least 3 different ones are needed; of
            more than ``max_correspondences``, that many are used, evenly spaced over the list.
        mesh_points: how many points are spread evenly over the surface of a mesh, the same every
            time; its vertices play no part. 0 takes the vertices instead.
        callback: called with a :class:`pyemtr.Progress` before each stage, after each iteration,
            and again about every 20 ms while a stage lasts, with the same progress. Return True to
            stop the run: the result then has the reason "interrupted" and the best pose so far. An
            exception stops the run and reaches the caller. The callback may register clouds itself.
            Ctrl-C is checked as often, with or without a callback.
        **settings: any of :func:`pyemtr.settings` by name.

    Returns:
        A :class:`pyemtr.Result`, whether registered or not; its ``transformation`` maps source
        into target, q = R p + t.

    Raises:
        TypeError: an argument of a wrong type, an unknown setting.
        ValueError: a wrong shape, a value out of range, a correspondence of points that do not
            exist or are not finite, a cloud that cannot be registered (fewer than 10 finite
            points, all on one point or one line), priors that contradict each other, a file of no
            known format or with wrong content.
        OSError: a file that cannot be read.
        ImportError: the package that reads files of that format is not installed.
        MemoryError: an allocation failed.
        RuntimeError: a defect of the library.
    """
    inputs = Inputs.among(locals())
    chosen = inputs.settings(settings)
    used = inputs.used(chosen)
    raw_callback = as_raw_callback(callback, used)
    raw = _emtr.register(*inputs.clouds(source, target), chosen, raw_callback)
    return make_result(raw, used)
