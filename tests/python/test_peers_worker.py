"""One method, one process: what a crash costs, and what every method is given."""

import os
import time

import numpy as np
import pytest
from emtr_bench.peers.methods import Task
from emtr_bench.peers.worker import Worker
from peers_fakes import FakeMethod, ThreadCounter

CLOUD = np.random.default_rng(3).normal(size=(60, 3))


def answers(method, seeds, limit=20.0, threads=1):
    worker = Worker(method, threads)
    try:
        return [worker.ask(CLOUD, CLOUD + 1.0, Task(0.1, threads, s), limit) for s in seeds]
    finally:
        worker.close()


@pytest.mark.parametrize(
    ("how", "said"),
    [("segfault", "SIGSEGV\n    a last word"), ("abort", "SIGABRT"),
     ("raise", "RuntimeError: not to my taste")],
)  # fmt: skip
def test_a_crash_costs_one_run(how, said):
    before, lost, after = answers(FakeMethod("crashing", how, fails_at=1), [0, 1, 2])
    assert lost.T is None and said in lost.error
    for answer in (before, after):
        assert not answer.error
        np.testing.assert_allclose(answer.T[:3, 3], [1.0, 1.0, 1.0], atol=1e-9)


def test_a_run_that_takes_too_long_is_ended():
    start = time.monotonic()
    lost, after = answers(FakeMethod("slow", "sleep", fails_at=0), [0, 1], limit=1.5)
    assert lost.error == "no answer within 1.5 s" and not after.error
    assert time.monotonic() - start < 30.0


def test_a_method_that_cannot_start_says_why():
    (answer,) = answers(FakeMethod("absent", "unloadable"), [0])
    assert answer.error.startswith("could not be started") and "no such library" in answer.error


def test_the_time_is_the_calls_alone():
    (first,) = answers(FakeMethod("quick"), [0])
    assert 0.0 < first.seconds < 0.5  # importing and warming up take longer


def test_every_process_has_the_same_threads_and_this_one_keeps_its_own():
    before = dict(os.environ), os.sched_getaffinity(0)
    first, second = answers(ThreadCounter(), [0, 1], threads=1)
    assert first.T[0, 3] == 1.0 and first.T[1, 3] == 1.0
    assert first.T[2, 3] == second.T[2, 3] != os.getpid()
    assert (dict(os.environ), os.sched_getaffinity(0)) == before
