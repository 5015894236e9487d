"""Work by the workers of a Dask cluster."""

from __future__ import annotations

import contextlib
import queue
import uuid
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from concurrent.futures import CancelledError
from typing import Any

from .pair import Pair
from .record import Line, as_line, error_record
from .shared import Shared
from .work import register_pairs

_ATTEMPTS = 3  # of one item of work whose workers or whose data were lost
_KILLED = "each worker that had it died; is there enough memory?"
_LEAST_AHEAD = 1000  # so that an adaptive cluster sees that there is work
_SCATTERED = 64  # clouds in memory that the cluster keeps for this run


class DaskRunner:
    """Submits to a ``dask.distributed.Client``, which stays the user's.

    Files are read by the workers, each once a worker process. A cloud in memory is sent once, and
    again where the only worker that had it died. Work whose worker died is done again.
    """

    def __init__(self, client: Any, settings: Mapping[str, Any], memory_limit: int) -> None:
        if getattr(client, "asynchronous", False):
            raise TypeError("executor: an asynchronous Client cannot be used, expected a plain one")
        self._client = client
        self._settings = dict(settings)
        self._memory_limit = memory_limit
        self._run = uuid.uuid4().hex[:12]
        self._done: queue.SimpleQueue[Any] = queue.SimpleQueue()
        self._work: dict[str, tuple[Sequence[Pair], int]] = {}  # by the key of its future
        self._futures: dict[str, Any] = {}
        self._sent: OrderedDict[str, Any] = OrderedDict()
        self._address = client.scheduler.address if client.scheduler is not None else "?"

    @property
    def window(self) -> int:
        threads: int = sum(self._client.nthreads().values())
        return max(_LEAST_AHEAD, 4 * threads)

    def submit(self, pairs: Sequence[Pair]) -> None:
        self._submit(pairs, 1)

    def next(self) -> list[Line]:
        while True:
            future = self._done.get()
            pairs, attempt = self._work.pop(future.key)
            del self._futures[future.key]
            try:
                lines: list[Line] = future.result()
                return lines
            except BaseException as error:
                self._check_cluster(error)
                killed = type(error).__name__ == "KilledWorker"
                if not killed and not isinstance(error, CancelledError):
                    raise
                if attempt == _ATTEMPTS:
                    if killed:  # by the pairs themselves, it seems
                        return [
                            as_line(error_record(pair, RuntimeError(_KILLED))) for pair in pairs
                        ]
                    raise
                # Dask keeps the exception. Its traceback has this frame, and this frame a future
                # that is done later, whose result would stay on the cluster as long.
                error.__traceback__ = None
                self._sent.clear()  # some of it may be what was lost
                self._submit(pairs, attempt + 1)

    def ready(self) -> bool:
        return not self._done.empty()

    def finished(self) -> list[list[Line]]:
        found = []
        with contextlib.suppress(queue.Empty):
            while True:
                future = self._done.get_nowait()
                if future.status == "finished":
                    with contextlib.suppress(CancelledError, OSError):
                        found.append(future.result())
        return found

    def close(self) -> None:
        if self._futures and self._client.status == "running":
            self._client.cancel(list(self._futures.values()), force=True)
        self._sent.clear()
        self._futures.clear()
        with contextlib.suppress(queue.Empty):
            while True:  # each keeps its result on the cluster as long as it is referred to
                self._done.get_nowait()

    def _submit(self, pairs: Sequence[Pair], attempt: int) -> None:
        sent, scattered = [], {}
        for pair in pairs:
            roles = {}
            for role in ("source", "target"):
                cloud = getattr(pair, role)
                if isinstance(cloud, Shared):
                    scattered[cloud.token] = self._scatter(cloud)
                    roles[role] = cloud.without_cloud()
            sent.append(_with(pair, roles))
        key = f"emtr-pairs-{self._run}-{pairs[0].index}-{attempt}"
        try:
            future = self._client.submit(
                register_pairs,
                sent,
                self._settings,
                self._memory_limit,
                scattered=scattered,
                key=key,
                pure=False,
            )
        except BaseException as error:
            self._check_cluster(error)
            raise
        self._work[key] = (pairs, attempt)
        self._futures[key] = future
        future.add_done_callback(self._done.put)

    def _scatter(self, shared: Shared) -> Any:
        """Returns the future of a cloud that the cluster has; sends it when it has it not."""
        future = self._sent.get(shared.token)
        if future is None or future.status in ("cancelled", "error", "lost"):
            future = self._client.scatter(shared.cloud, hash=False)
            self._sent[shared.token] = future
        self._sent.move_to_end(shared.token)
        if len(self._sent) > _SCATTERED:
            self._sent.popitem(last=False)
        return future

    def _check_cluster(self, error: BaseException) -> None:
        """Raises ConnectionError when the scheduler is no more."""
        lost = isinstance(error, OSError) and "omm" in type(error).__name__
        if lost or self._client.status != "running":
            raise ConnectionError(
                f"the Dask scheduler at {self._address} is gone. What was recorded stays; run"
                " again with a new client to go on"
            ) from error


def _with(pair: Pair, clouds: Mapping[str, Any]) -> Pair:
    return Pair(**{**vars(pair), **clouds})
