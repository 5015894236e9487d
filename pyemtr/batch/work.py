"""The work on pairs, wherever it is done: in a thread, in another process, on another machine."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

from ..cloud import Cloud
from ..mesh import MESH_POINTS, as_mesh_points
from ..registration import register
from .cloud_cache import CloudCache
from .pages import PairPage, page_of_pair, shown_cloud
from .pair import Pair
from .record import Line, arguments_of, as_line, error_record, result_of, result_record
from .shared import Shared

# They belong to one registration, so that its clouds are read for it alone.
_OF_POINTS = (
    "source_normals",
    "target_normals",
    "source_features",
    "target_features",
    "correspondences",
)
# Faults of a pair; any other exception stops the whole run.
_FAULTS = (TypeError, ValueError, OSError, MemoryError, RuntimeError)


class Stopped(Exception):
    """The run is to end, and the pair is not recorded."""


@lru_cache(maxsize=1)
def process_cache(limit: int) -> CloudCache:
    """The cache of this process, for executors whose workers are processes."""
    return CloudCache(limit)


def register_pairs(
    pairs: Sequence[Pair],
    settings: Mapping[str, Any],
    memory_limit: int,
    cache: CloudCache | None = None,
    stopped: Callable[[], bool] | None = None,
    scattered: Mapping[str, Any] | None = None,
) -> list[Line]:
    """Registers the pairs and returns their records, one line each.

    Args:
        settings: keyword arguments of :func:`pyemtr.register` for pairs that have no others.
        cache: where clouds are kept; None for the cache of this process.
        stopped: tells whether to stop, asked as the callback of a registration is.
        scattered: clouds by the token of a :class:`Shared` that came without its cloud.

    Raises:
        Stopped: it was told to stop.
        ImportError: the package that reads a file is not installed.
    """
    cache = process_cache(memory_limit) if cache is None else cache
    return [_record(pair, settings, cache, stopped, scattered or {}) for pair in pairs]


def page_of_recorded(
    pair: Pair,
    record: Mapping[str, Any],
    cache: CloudCache,
    scattered: Mapping[str, Any] | None = None,
) -> PairPage:
    """Makes the page of a pair that was registered before.

    Raises TypeError, ValueError, OSError or ImportError when a cloud cannot be read.
    """
    arguments = arguments_of(record)
    clouds = _clouds(pair, arguments, cache, scattered or {})
    result = result_of(record)
    assert result is not None  # a record with an error has no page
    return page_of_pair(pair, record, result, _shown(pair, clouds))


def _record(
    pair: Pair,
    settings: Mapping[str, Any],
    cache: CloudCache,
    stopped: Callable[[], bool] | None,
    scattered: Mapping[str, Any],
) -> Line:
    if stopped is not None and stopped():
        raise Stopped
    if pair.record is not None:
        page = page_of_recorded(pair, pair.record, cache, scattered)
        return replace(as_line(pair.record), page=page, is_new=False)
    arguments = {**settings, **pair.settings}
    try:
        source, target = _clouds(pair, arguments, cache, scattered)
        callback = None if stopped is None else (lambda _: stopped())
        result = register(source, target, callback=callback, **arguments)
    except _FAULTS as error:
        return as_line(error_record(pair, error))
    if result.reason == "interrupted":
        raise Stopped
    record = result_record(pair, str(arguments.get("preset", "default")), result)
    if not pair.page:
        return as_line(record)
    page = page_of_pair(pair, record, result, _shown(pair, (source, target)))
    return replace(as_line(record), page=page)


def _clouds(
    pair: Pair, arguments: Mapping[str, Any], cache: CloudCache, scattered: Mapping[str, Any]
) -> tuple[Any, Any]:
    count = as_mesh_points(arguments.get("mesh_points", MESH_POINTS))
    whole = any(arguments.get(name) is not None for name in _OF_POINTS)
    return (
        _cloud(pair.source, "source", count, whole, cache, scattered),
        _cloud(pair.target, "target", count, whole, cache, scattered),
    )


def _shown(pair: Pair, clouds: tuple[Any, Any]) -> tuple[Any, Any]:
    return shown_cloud(pair.source, clouds[0]), shown_cloud(pair.target, clouds[1])


def _cloud(
    cloud: Any,
    role: str,
    mesh_points: int,
    whole: bool,
    cache: CloudCache,
    scattered: Mapping[str, Any],
) -> Any:
    """Returns what is registered: a preprocessed cloud, or the user's own where ``whole``."""
    key: Any
    if isinstance(cloud, Shared):
        key, shared = cloud.token, cloud
        if not shared.is_packed or whole:
            cloud = scattered.get(shared.token, shared.cloud)
    else:
        key = cloud  # a path
    if whole or isinstance(cloud, Cloud):
        return cloud

    def make() -> Cloud:
        points = cloud.cloud if isinstance(cloud, Shared) else cloud
        if isinstance(points, Cloud):
            return points
        return Cloud(points, threads=1, mesh_points=mesh_points)

    try:
        return cache.get((key, mesh_points), make)
    except (TypeError, ValueError) as error:
        text = str(error)
        raise type(error)(f"{role}: {text.removeprefix('points: ')}") from error
