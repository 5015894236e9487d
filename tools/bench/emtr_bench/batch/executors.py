"""The executors that are compared."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from typing import Any


@contextlib.contextmanager
def executor(kind: str, workers: int, begin: Callable[[], Any]) -> Iterator[Any]:
    """An executor whose workers have imported pyemtr and called ``begin``."""
    if kind == "threads":
        begin()
        with ThreadPoolExecutor(workers) as pool:
            yield pool
    elif kind == "processes":
        context = get_context("spawn")
        with ProcessPoolExecutor(workers, mp_context=context, initializer=begin) as pool:
            for _ in pool.map(_wait, [0.2] * workers):  # until each has started
                pass
            yield pool
    else:
        with cluster(workers) as client:
            client.run(begin)
            yield client


@contextlib.contextmanager
def cluster(workers: int) -> Iterator[Any]:
    """A client of a Dask cluster of processes on this machine, with one thread each."""
    from distributed import Client, LocalCluster

    with LocalCluster(
        n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None
    ) as local, Client(local) as client:  # fmt: skip
        client.wait_for_workers(workers)
        yield client


def nothing() -> None:
    import pyemtr  # noqa: F401 - imported before the clock runs


def _wait(seconds: float) -> None:
    import time

    time.sleep(seconds)
