"""Where pairs are worked on: threads of this process, or the executor that the user gave."""

from __future__ import annotations

import os
import queue
import threading
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from typing import Any, Protocol

from .cloud_cache import CloudCache
from .pair import Pair
from .record import Line
from .work import register_pairs

Done = tuple[Sequence[Pair], Any]


class Runner(Protocol):
    """Takes work and tells when it is done, in any order."""

    @property
    def window(self) -> int:
        """How many items of work it should have at once."""

    def submit(self, pairs: Sequence[Pair]) -> None: ...

    def next(self) -> list[Line]:
        """Waits for one item of work and returns its records. An exception that is no fault of a
        pair, as one of the executor, is raised."""

    def ready(self) -> bool:
        """Tells whether next() need not wait."""

    def finished(self) -> list[list[Line]]:
        """Returns what is done by now without an exception, and does not wait."""

    def close(self) -> None:
        """Ends what is not done yet."""


class ExecutorRunner:
    """Works by an executor of PEP 3148, which stays the user's."""

    def __init__(
        self, executor: Executor, settings: Mapping[str, Any], memory_limit: int, ahead: int
    ) -> None:
        self.executor = executor
        self._settings = dict(settings)
        self._memory_limit = memory_limit
        self._done: queue.SimpleQueue[Future[list[Line]]] = queue.SimpleQueue()
        self._running: set[Future[list[Line]]] = set()
        self._ahead = ahead
        self._stop = threading.Event()
        self._cache: CloudCache | None = None
        if isinstance(executor, ThreadPoolExecutor):  # the clouds are kept as long as the run
            self._cache = CloudCache(memory_limit)

    @property
    def window(self) -> int:
        return self._ahead

    def submit(self, pairs: Sequence[Pair]) -> None:
        arguments: tuple[Any, ...] = (list(pairs), self._settings, self._memory_limit)
        if self._cache is not None:
            arguments += (self._cache, self._stop.is_set)
        future = self.executor.submit(register_pairs, *arguments)
        self._running.add(future)
        future.add_done_callback(self._done.put)

    def next(self) -> list[Line]:
        future = self._done.get()
        self._running.discard(future)
        return future.result()

    def ready(self) -> bool:
        return not self._done.empty()

    def finished(self) -> list[list[Line]]:
        found: list[list[Line]] = []
        while True:
            try:
                future = self._done.get_nowait()
            except queue.Empty:
                return found
            self._running.discard(future)
            if not future.cancelled() and future.exception() is None:
                found.append(future.result())

    def close(self) -> None:
        self._stop.set()
        for future in self._running:
            future.cancel()


class ThreadRunner(ExecutorRunner):
    """Works by threads of its own."""

    def __init__(self, workers: int, settings: Mapping[str, Any], memory_limit: int) -> None:
        workers = workers or processors()
        pool = ThreadPoolExecutor(workers, thread_name_prefix="pyemtr")
        super().__init__(pool, settings, memory_limit, 2 * workers)

    def close(self) -> None:
        super().close()
        self.executor.shutdown(wait=True)


def processors() -> int:
    """Returns how many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def runner_of(
    executor: Any, workers: int, settings: Mapping[str, Any], memory_limit: int
) -> Runner:
    """Returns the runner for what the user gave as ``executor``.

    Raises TypeError for what is no executor, ValueError for ``workers`` beside one.
    """
    if executor is None:
        return ThreadRunner(workers, settings, memory_limit)
    if workers:
        raise ValueError("workers: an executor has its own number of them; leave it out")
    if hasattr(executor, "scatter") and hasattr(executor, "get_executor"):
        from .dask_runner import DaskRunner

        return DaskRunner(executor, settings, memory_limit)
    if not callable(getattr(executor, "submit", None)):
        raise TypeError(
            "executor: expected an executor of concurrent.futures or a dask.distributed.Client,"
            f" got {type(executor).__name__}"
        )
    known = getattr(executor, "_max_workers", None)
    return ExecutorRunner(
        executor, settings, memory_limit, 4 * (known if isinstance(known, int) else processors())
    )
