"""One call from two clouds to a pose."""

from __future__ import annotations

from typing import Any

from . import _emtr
from .cloud import as_cloud
from .options import Value, make_settings, settings_used, take_correspondences
from .progress import Callback, as_raw_callback
from .result import Result, make_result


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
    correspondences: Any = None,
    callback: Callback | None = None,
    **settings: Value,
) -> Result:
    """Registers two partially overlapping clouds by EMTR-SSC, from any starting pose.

    The same clouds and seed give the same bits, for any number of threads. The GIL is released
    while the library works.

    Args:
        source: points (N, 3) in any unit: an array of any real dtype, byte order and strides,
            nested lists, or an object with ``.points`` (an Open3D cloud). float32 and float64
            rows are read in place, all else is copied once. Points with a NaN or an infinity
            (or masked ones) are dropped and counted. A :class:`pyemtr.Cloud` spares the reading
            of points that are registered more than once.
        target: likewise, (M, 3).
        seed: 0 <= seed < 2**64.
        threads: 0 for as many as OpenMP would use; the result does not depend on it.
        preset: one of :func:`pyemtr.presets`; "paper" is the method as published.
        guess: (4, 4), source into target, in the clouds' unit: tried as one hypothesis, not a
            place that the search stays near, unless the settings ``guess_rotation`` (degrees) or
            ``guess_translation`` (the clouds' unit, of the source's centroid) say how near.
        source_viewpoint: (3,), where the sensor stood that took the source, in the source's own
            frame and unit. What it saw tells candidates apart: no surface is in front of it.
            None when not known; it is then estimated where it is needed.
        target_viewpoint: (3,), likewise of the target, in the target's frame and unit.
        axis: (3,), a direction that is the same in both clouds' frames, up for scanners that know
            where down is: only rotations about it. Settings: ``axis_tilt``,
            ``axis_angle_minimum``, ``axis_angle_maximum`` (degrees).
        translation_bounds: (2, 3), least and largest translation of the resulting matrix, in the
            clouds' unit. These priors and the setting ``maximum_rotation`` (degrees) hold for the
            transformation and the alternatives, all at once.
        source_normals: (N, 3), normals of the source's points, used instead of estimating them. Of
            any length; NaN or zero where a point has none. Where both clouds have some, the side
            that they point to counts. What an object has in ``.normals`` is not used by itself.
        target_normals: (M, 3), likewise of the target.
        source_features: (N, D), descriptors of the source's points, computed elsewhere: the mutual
            nearest neighbors by Euclidean distance are matched, instead of those by FPFH. NaN
            where a point has none. Used as float32; both clouds or none, of one D.
        target_features: (M, D), likewise of the target.
        correspondences: (K, 2) of whole numbers, rows of source and target held to be the same
            place, many of which may be wrong: taken instead of any matching. At least 3 different
            ones; of more than ``max_correspondences`` so many, evenly spread over the list.
        callback: called with a :class:`pyemtr.Progress` before each stage, after each
            iteration, and again about every 20 ms while a stage lasts, with the same progress.
            Return True to stop: the result then has the reason "interrupted" and the best pose
            so far. What it raises stops the run and reaches the caller. Ctrl-C is looked at as
            often, with or without a callback. It may register clouds itself.
        **settings: any of :func:`pyemtr.settings` by name.

    Returns:
        A :class:`pyemtr.Result`, whether registered or not; its ``transformation`` maps source
        into target, q = R p + t.

    Raises:
        TypeError: an argument of a wrong type, an unknown setting.
        ValueError: a wrong shape, a value out of range, a correspondence of points that there are
            not or that are not finite, a cloud that cannot be registered
            (fewer than 10 finite points, all on one point or one line), priors that
            contradict each other.
        MemoryError: an allocation failed.
        RuntimeError: a defect of the library.
    """
    chosen = make_settings(
        seed,
        threads,
        preset,
        guess,
        settings,
        source_viewpoint,
        target_viewpoint,
        axis,
        translation_bounds,
    )
    keep = take_correspondences(chosen, correspondences)
    raw = _emtr.register(
        as_cloud(source, "source", source_normals, source_features, keep),
        as_cloud(target, "target", target_normals, target_features, keep),
        chosen,
        as_raw_callback(callback),
    )
    return make_result(raw, settings_used(chosen))
