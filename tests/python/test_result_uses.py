"""What is done with a result: points moved, the pose inverted, its covariance, a round trip."""

from __future__ import annotations

import json
import math
import types
import xml.etree.ElementTree as xml
from typing import Any

import numpy as np
import pytest
import shapes

import pyemtr


@pytest.fixture(scope="module")
def solved(pair):
    return pyemtr.register(pair.source, pair.target, threads=2)


@pytest.fixture(scope="module")
def plane():
    rng = np.random.default_rng(1)
    points = np.column_stack([rng.uniform(-1, 1, (4000, 2)), rng.normal(scale=1e-3, size=4000)])
    return pyemtr.register(points, points[:3000], preset="fast", threads=2)


def test_apply_takes_what_register_takes(pair, solved, tmp_path) -> None:
    wanted = shapes.apply(solved.transformation, pair.source)
    np.save(tmp_path / "a.npy", pair.source)
    for cloud in (
        pair.source,
        pyemtr.Cloud(pair.source),
        types.SimpleNamespace(points=pair.source),
        tmp_path / "a.npy",
    ):
        np.testing.assert_allclose(solved.apply(cloud), wanted, rtol=0, atol=1e-12)


def test_a_mesh_moves_by_its_own_method(solved) -> None:
    mesh = types.SimpleNamespace(vertices=np.eye(3), faces=[[0, 1, 2]])
    with pytest.raises(TypeError, match=r"points: a mesh .*apply_transform"):
        solved.apply(mesh)


def test_inverse_undoes_the_transformation(pair, solved) -> None:
    back = shapes.apply(solved.inverse(), solved.apply(pair.source))
    np.testing.assert_allclose(back, pair.source, rtol=0, atol=1e-12)
    assert solved.inverse()[3].tolist() == [0, 0, 0, 1]


def test_a_result_is_a_guess(pair, solved) -> None:
    guessed = pyemtr.register(pair.source, pair.target, guess=solved, preset="fast", iterations=3)
    assert guessed.settings["guess"] == solved.transformation.tolist()


def test_the_covariance_is_the_inverse_of_the_information(solved) -> None:
    assert solved.unconstrained_directions == 0
    covariance = solved.covariance
    assert covariance.dtype == np.float64 and np.array_equal(covariance, covariance.T)
    np.testing.assert_allclose(covariance @ solved.information, np.eye(6), atol=1e-8)
    assert (np.linalg.eigvalsh(covariance) > 0).all()


def test_rotation_comes_first_and_lengths_have_the_clouds_unit(solved) -> None:
    pair = shapes.make_pair(1, scale=1024.0)  # with the same rungs
    scaled = pyemtr.register(pair.source, pair.target, threads=2).covariance
    np.testing.assert_allclose(scaled[:3, :3], solved.covariance[:3, :3], rtol=0.05)
    np.testing.assert_allclose(
        np.diag(scaled)[3:], 1024**2 * np.diag(solved.covariance)[3:], rtol=0.05
    )


def test_the_covariance_is_that_of_repeated_scans() -> None:
    """Poses of one place, scanned again and again, scatter as it says, within a factor of three."""
    found, said = [], []
    for seed in range(12):
        pair = shapes.make_pair(seed, count=5000)
        result = pyemtr.register(pair.source, pair.target, preset="fast", threads=2)
        w = result.transformation[:3, :3] @ pair.truth[:3, :3].T
        found.append(np.array([w[2, 1] - w[1, 2], w[0, 2] - w[2, 0], w[1, 0] - w[0, 1]]) / 2)
        said.append(np.trace(result.covariance[:3, :3]))
    ratio = np.mean(np.square(found).sum(axis=1)) / np.mean(said)
    assert 1 / 9 < ratio < 9


def test_there_is_no_covariance_without_a_constraint(pair, plane) -> None:
    assert plane.unconstrained_directions > 0 and plane.covariance is None
    paper = pyemtr.register(pair.source, pair.target, preset="paper", iterations=2, threads=2)
    assert not paper.refined and paper.covariance is None


def through_json(result: pyemtr.Result) -> pyemtr.Result:
    return pyemtr.Result.from_dict(json.loads(json.dumps(result.to_dict(), allow_nan=False)))


def same(a: Any, b: Any) -> bool:
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
    if isinstance(a, float) and math.isnan(a):
        return math.isnan(b)
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    if isinstance(a, (list, pyemtr.Alternative)):
        return len(a) == len(b) and all(map(same, a, b))
    return type(a) is type(b) and a == b


@pytest.mark.parametrize("changes", [{}, {"preset": "paper"}, {"time_limit": 1e-9}, {"guess": 1}])
def test_from_dict_gives_every_bit_back(pair, changes) -> None:
    if "guess" in changes:
        changes = {"guess": pair.truth, "time_limit": 1e6, "source_viewpoint": (0, 0, 3)}
    result = pyemtr.register(pair.source, pair.target, iterations=3, threads=2, **changes)
    back = through_json(result)
    assert vars(back).keys() == vars(result).keys()
    assert [n for n, v in vars(result).items() if not same(v, vars(back)[n])] == []
    assert back.to_dict() == result.to_dict()


def test_a_field_that_this_version_does_not_know_stays(solved) -> None:
    values = {**solved.to_dict(), "weather": {"wind": 0.25}}
    assert pyemtr.Result.from_dict(values).weather == {"wind": 0.25}


@pytest.mark.parametrize(
    "change, error, text",
    [
        ({"transformation": [[1.0] * 4] * 3}, ValueError, r"transformation: .*\(4, 4\)"),
        ({"transformation": [["a"] * 4] * 4}, ValueError, "transformation"),
        ({"fitness": "good"}, ValueError, "fitness: expected float, got 'good'"),
        ({"registered": 1}, ValueError, "registered: expected bool, got 1"),
        ({"alternatives": [{"score": 1}]}, ValueError, "alternatives"),
        ({"history": None}, ValueError, "history"),
        ({"score": ...}, ValueError, "score: missing"),
    ],
)
def test_from_dict_names_the_wrong_field(solved, change, error, text) -> None:
    values = {**solved.to_dict(), **change}
    values = {name: value for name, value in values.items() if value is not ...}
    with pytest.raises(error, match=text):
        pyemtr.Result.from_dict(values)


def test_from_dict_takes_a_dict() -> None:
    with pytest.raises(TypeError, match="expected a dict"):
        pyemtr.Result.from_dict("result.json")


def test_notebooks_show_the_verdict_and_bars(solved, plane) -> None:
    for result, verdict in (
        (solved, "registered"),
        (plane, f"not registered: {plane.reason_text}"),
    ):
        tree = xml.fromstring(result._repr_html_().replace("<br>", "<br/>").replace("&nbsp;", " "))
        assert tree.find("b").text == verdict
        bars = [float(bar.get("width")) for bar in tree.iter("rect")][1::2]
        shares = [result.confidence, result.overlap_source, result.overlap_target]
        assert bars == pytest.approx([100 * share for share in shares], abs=0.06)
        numbers = "".join(tree.find("div").itertext()).split()
        assert [float(n) for n in numbers] == pytest.approx(result.transformation.ravel(), rel=1e-4)


def test_a_result_without_a_pose_can_be_shown(pair) -> None:
    stopped = pyemtr.register(pair.source, pair.target, time_limit=1e-9)
    assert "unknown" in stopped._repr_html_() and "nan" in stopped._repr_html_()
    assert np.isnan(stopped.inverse()[:3]).all() and stopped.covariance is None
