"""The cache of clouds: once each, within its limit, by any number of threads."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from many_pairs import surface

import pyemtr
from pyemtr.batch.cloud_cache import CloudCache

CLOUD = pyemtr.Cloud(surface(1))


def test_those_asked_for_the_longest_ago_are_dropped() -> None:
    cache = CloudCache(2 * CLOUD.nbytes)
    for key in "abacb":  # c drops b, and b then drops a
        cache.get(key, lambda: CLOUD)
    assert cache.made == 4 and cache.bytes == 2 * CLOUD.nbytes
    cache.get("c", lambda: pytest.fail("it is there"))
    cache.clear()
    assert cache.bytes == 0


def test_one_makes_and_the_others_wait_but_not_for_another_cloud() -> None:
    cache, begun, go_on = CloudCache(1 << 30), threading.Event(), threading.Event()

    def slow() -> pyemtr.Cloud:
        begun.set()
        assert go_on.wait(60)
        return CLOUD

    with ThreadPoolExecutor(3) as pool:
        first = pool.submit(cache.get, "slow", slow)
        assert begun.wait(60)
        second = pool.submit(cache.get, "slow", lambda: pytest.fail("made twice"))
        assert pool.submit(cache.get, "other", lambda: CLOUD).result(60) is CLOUD
        assert not first.done() and not second.done()
        go_on.set()
        assert first.result() is second.result() is CLOUD
    assert cache.made == 2


def test_an_error_is_not_kept() -> None:
    cache = CloudCache(1 << 30)

    def fails() -> pyemtr.Cloud:
        raise OSError("not yet")

    with pytest.raises(OSError, match="not yet"):
        cache.get("a", fails)
    assert cache.get("a", lambda: CLOUD) is CLOUD


def test_the_size_of_a_cloud() -> None:
    points = surface(1, 1000)
    plain = pyemtr.Cloud(points)
    assert 36 * 1000 <= plain.nbytes <= 50 * 1000  # float64 rows, and float32 to work with
    with_normals = pyemtr.Cloud(points, normals=points, features=np.ones((1000, 33)))
    assert with_normals.nbytes >= plain.nbytes + 1000 * (24 + 12 + 2 * 132)
    large = np.random.default_rng(0).normal(size=(250_000, 3)).astype(np.float32)
    assert pyemtr.Cloud(large).nbytes < pyemtr.Cloud(large, keep_points=True).nbytes
