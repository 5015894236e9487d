"""Clouds and results go to other processes and come back the same."""

from __future__ import annotations

import copy
import multiprocessing
import pickle

import numpy as np
import pytest
from children import environment
from shapes import bits

import pyemtr


@pytest.fixture(scope="module")
def result(pair):
    return pyemtr.register(pair.source, pair.target, threads=2, iterations=5)


def again(thing):
    return pickle.loads(pickle.dumps(thing))


def test_a_cloud_is_the_same_to_the_bit(pair) -> None:
    points = pair.source.astype(np.float32)
    points[4] = np.nan
    cloud = pyemtr.Cloud(points, threads=2)
    back = again(cloud)
    assert repr(back) == repr(cloud) and back.dropped == 1
    assert back.points.dtype == np.float32 and back.points.tobytes() == points.tobytes()
    quick = {"iterations": 5, "threads": 2}
    wanted = bits(pyemtr.register(cloud, pair.target, **quick))
    assert bits(pyemtr.register(back, pair.target, **quick)) == wanted


def test_normals_features_and_keep_points_go_along(pair) -> None:
    rng = np.random.default_rng(3)
    features = rng.normal(size=(len(pair.source), 5)).astype(np.float32)
    cloud = pyemtr.Cloud(pair.source, normals=pair.source, features=features)
    back = again(cloud)
    assert back.has_normals and back.keypoints == cloud.keypoints == len(pair.source)
    many = rng.normal(size=(200_001, 3)).astype(np.float32)
    assert again(pyemtr.Cloud(many, keep_points=True)).points.tobytes() == many.tobytes()


def test_points_that_were_not_kept_cannot_be_pickled() -> None:
    cloud = pyemtr.Cloud(np.random.default_rng(0).normal(size=(200_001, 3)))
    with pytest.raises(TypeError, match="keep_points=True"):
        pickle.dumps(cloud)


def test_the_points_are_the_cloud_s_own_and_read_only(pair) -> None:
    points = pair.source.copy()
    cloud = pyemtr.Cloud(points)
    points[:] = 0
    assert np.array_equal(cloud.points, pair.source)
    with pytest.raises(ValueError, match="read-only"):
        cloud.points[0] = 0


def test_a_copy_of_a_cloud_is_the_cloud(pair) -> None:
    cloud = pyemtr.Cloud(pair.source)
    assert copy.copy(cloud) is cloud and copy.deepcopy([cloud])[0] is cloud


def test_a_result(result) -> None:
    back = again(result)
    assert bits(back) == bits(result) and back.to_dict() == result.to_dict()
    assert isinstance(back.alternatives[0], pyemtr.Alternative)


def test_worker_processes_take_clouds_and_give_results(pair, monkeypatch) -> None:
    monkeypatch.setenv("PYTHONPATH", environment()["PYTHONPATH"])
    cloud = pyemtr.Cloud(pair.target)
    scans = [(pair.source, cloud), (pair.source[:4000], cloud)]
    with multiprocessing.get_context("spawn").Pool(2) as workers:
        found = workers.starmap(pyemtr.register, scans)
    assert [bits(one) for one in found] == [bits(pyemtr.register(*scan)) for scan in scans]
