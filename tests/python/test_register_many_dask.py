"""register_many() on a real Dask cluster of worker processes, some of which are killed."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from children import environment
from many_pairs import comparable, run, surface, write_clouds

import pyemtr

distributed = pytest.importorskip("distributed", reason="pip install 'pyemtr[dask]'")


class Cluster:
    """A scheduler and workers, each a process of its own."""

    def __init__(self, folder: Path, workers: int) -> None:
        self._folder = folder
        file = folder / "scheduler.json"
        self.scheduler = self._start(
            "distributed.cli.dask_scheduler",
            ["--scheduler-file", str(file), "--port", "0", "--no-dashboard", "--host", "127.0.0.1"],
        )
        self.workers = [
            self._start(
                "distributed.cli.dask_worker",
                ["--scheduler-file", str(file), "--no-nanny", "--nthreads", "1", "--no-dashboard"],
            )
            for _ in range(workers)
        ]
        self.client = distributed.Client(scheduler_file=str(file), timeout=60)
        self.client.wait_for_workers(workers, timeout=120)

    def _start(self, module: str, arguments: list[str]) -> subprocess.Popen[bytes]:
        return subprocess.Popen(
            [sys.executable, "-m", module, *arguments],
            cwd=self._folder,
            env={**environment(), "DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "3s"},
            stderr=subprocess.DEVNULL,
        )

    def close(self) -> None:
        self.client.close(timeout=2)
        for process in [*self.workers, self.scheduler]:
            process.kill()
            process.wait()


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Cluster]:
    """The first test loses one of its two workers, and the second the scheduler."""
    started = Cluster(tmp_path_factory.mktemp("dask"), 2)
    yield started
    started.close()


def pairs_in(folder: Path, count: int) -> list[tuple]:
    names = [str(folder / name) for name in write_clouds(folder, 3)]
    model, scan = pyemtr.Cloud(surface(7)), surface(8)
    clouds = [*names, model, scan]
    return [(clouds[i % 5], clouds[(i + 1) % 5], {"seed": i}) for i in range(count)]


def when_recorded(file: Path, records: int, act) -> threading.Thread:
    """Starts a thread that acts once the file has so many records."""

    def wait() -> None:
        end = time.monotonic() + 60
        while time.monotonic() < end:
            if file.is_file() and file.read_bytes().count(b"\n") >= records:
                act()
                return
            time.sleep(0.005)

    thread = threading.Thread(target=wait)
    thread.start()
    return thread


def test_a_killed_worker_costs_no_result(cluster: Cluster, tmp_path: Path) -> None:
    pairs = pairs_in(tmp_path, 24)
    out = tmp_path / "out"
    killer = when_recorded(out / "results.jsonl", 5, cluster.workers[0].kill)
    records = run(pairs, cluster.client, out=out)
    killer.join()
    assert cluster.workers[0].wait(10) == -signal.SIGKILL
    assert records.counts["error"] == 0
    assert comparable(out / "results.jsonl") == comparable(run(pairs))


def test_a_dead_scheduler_is_told_and_the_run_is_taken_up(cluster: Cluster, tmp_path: Path) -> None:
    pairs = pairs_in(tmp_path, 20)
    out = tmp_path / "out"
    killer = when_recorded(out / "results.jsonl", 3, cluster.scheduler.kill)
    with pytest.raises(ConnectionError, match=r"the Dask scheduler at tcp://\S+ is gone"):
        run(pairs, cluster.client, out=out)
    killer.join()
    assert 3 <= len(comparable(out / "results.jsonl")) < 20
    again = run(pairs, out=out)
    assert comparable(again) == comparable(run(pairs))
