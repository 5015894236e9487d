"""A process for each method, so that a crash of one costs a run and nothing else."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import tempfile
import time
import traceback
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import numpy as np

from .methods import Array, Method, Task

START_LIMIT = 120.0  # seconds to import the libraries and to warm up
_LAST_WORDS = 5  # lines of a dead process's output that go into the report
_THREAD_VARIABLES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS",
                     "NUMEXPR_NUM_THREADS")  # fmt: skip


@dataclass(frozen=True)
class Answer:
    """A pose, or why there is none; seconds around the call alone."""

    T: Array | None
    seconds: float
    error: str = ""


class Worker:
    """Runs one method. Started when first asked, and again after a crash or a time-out."""

    def __init__(self, method: Method, threads: int) -> None:
        self.method = method
        self._threads = threads
        self._process: Any = None
        self._connection: Connection | None = None
        # Closed by close().
        self._log = tempfile.NamedTemporaryFile(prefix="peers-", suffix=".log")  # noqa: SIM115

    def ask(self, source: Array, target: Array, task: Task, limit: float) -> Answer:
        """One run; `limit` seconds at most."""
        if self._connection is None:
            failure = self._start()
            if failure:
                return failure
        assert self._connection is not None
        self._connection.send((source, target, task))
        return self._receive(limit)

    def close(self) -> None:
        self._stop()
        self._log.close()

    def _start(self) -> Answer | None:
        context = multiprocessing.get_context("spawn")
        self._connection, theirs = context.Pipe()
        self._log.truncate(0)
        with _thread_environment(self._threads):
            self._process = context.Process(
                target=_serve, args=(theirs, self.method, self._threads, self._log.name)
            )
            self._process.daemon = True  # ends with us, however we end
            self._process.start()
        theirs.close()
        answer = self._receive(START_LIMIT)
        if not answer.error:
            return None
        self._stop()
        return Answer(None, 0.0, f"could not be started: {answer.error}")

    def _receive(self, limit: float) -> Answer:
        assert self._connection is not None
        try:
            if self._connection.poll(limit):
                answer: Answer = self._connection.recv()
                return answer
            error = f"no answer within {limit:g} s"
        except (EOFError, ConnectionResetError):
            self._process.join()
            error = f"crashed: {_cause(self._process.exitcode)}{self._last_words()}"
        self._stop()
        return Answer(None, 0.0, error)

    def _stop(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.join()
        if self._connection is not None:
            self._connection.close()
        self._process = self._connection = None

    def _last_words(self) -> str:
        lines = Path(self._log.name).read_text(errors="replace").strip().splitlines()
        return "".join(f"\n    {line}" for line in lines[-_LAST_WORDS:])


class _thread_environment:
    """Variables that a child process is born with; OpenMP reads them when it is loaded."""

    def __init__(self, threads: int) -> None:
        self._wanted = dict.fromkeys(_THREAD_VARIABLES, str(threads))

    def __enter__(self) -> None:
        self._before = {name: os.environ.get(name) for name in self._wanted}
        os.environ.update(self._wanted)

    def __exit__(self, *_: object) -> None:
        for name, value in self._before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


def _serve(connection: Connection, method: Method, threads: int, log: str) -> None:
    """The child's life: warm up, then a run for each that comes."""
    output = os.open(log, os.O_WRONLY | os.O_APPEND)
    os.dup2(output, sys.stdout.fileno())
    os.dup2(output, sys.stderr.fileno())
    # TBB asks how many processors the process may use, and nothing else.
    os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:threads])
    try:
        register = method.load()
        register(*_warm_up(threads))
    except Exception:  # noqa: BLE001 (of others' code: told to the parent)
        connection.send(Answer(None, 0.0, traceback.format_exc()))
        return
    connection.send(Answer(None, 0.0))
    while True:
        try:
            source, target, task = connection.recv()
        except EOFError:
            return
        start = time.perf_counter()
        try:
            T = register(source, target, task)
            answer = Answer(T, time.perf_counter() - start)
        except Exception:  # noqa: BLE001 (of others' code: told to the parent)
            answer = Answer(None, time.perf_counter() - start, traceback.format_exc())
        connection.send(answer)


def _warm_up(threads: int) -> tuple[Array, Array, Task]:
    """A bumpy surface and itself: the first call makes thread pools, which none is charged for."""
    x, y = np.random.default_rng(0).uniform(-1.0, 1.0, (2, 4000))
    z = 0.3 * np.sin(3.0 * x + y) * np.cos(2.0 * y) + 0.2 * np.exp(-8.0 * ((x - 0.3) ** 2 + y * y))
    cloud = np.stack([x, y, z], axis=1)
    return cloud, cloud.copy(), Task(0.06, threads, 0)


def _cause(code: int) -> str:
    if code >= 0:
        return f"exit status {code}"
    try:
        return f"killed by {signal.Signals(-code).name}"
    except ValueError:
        return f"killed by signal {-code}"
