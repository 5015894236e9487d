"""One pair of many, and the pairs that an iterable gives."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Pair:
    """What is to be registered, and how it is called in its record.

    ``source`` and ``target`` are anything that :func:`pyemtr.register` takes. ``source_text`` and
    ``target_text`` are their paths as the user wrote them, None for clouds that are no files.
    ``settings`` are keyword arguments of :func:`pyemtr.register` that this pair has beside those
    of all pairs. With ``page`` a page of the pair is made too, and from ``record`` that alone, of a
    pair that was registered before.
    """

    index: int
    name: str | None
    source: Any
    target: Any
    source_text: str | None
    target_text: str | None
    settings: Mapping[str, Any] = field(default_factory=dict)
    page: bool = False
    record: Mapping[str, Any] | None = None


def pairs_of(items: Iterable[Any]) -> Iterator[Pair]:
    """The pairs of an iterable, which is read as they are asked for.

    Raises TypeError for an item that is no pair.
    """
    for index, item in enumerate(items):
        yield _pair(index, item)


def _pair(index: int, item: Any) -> Pair:
    if isinstance(item, Mapping):
        rest = dict(item)
        try:
            source, target = rest.pop("source"), rest.pop("target")
        except KeyError as error:
            raise TypeError(f"pairs[{index}]: a dict without {error}") from None
        return _checked(index, source, target, rest.pop("name", None), rest)
    if isinstance(item, (str, bytes)) or not hasattr(item, "__len__") or not 2 <= len(item) <= 4:
        raise TypeError(
            f"pairs[{index}]: expected (source, target), with a name and a dict of settings behind"
            f" them if there are any, got {_shown(item)}"
        )
    source, target, *rest = item
    name = rest.pop(0) if rest and not isinstance(rest[0], Mapping) else None
    settings = rest.pop(0) if rest else {}
    if rest or not isinstance(settings, Mapping):
        raise TypeError(f"pairs[{index}]: expected a name and then a dict of settings")
    return _checked(index, source, target, name, dict(settings))


def _checked(index: int, source: Any, target: Any, name: Any, settings: dict[str, Any]) -> Pair:
    if name is not None and not isinstance(name, str):
        raise TypeError(f"pairs[{index}]: name: expected a string, got {type(name).__name__}")
    return Pair(index, name, source, target, _path(source), _path(target), settings)


def _path(cloud: Any) -> str | None:
    return os.fsdecode(cloud) if isinstance(cloud, (str, os.PathLike)) else None


def _shown(item: Any) -> str:
    kind = type(item).__name__
    return f"a {kind} of {len(item)}" if hasattr(item, "__len__") else f"a {kind}"
