"""Clouds in memory that come again, so that they are preprocessed once."""

from __future__ import annotations

import os
import pickle
import uuid
from collections import OrderedDict
from dataclasses import replace
from typing import Any

from .pair import Pair


class Shared:
    """A cloud in memory, by a token that no other cloud of the run has: it is found by that token
    wherever it was preprocessed before. In another process it is unpacked only if it was not."""

    def __init__(self, token: str, cloud: Any) -> None:
        self.token = token
        self._cloud = cloud
        self._packed: bytes | None = None

    @property
    def is_packed(self) -> bool:
        """True in another process, before the cloud was asked for."""
        return self._cloud is None and self._packed is not None

    @property
    def cloud(self) -> Any:
        if self._packed is not None and self._cloud is None:
            self._cloud = pickle.loads(self._packed)
            self._packed = None
        return self._cloud

    def without_cloud(self) -> Shared:
        """Returns the token alone, for a cloud that comes another way."""
        return Shared(self.token, None)

    def __reduce__(self) -> tuple[Any, ...]:
        if self._packed is None and self._cloud is not None:
            self._packed = pickle.dumps(self._cloud, protocol=pickle.HIGHEST_PROTOCOL)
        return _packed, (self.token, self._packed)


def _packed(token: str, packed: bytes | None) -> Shared:
    shared = Shared(token, None)
    shared._packed = packed
    return shared


class Sharing:
    """Names the clouds of a run that are no files. The same object has the same token. Only the
    last ``limit`` objects are remembered, all of them for None."""

    def __init__(self, limit: int | None) -> None:
        self._limit = limit
        self._run = uuid.uuid4().hex
        self._count = 0
        self._known: OrderedDict[int, Shared] = OrderedDict()  # by id; each keeps its object alive

    def share(self, pair: Pair) -> Pair:
        """Returns the pair with absolute paths, and :class:`Shared` for clouds in memory."""
        return replace(pair, source=self._shared(pair.source), target=self._shared(pair.target))

    def _shared(self, cloud: Any) -> Any:
        if isinstance(cloud, (str, os.PathLike)):
            return os.path.abspath(os.fsdecode(cloud))  # workers may be in another folder
        known = self._known.get(id(cloud))
        if known is None:
            known = self._known[id(cloud)] = Shared(f"{self._run}-{self._count}", cloud)
            self._count += 1
        self._known.move_to_end(id(cloud))
        if self._limit is not None and len(self._known) > self._limit:
            self._known.popitem(last=False)
        return known
