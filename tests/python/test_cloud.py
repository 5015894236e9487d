"""pyemtr.Cloud: one cloud, preprocessed once for many registrations."""

import gc
import threading

import numpy as np
import pytest
import shapes
from shapes import bits

import pyemtr


@pytest.fixture(scope="module")
def cloud(pair):
    return pyemtr.Cloud(pair.target)


@pytest.mark.parametrize("preprocessed", ["source", "target", "both"])
def test_the_same_bits_as_from_arrays(pair, cloud, preprocessed):
    plain = pyemtr.register(pair.source, pair.target, threads=2, iterations=20)
    source = pair.source if preprocessed == "target" else pyemtr.Cloud(pair.source, threads=1)
    target = pair.target if preprocessed == "source" else cloud
    found = pyemtr.register(source, target, threads=2, iterations=20)
    assert bits(found) == bits(plain)
    assert (found.points_source, found.points_target) == (len(pair.source), len(pair.target))


def test_problems_and_tasks_take_clouds(pair, problem, cloud):
    source = pyemtr.Cloud(pair.source)
    particles = np.random.default_rng(3).uniform(-1, 1, (9, 6))
    wanted = problem.evaluate_alpha(particles).tobytes()
    assert pyemtr.Problem(source, cloud).evaluate_alpha(particles).tobytes() == wanted
    assert pyemtr.TaskAlpha(source, pair.target).evaluate(particles).tobytes() == wanted
    assert (
        pyemtr.TaskBeta(pair.source, cloud).evaluate(particles[:, :3]).tobytes()
        == problem.evaluate_beta(particles[:, :3]).tobytes()
    )


def test_what_it_tells(pair):
    points = pair.source.copy()
    points[[3, 8, 11]] = np.nan
    made = pyemtr.Cloud(points)
    finite = np.delete(pair.source, [3, 8, 11], axis=0)
    assert len(made) == len(finite) and made.dropped == 3
    np.testing.assert_allclose(made.center, finite.mean(axis=0), atol=1e-12)
    assert made.radius == pytest.approx(np.linalg.norm(finite - made.center, axis=1).max())
    assert repr(made) == (
        f"<pyemtr.Cloud: {len(finite)} points, 3 dropped, radius {made.radius:.6g}>"
    )
    assert "dropped" not in repr(pyemtr.Cloud(finite))
    with pytest.raises(AttributeError):
        made.radius = 2.0


def test_the_memory_of_the_points_is_not_kept(pair):
    points = pair.target.astype(np.float32)
    wanted = bits(pyemtr.register(pair.source, points.copy(), iterations=5))
    made = pyemtr.Cloud(points)
    points[:] = 0
    del points
    gc.collect()
    assert bits(pyemtr.register(pair.source, made, iterations=5)) == wanted


def test_a_large_cloud_is_the_same_for_any_number_of_threads():
    large = shapes.lump(np.random.default_rng(4), 230_000).astype(np.float32)
    small = large[::40]
    wanted = bits(pyemtr.register(small, large, iterations=3, threads=1))
    for threads in (1, 2, 5):
        made = pyemtr.Cloud(large, threads=threads)
        assert len(made) == len(large)
        assert bits(pyemtr.register(small, made, iterations=3, threads=threads)) == wanted


def test_threads_share_one_at_the_same_time(pair):
    wanted = bits(pyemtr.register(pair.source, pair.target, iterations=10, threads=1))
    source, target = pyemtr.Cloud(pair.source), pyemtr.Cloud(pair.target)
    found = []
    workers = [
        threading.Thread(
            target=lambda: found.append(
                bits(pyemtr.register(source, target, iterations=10, threads=1))
            )
        )
        for _ in range(6)
    ]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert found == [wanted] * 6


@pytest.mark.parametrize(
    "points, error, text",
    [
        (np.zeros((3, 50)), ValueError, r"points: .*\(3, 50\).*transpose"),
        (np.zeros((50, 3), complex), TypeError, "points: .*complex"),
        (np.zeros((9, 3)), ValueError, "^cloud: 9 finite points of 9"),
        (np.ones((50, 3)), ValueError, "^cloud: all points are equal"),
        (np.arange(150.0).reshape(50, 3), ValueError, "^cloud: all points lie on one line"),
    ],
)
def test_bad_points_are_refused(points, error, text):
    with pytest.raises(error, match=text):
        pyemtr.Cloud(points)


def test_bad_threads_and_inputs_are_refused(pair, cloud):
    with pytest.raises(ValueError, match="threads"):
        pyemtr.Cloud(pair.source, threads=-1)
    with pytest.raises(TypeError, match="threads"):
        pyemtr.Cloud(pair.source, threads=1.5)
    with pytest.raises(ValueError, match=r"^source cloud: 9 finite points"):
        pyemtr.register(np.zeros((9, 3)), cloud)
    with pytest.raises(ValueError, match=r"^target cloud: 9 finite points"):
        pyemtr.Problem(cloud, np.zeros((9, 3)))
    with pytest.raises(ValueError, match="source cloud: downsampled"):
        pyemtr.register(pyemtr.Cloud(pair.source * 1e-4), cloud)
