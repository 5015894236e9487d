"""Preprocessed clouds, each made once and kept within a limit of memory."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Hashable
from concurrent.futures import Future

from ..cloud import Cloud


class CloudCache:
    """Any number of threads may ask. While one makes a cloud, others that want it wait for it, and
    those that want another cloud do not. Beyond ``limit`` bytes the clouds that were not asked for
    the longest are dropped; whoever works with one still has it."""

    def __init__(self, limit: int) -> None:
        self.limit = limit
        self.made = 0  # how many clouds were read and preprocessed
        self._lock = threading.Lock()
        self._clouds: OrderedDict[Hashable, Future[Cloud]] = OrderedDict()
        self._bytes = 0

    def get(self, key: Hashable, make: Callable[[], Cloud]) -> Cloud:
        """Returns the cloud of that key. An error of ``make`` reaches all who wait for the cloud,
        and is forgotten then."""
        with self._lock:
            cloud = self._clouds.get(key)
            mine = cloud is None
            if cloud is None:
                cloud = self._clouds[key] = Future()
            self._clouds.move_to_end(key)
        if mine:
            self._make(key, cloud, make)
        return cloud.result()

    def clear(self) -> None:
        """Forgets all clouds that are there."""
        with self._lock:
            self._drop(0)

    @property
    def bytes(self) -> int:
        """The memory of the clouds that are kept, as :attr:`pyemtr.Cloud.nbytes` estimates it."""
        return self._bytes

    def _make(self, key: Hashable, promise: Future[Cloud], make: Callable[[], Cloud]) -> None:
        try:
            made = make()
        except BaseException as error:  # noqa: BLE001 - those who wait get it, whatever it is
            with self._lock:
                del self._clouds[key]
            promise.set_exception(error)
            return
        with self._lock:
            self.made += 1
            self._bytes += made.nbytes
            promise.set_result(made)
            self._drop(self.limit)

    def _drop(self, limit: int) -> None:
        for key in [key for key, cloud in self._clouds.items() if cloud.done()]:
            if self._bytes <= limit:
                return
            self._bytes -= self._clouds.pop(key).result().nbytes
