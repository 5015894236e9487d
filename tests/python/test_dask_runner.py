"""What is done about work that a Dask cluster lost, with a cluster that loses on demand."""

from __future__ import annotations

import gc
import json
import weakref
from concurrent.futures import CancelledError, Future
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from many_pairs import comparable, run, surface, write_clouds

A, B = surface(1), surface(2)


class KilledWorker(Exception):
    """As Dask raises it, which is told by its name."""


class Client:
    """Works at once, and fails as often as it is told."""

    status = "running"

    def __init__(self, *failures: BaseException) -> None:
        self.failures = list(failures)
        self.submitted: list[str] = []
        self.futures: list[weakref.ref[Any]] = []
        self.scattered = 0
        self.scheduler = SimpleNamespace(address="tcp://nowhere:1")

    def get_executor(self) -> None:
        raise AssertionError("futures are used directly")

    def nthreads(self) -> dict[str, int]:
        return {"worker": 1}

    def scatter(self, cloud: Any, hash: bool) -> Any:
        self.scattered += 1
        done: Any = Future()
        done.status, done.cloud = "finished", cloud
        return done

    def cancel(self, futures: list[Any], force: bool) -> None:
        pass

    def submit(self, work: Any, *arguments: Any, scattered: dict, key: str, pure: bool) -> Any:
        self.submitted.append(key)
        done: Any = Future()
        done.key = key
        self.futures.append(weakref.ref(done))
        if self.failures:
            done.set_exception(self.failures.pop(0))
        else:
            clouds = {token: one.cloud for token, one in scattered.items()}
            done.set_result(work(*arguments, scattered=clouds))
        return done


def test_lost_work_is_done_again_and_lost_clouds_are_sent_again() -> None:
    client = Client(CancelledError(), KilledWorker())
    assert comparable(run([(A, B)], client)) == comparable(run([(A, B)]))
    assert [key.rsplit("-", 1)[1] for key in client.submitted] == ["1", "2", "3"]
    assert client.scattered == 6


def test_no_result_is_kept_by_the_exception_of_lost_work() -> None:
    """Dask keeps the exception, which the frames that raised it would hang on."""
    lost = CancelledError()
    client = Client(lost)
    gc.disable()
    try:
        run([(A, B, {"seed": seed}) for seed in range(3)], client)
        assert len(client.futures) == 4 and [future() for future in client.futures] == [None] * 4
    finally:
        gc.enable()


def test_a_cloud_in_memory_is_sent_once() -> None:
    client = Client()
    run([(A, B, {"seed": seed}) for seed in range(4)], client)
    assert client.scattered == 2 and len(client.submitted) == 4


def test_pairs_that_kill_their_workers_are_recorded(tmp_path: Path) -> None:
    names = [str(tmp_path / name) for name in write_clouds(tmp_path, 2)]
    client = Client(*[KilledWorker()] * 3)
    records = run([(names[0], names[1])], client, out=tmp_path / "out")
    assert records.counts["error"] == 1 and "each worker that had it died" in records[0].error
    assert json.loads((tmp_path / "out" / "results.jsonl").read_text())["index"] == 0


def test_what_is_no_loss_ends_the_run() -> None:
    with pytest.raises(ImportError, match="plyfile"):
        run([(A, B)], Client(ImportError("plyfile")))
    with pytest.raises(CancelledError):
        run([(A, B)], Client(*[CancelledError()] * 3))


def test_a_client_that_is_closed_or_asynchronous() -> None:
    client = Client(CancelledError())
    client.status = "closed"
    with pytest.raises(ConnectionError, match="the Dask scheduler at tcp://nowhere:1 is gone"):
        run([(A, B)], client)
    client.asynchronous = True
    with pytest.raises(TypeError, match="asynchronous"):
        run([(A, B)], client)
