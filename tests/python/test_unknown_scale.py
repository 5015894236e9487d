"""A source of another scale: the similarity is found, and what cannot be told is said."""

import numpy as np
import pytest
import shapes
from hypothesis import given, settings
from hypothesis import strategies as st

import pyemtr
from pyemtr.options import make_settings

QUICK = {"preset": "fast", "threads": 2}


@pytest.fixture(scope="module")
def pair():
    return shapes.make_pair(5, count=6000)


@pytest.fixture(scope="module")
def found(pair):
    return pyemtr.register(pair.source / 37, pair.target, scale="free", **QUICK)


def test_the_similarity_is_found(pair, found):
    assert found.registered
    assert found.scale == pytest.approx(37, rel=0.005)
    aligned = found.apply(pair.source / 37)
    assert np.abs(aligned - shapes.apply(pair.truth, pair.source)).max() < 0.05
    np.testing.assert_allclose(found.rotation @ found.rotation.T, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(
        found.scale * found.rotation, found.transformation[:3, :3], rtol=1e-12
    )
    np.testing.assert_array_equal(found.translation, found.transformation[:3, 3])


def test_the_inverse_is_that_of_the_similarity(found):
    np.testing.assert_allclose(found.inverse() @ found.transformation, np.eye(4), atol=1e-9)


def test_residuals_are_in_the_target_s_unit(pair, found):
    of_source = found.residuals(pair.source / 37, pair.target)
    rigid = pyemtr.residuals(found.apply(pair.source / 37), pair.target, np.eye(4))
    np.testing.assert_allclose(of_source, rigid, atol=1e-4)
    of_target = found.residuals(pair.source / 37, pair.target, of="target")
    back = pyemtr.residuals(found.apply(pair.source / 37), pair.target, np.eye(4), of="target")
    np.testing.assert_allclose(of_target, back, atol=1e-4)


def test_the_result_keeps_the_scale_as_a_dict(found):
    copy = pyemtr.Result.from_dict(found.to_dict())
    assert copy.scale == found.scale
    np.testing.assert_array_equal(copy.information_similarity, found.information_similarity)
    assert copy.information_similarity.shape == (7, 7)
    assert np.linalg.eigvalsh(copy.information_similarity).min() > 0


def test_the_settings_repeat_the_run(pair, found):
    again = pyemtr.register(pair.source / 37, pair.target, **{**found.settings, "threads": 1})
    np.testing.assert_array_equal(again.transformation, found.transformation)


def test_bounds_and_a_known_factor(pair):
    bounded = pyemtr.register(pair.source / 1.1, pair.target, scale=(0.8, 1.25), **QUICK)
    known = pyemtr.register(pair.source / 1.1, pair.target, scale=1.1, **QUICK)
    for result in (bounded, known):
        assert result.registered and result.scale == pytest.approx(1.1, rel=0.005)


def test_a_known_factor_is_kept_and_bounds_are_kept_to(pair):
    assert pyemtr.register(pair.source / 1.1, pair.target, scale=1.102, **QUICK).scale == 1.102
    result = pyemtr.register(pair.source / 1.1, pair.target, scale=(0.9, 1.095), **QUICK)
    assert result.scale <= 1.095


def test_a_far_away_source_is_found(pair):
    far = pair.source + [4e5, 5e6, 100.0]  # map coordinates
    result = pyemtr.register(far * 3, pair.target, scale="free", **QUICK)
    assert result.registered and result.scale == pytest.approx(1 / 3, rel=0.005)
    assert np.abs(result.apply(far * 3) - shapes.apply(pair.truth, pair.source)).max() < 0.05
    np.testing.assert_allclose(result.center_source, (far * 3).mean(axis=0), rtol=1e-6)


def test_a_prior_holds_at_the_scale_that_is_found(pair):
    low, high = pair.truth[:3, 3] - 0.001, pair.truth[:3, 3] + 0.001
    result = pyemtr.register(
        pair.source / 7, pair.target, scale="free", translation_bounds=(low, high), **QUICK
    )
    assert result.registered and result.scale == pytest.approx(7, rel=0.01)
    assert (low - 1e-9 <= result.translation).all() and (result.translation <= high + 1e-9).all()


def test_its_page_shows_all_of_a_source_in_another_unit(pair, tmp_path):
    result = pyemtr.register(1000 * pair.source, pair.target, scale="units", **QUICK)
    result.to_html(tmp_path / "page.html", 1000 * pair.source, pair.target)
    assert (tmp_path / "page.html").stat().st_size > 500_000


def test_a_stopped_run_has_the_best_similarity_so_far(pair):
    def stop(progress):
        return progress.stage == "refinement"

    result = pyemtr.register(pair.source / 37, pair.target, scale="free", callback=stop, **QUICK)
    assert result.reason == "interrupted" and not result.registered
    assert result.scale == pytest.approx(37, rel=0.03)


def test_a_unit_by_correspondences_is_exact(pair):
    rows = np.random.default_rng(0).permutation(len(pair.source))[:50]
    points = pair.source[rows]
    match = np.stack([np.arange(50)] * 2, axis=1)
    result = pyemtr.register(
        1000 * points, shapes.apply(pair.truth, points), correspondences=match, scale="units",
        **QUICK,
    )  # fmt: skip
    assert result.registered and result.scale == 1 / 1000


def test_a_unit_is_told_exactly(pair):
    result = pyemtr.register(1000 * pair.source, pair.target, scale="units", **QUICK)
    assert result.registered and result.scale == 1 / 1000


def test_a_preprocessed_cloud_serves_all_scales(pair, found):
    source, target = pyemtr.Cloud(pair.source / 37), pyemtr.Cloud(pair.target)
    again = pyemtr.register(source, target, scale="free", **QUICK)
    np.testing.assert_array_equal(again.transformation, found.transformation)


def test_correspondences_alone_tell_the_scale():
    rng = np.random.default_rng(3)
    source = rng.uniform(size=(400, 3))
    T = shapes.random_transformation(rng)
    T[:3, :3] *= 2.7
    target = shapes.apply(T, source) + rng.normal(scale=0.005, size=source.shape)
    target[100:] = rng.uniform(-3, 3, (300, 3))
    rows = np.stack([np.arange(400)] * 2, axis=1)
    result = pyemtr.register(source, target, correspondences=rows, scale="free", threads=1)
    assert result.registered
    assert result.scale == pytest.approx(2.7, rel=0.01)
    np.testing.assert_allclose(result.transformation, T, atol=0.03)


def test_of_unrelated_scans_none_is_registered(pair):
    rng = np.random.default_rng(8)
    box = rng.uniform(-1, 1, (5000, 3)) * [1, 0.7, 0.5]
    face = rng.integers(0, 3, 5000)
    box[np.arange(5000), face] = np.sign(box[np.arange(5000), face]) * [1, 0.7, 0.5][0]
    assert not pyemtr.register(box, pair.target, scale="free", **QUICK).registered


def test_a_rigid_run_has_the_scale_one(pair):
    result = pyemtr.register(pair.source, pair.target, **QUICK)
    assert result.scale == 1
    assert np.isnan(result.scale_constraint) and np.isnan(result.information_similarity).all()
    assert result.timings["scale_search"] == 0


@pytest.mark.parametrize(
    ("scale", "error", "words"),
    [
        ("any", ValueError, "expected one of fixed, free, bounded, units"),
        ((2, 1), ValueError, "contradict each other"),
        ((1, 2, 3), TypeError, "a number or its two bounds"),
        ((0, 2), ValueError, "scale_minimum"),
        (float("nan"), ValueError, "scale_minimum"),
        (True, TypeError, "expected one of"),
    ],
)
def test_a_bad_scale_is_refused(pair, scale, error, words):
    with pytest.raises(error, match=words):
        pyemtr.register(pair.source, pair.target, scale=scale)


def test_bounds_without_a_bounded_scale_are_refused(pair):
    with pytest.raises(ValueError, match="say nothing unless 'scale' is bounded"):
        pyemtr.register(pair.source, pair.target, scale_maximum=2)
    with pytest.raises(TypeError, match="beside the bounds"):
        pyemtr.register(pair.source, pair.target, scale=(1, 2), scale_maximum=3)


def test_a_problem_has_one_scale(pair):
    with pytest.raises(ValueError, match="a problem has one scale"):
        pyemtr.Problem(pair.source, pair.target, scale="free")


@given(st.floats(1e-5, 1e5), st.floats(1, 8))
@settings(deadline=None)
def test_numbers_become_bounds(low, ratio):
    chosen = make_settings("default", {"scale": (low, low * ratio)})
    assert chosen.get("scale_minimum") == low
    assert chosen.get("scale_maximum") == low * ratio


def bumpy_body(count, seed):
    at = np.random.default_rng(seed).normal(size=(count, 3))
    at /= np.linalg.norm(at, axis=1, keepdims=True)
    x, y, z = at.T
    bumps = 1 + 0.12 * np.sin(4 * x + 1) * np.sin(5 * y) + 0.1 * np.sin(6 * z + 2 * x)
    return at * bumps[:, None] * [1.0, 0.8, 0.6]


def test_of_two_sizes_of_one_body_in_a_scene_one_is_found():
    """Whether the other is looked for is left to the matches, see the limits in the page."""
    larger = 1.5 * bumpy_body(8000, 21)
    larger = larger[larger[:, 0] > 0]  # so that both have about as many matches
    scene = np.vstack([bumpy_body(6000, 10), larger + [4, 0, 0]])
    result = pyemtr.register(bumpy_body(6000, 1), scene, scale="free", **QUICK)
    assert result.reason in ("registered", "ambiguous")
    place, scale = ([0, 0, 0], 1) if result.scale < 1.25 else ([4, 0, 0], 1.5)
    assert abs(result.scale / scale - 1) < 0.01
    np.testing.assert_allclose(result.rotation, np.eye(3), atol=0.02)
    np.testing.assert_allclose(result.translation, place, atol=0.03)
