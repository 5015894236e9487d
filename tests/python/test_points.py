"""Whatever users call a cloud: its points are taken, or it is refused with a hint."""

from __future__ import annotations

import types
from typing import Any

import numpy as np
import pytest

import pyemtr
from pyemtr.points import as_points

POINTS = np.random.default_rng(5).normal(size=(40, 3))
ONES = np.ones((40, 1))


class Tensor:
    """Behaves as one of Open3D or PyTorch: numpy cannot read it as it is."""

    def __init__(self, values: np.ndarray) -> None:
        self.values = values

    def cpu(self) -> Tensor:
        return self

    def numpy(self) -> np.ndarray:
        return self.values


class Tracked(Tensor):
    """Behaves as one of PyTorch whose gradient is tracked."""

    def detach(self) -> Tensor:
        return Tensor(self.values)

    def numpy(self) -> np.ndarray:
        raise RuntimeError("use tensor.detach().numpy() instead")


class Table:
    """Behaves as a DataFrame of pandas or polars."""

    def __init__(self, **columns: Any) -> None:
        self.data = {name.strip("_"): values for name, values in columns.items()}
        self.columns = list(self.data)

    def __getitem__(self, name: str) -> Any:
        return self.data[name]

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        return np.column_stack(list(self.data.values()))


def one(**attributes: Any) -> types.SimpleNamespace:
    return types.SimpleNamespace(**attributes)


def structured() -> np.ndarray:
    rows = np.zeros(40, [("intensity", "f4"), ("Z", "f8"), ("y", "f8"), ("X", "f8")])
    rows["X"], rows["y"], rows["Z"] = POINTS.T
    return rows


def columns(*names: str) -> Table:
    return Table(**dict(zip(names, POINTS.T)))


# As the libraries have them; the real ones are in test_real_clouds.py.
CLOUDS = {
    "homogeneous": np.hstack([POINTS, ONES]),
    "Open3D": one(points=POINTS.tolist()),
    "Open3D, tensor": one(point=one(positions=Tensor(POINTS))),
    "a tensor": Tensor(POINTS),
    "a tensor with a gradient": Tracked(POINTS),
    "trimesh": one(vertices=POINTS),
    "small_gicp": one(points=lambda: np.hstack([POINTS, ONES])),
    "laspy": one(points="raw records", xyz=POINTS),
    "python-pcl": one(to_array=lambda: POINTS),
    "a mesh without faces": one(vertices=POINTS, triangles=[]),
    "a tensor mesh without faces": one(vertex=one(positions=Tensor(POINTS)), triangle={}),
    "table": Table(i=range(40), Z=POINTS[:, 2], x=POINTS[:, 0], Y=POINTS[:, 1]),
    "table in another order": Table(z=POINTS[:, 2], y=POINTS[:, 1], x=POINTS[:, 0]),
    "table of three": columns("a", "b", "c"),
    "structured": structured(),
}


@pytest.mark.parametrize("kind", CLOUDS)
def test_the_points_of_a_cloud_are_taken(kind: str) -> None:
    assert np.array_equal(as_points(CLOUDS[kind], "source"), POINTS)


def test_homogeneous_coordinates_are_read_in_place() -> None:
    rows = np.hstack([POINTS, ONES]).astype(np.float32)
    assert np.shares_memory(as_points(rows, "source"), rows)


def test_a_preprocessed_cloud_gives_its_points() -> None:
    cloud = pyemtr.Cloud(POINTS.astype(np.float32))
    assert np.array_equal(as_points(cloud, "source"), POINTS.astype(np.float32))


REFUSED = [
    (np.hstack([POINTS, 2 * ONES]), ValueError, r"\(40, 4\).*1 throughout.*\[:, :3\]"),
    (np.hstack([POINTS, POINTS]), ValueError, r"\(40, 6\).*\[:, :3\].*argument for normals"),
    (np.hstack([POINTS, ONES, POINTS]), ValueError, r"\(40, 7\).*\[:, :3\]"),
    (POINTS.T, ValueError, "transpose"),
    (columns("x", "y", "w"), ValueError, "one column each of x, y and z, got x, y, w"),
    (Table(x=POINTS[:, 0], X=POINTS[:, 1], y=ONES, z=ONES), ValueError, "one column each"),
    (Table(a=ONES, b=ONES, c=ONES, d=ONES), TypeError, "columns x, y and z .*got a, b, c, d"),
    (np.zeros(40, "f4,f4,f4"), TypeError, "columns x, y and z .*dtype.*f0, f1, f2"),
    (one(), TypeError, "SimpleNamespace"),
    (one(points=lambda: None), TypeError, "NoneType"),
]


@pytest.mark.parametrize("cloud, error, text", REFUSED, ids=range(len(REFUSED)))
def test_what_is_refused_says_what_to_give(cloud: Any, error: type, text: str) -> None:
    with pytest.raises(error, match=f"^target: .*{text}"):
        pyemtr.register(POINTS, cloud)


def test_one_row_that_is_not_homogeneous_is_enough_to_refuse_all() -> None:
    rows = np.hstack([POINTS, ONES])
    rows[7, 3] = np.nan
    with pytest.raises(ValueError, match="1 throughout"):
        as_points(rows, "source")


def test_points_that_a_cloud_did_not_keep_are_named() -> None:
    many = np.random.default_rng(0).normal(size=(200_001, 3))
    cloud = pyemtr.Cloud(many)
    for call in (lambda: pyemtr.residuals(POINTS, cloud), lambda: as_points(cloud, "target")):
        with pytest.raises(TypeError, match=r"^target: .*Cloud of 200001 .*keep_points"):
            call()
    assert np.array_equal(pyemtr.Cloud(many, keep_points=True).points, many)
