"""Problem, TaskAlpha and TaskBeta: for use with another optimizer."""

import gc
import threading

import numpy as np
import pytest
from scipy.optimize import minimize

import pyemtr

CLOUDS = ["source_sparse", "target_sparse", "source_dense", "target_dense"]
ARRAYS = CLOUDS + [
    "source_normals",
    "target_normals",
    "source_features",
    "target_features",
    "correspondences",
    "tim_source",
    "tim_target",
]


@pytest.mark.parametrize("name", ARRAYS)
def test_arrays_are_read_only_views(problem, name):
    array = getattr(problem, name)
    columns = 33 if "features" in name else 2 if name == "correspondences" else 3
    assert array.dtype == (np.int32 if name == "correspondences" else np.float32)
    assert array.ndim == 2 and array.shape[1] == columns and len(array) > 0
    assert not array.flags.writeable and np.shares_memory(array, getattr(problem, name))
    with pytest.raises(ValueError):
        array[0, 0] = 1
    with pytest.raises(ValueError):
        array.flags.writeable = True


def test_arrays_outlive_the_problem(pair, problem):
    other = pyemtr.Problem(pair.source, pair.target, threads=2)
    arrays = {name: getattr(other, name) for name in ARRAYS}
    del other
    gc.collect()
    np.full(20_000_000, 7.0)  # what was freed would be written over
    for name, array in arrays.items():
        np.testing.assert_array_equal(array, getattr(problem, name))


def test_shapes_belong_together(problem):
    for side in ("source", "target"):
        rows = len(getattr(problem, f"{side}_dense"))
        assert len(getattr(problem, f"{side}_normals")) == rows
        assert len(getattr(problem, f"{side}_features")) == rows
    matches = problem.correspondences
    assert matches.min() >= 0
    assert np.all(matches.max(axis=0) < [len(problem.source_dense), len(problem.target_dense)])
    assert problem.tim_source.shape == problem.tim_target.shape


def test_without_any_match_the_arrays_are_empty_but_whole(pair):
    other = pyemtr.Problem(
        pair.source,
        pair.target,
        tau_factor=0.001,
        inlier_threshold=0.001,
        max_tims=3,
        max_correspondences=3,
        threads=2,
    )
    assert other.tims == 3 and len(other.correspondences) == 3
    assert other.tim_source.shape == (other.tims - other.tims_pruned, 3)
    assert other.evaluate_beta([[0, 0, 0]]) == pytest.approx(
        3 * other.settings["outlier_penalty"] * other.tau, rel=0.9
    )


@pytest.mark.parametrize("resolution", ["sparse", "dense"])
def test_a_particle_costs_the_same_alone_and_among_others(problem, resolution):
    task = pyemtr.TaskAlpha(problem, resolution=resolution)
    particles = np.random.default_rng(2).uniform(*task.bounds.T, (40, 6))
    together = task.evaluate(particles)
    alone = np.concatenate([task.evaluate(particle[None]) for particle in particles])
    assert together.tobytes() == alone.tobytes()
    assert together.dtype == np.float64 and together.shape == (40,)
    assert task.evaluate(np.asfortranarray(particles)).tobytes() == together.tobytes()
    assert task.evaluate(particles.tolist()).tobytes() == together.tobytes()
    assert task.evaluate(particles[::-1])[::-1].tobytes() == together.tobytes()


def test_one_particle_has_one_number(problem):
    particle = np.random.default_rng(3).uniform(-1, 1, 6)
    tasks = pyemtr.TaskAlpha(problem), pyemtr.TaskAlpha(problem, resolution="sparse")
    for task, genes in [(task, 6) for task in tasks] + [(pyemtr.TaskBeta(problem), 3)]:
        alone = task.evaluate(particle[:genes])
        assert isinstance(alone, float) and isinstance(alone, np.float64)
        assert alone == task.evaluate(particle[None, :genes])[0]
        assert alone == task.evaluate(particle[:genes].tolist())


def test_a_task_makes_its_own_problem(pair, problem):
    alpha = pyemtr.TaskAlpha(pair.source, pair.target, resolution="sparse", threads=1)
    beta = pyemtr.TaskBeta(pair.source, pair.target, threads=1)
    particles = np.random.default_rng(2).uniform(-1, 1, (9, 6))
    assert (
        alpha.evaluate(particles).tobytes() == problem.evaluate_alpha(particles, "sparse").tobytes()
    )
    assert (
        beta.evaluate(particles[:, :3]).tobytes()
        == problem.evaluate_beta(particles[:, :3]).tobytes()
    )
    assert alpha.problem.settings["threads"] == 1
    np.testing.assert_array_equal(alpha.bounds[3:], [[-1.2, 1.2]] * 3)
    np.testing.assert_array_equal(beta.bounds, alpha.bounds[:3])


def test_the_settings_reach_the_problem(pair):
    other = pyemtr.Problem(
        pair.source,
        pair.target,
        dense_points=1000,
        sparse_points=200,
        seed=2**64 - 1,
        translation_bound=0.7,
    )
    assert len(other.source_dense) + len(other.target_dense) == pytest.approx(1000, rel=0.05)
    assert other.settings["seed"] == 2**64 - 1
    assert pyemtr.TaskAlpha(other).bounds[3].tolist() == [-0.7, 0.7]


def test_queries_are_counted(problem):
    particles = np.zeros((7, 6))
    before = problem.queries
    problem.evaluate_alpha(particles, "sparse")
    sparse = problem.queries
    problem.evaluate_alpha(particles, "dense")
    dense = problem.queries
    problem.evaluate_beta(particles[:, :3])
    assert sparse - before == 7 * len(problem.source_sparse)
    assert dense - sparse == 7 * (len(problem.source_dense) + len(problem.target_dense))
    assert problem.queries == dense


def test_another_optimizer_can_drive_alpha(problem, pair):
    task = pyemtr.TaskAlpha(problem)
    truth = problem.to_particle(pair.truth)
    start = truth + [0.03, -0.02, 0.03, 0.01, 0.01, -0.01]
    found = minimize(task.evaluate, start, method="Nelder-Mead", options={"maxiter": 200})
    assert found.fun < task.evaluate(start)
    assert np.abs(found.x - truth).max() < np.abs(start - truth).max()


def test_threads_share_a_problem_one_after_another(problem):
    particles = np.random.default_rng(8).uniform(-1, 1, (60, 6))
    wanted = problem.evaluate_alpha(particles).tobytes()
    found = []
    workers = [
        threading.Thread(target=lambda: found.append(problem.evaluate_alpha(particles).tobytes()))
        for _ in range(8)
    ]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert found == [wanted] * 8


@pytest.mark.parametrize(
    "particles, error, text",
    [
        (np.zeros(5), ValueError, r"\(6,\), got \(5,\)"),
        (np.zeros((1, 2, 6)), ValueError, r"\(P, 6\), got \(1, 2, 6\)"),
        (np.zeros((4, 3)), ValueError, r"\(P, 6\), got \(4, 3\)"),
        (np.zeros((6, 4)), ValueError, r"got \(6, 4\)"),
        (np.full((2, 6), np.nan), ValueError, "NaN"),
        (np.full((2, 6), np.inf), ValueError, "NaN or infinity"),
        (np.zeros((2, 6), bool), TypeError, "bool"),
        (np.zeros((2, 6), complex), TypeError, "complex"),
        (None, TypeError, "NoneType"),
        ("particles", TypeError, "str"),
    ],
)
def test_bad_particles_are_refused(problem, particles, error, text):
    with pytest.raises(error, match=f"particles.*{text}"):
        pyemtr.TaskAlpha(problem).evaluate(particles)


def test_no_particles_no_fitness(problem):
    assert problem.evaluate_alpha(np.empty((0, 6))).shape == (0,)
    assert problem.evaluate_beta(np.empty((0, 3))).shape == (0,)


def test_other_misuse(problem, pair):
    with pytest.raises(ValueError, match=r"\(P, 3\)"):
        pyemtr.TaskBeta(problem).evaluate(np.zeros((2, 6)))
    with pytest.raises(ValueError, match="resolution"):
        pyemtr.TaskAlpha(problem, resolution="fine")
    with pytest.raises(ValueError, match="resolution"):
        problem.evaluate_alpha(np.zeros((1, 6)), "fine")
    with pytest.raises(TypeError, match="target"):
        pyemtr.TaskAlpha(pair.source)
    with pytest.raises(TypeError, match="Problem"):
        pyemtr.TaskAlpha(problem, pair.target)
    with pytest.raises(TypeError, match="Problem"):
        pyemtr.TaskBeta(problem, seed=3)
    with pytest.raises(ValueError, match="angles"):
        problem.complement([0, 0, 0, 0])
    with pytest.raises(ValueError, match="particle"):
        problem.to_transformation([0, 0, 0])
    with pytest.raises(AttributeError):
        problem.tau = 3
