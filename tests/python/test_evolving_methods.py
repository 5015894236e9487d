"""The methods that EMTR-SSC is compared with, on functions with known optima."""

import sys

import numpy as np
import pytest
from accuracy_fakes import REPOSITORY
from evolving_methods import apso, deora, emtr_ssc, jade, mfea, mfea2, mtea_ad, operators
from evolving_methods.methods import CONTROLS, METHODS, MULTI, user_method
from evolving_methods.problem import Problem, Task
from evolving_methods.test_functions import pair, rastrigin, single, sphere, task

BY_NAME = {method.name: method for method in (*METHODS, *CONTROLS)}
SINGLE = ("PSO", "JADE", "APSO", "L-SHADE")
GENETIC = ("MFEA", "MFEA-II", "MTEA-AD")
DIFFERENTIAL = ("DEORA", "EMFPCR")
#: A random search of the same budget finds about 3000 on the sphere of reach 100.
SPHERE = dict.fromkeys(GENETIC, 1.0) | dict.fromkeys((*SINGLE, *DIFFERENTIAL), 1e-4)


def solved(name, problem, seed=1):
    BY_NAME[name].load()(problem, np.random.default_rng(seed))
    return problem.tasks[0].best_fitness


def twins(function, n, evaluations):
    """Two tasks with one optimum, the second with rotated axes."""
    tasks = [task("first", function, n, 5.0, 0.2), task("second", function, n, 5.0, 0.2, 1)]
    return Problem(tasks, evaluations, evaluations)


@pytest.mark.parametrize("name", SINGLE)
def test_single_task_methods_find_the_sphere(name):
    problem = single(sphere, 6, 6000)
    assert solved(name, problem) < SPHERE[name]
    assert problem.used <= 6000 and np.allclose(problem.tasks[0].best_genes, 20.0, atol=0.1)


@pytest.mark.parametrize("name", (*GENETIC, *DIFFERENTIAL))
def test_multi_task_methods_find_both_spheres(name):
    problem = twins(sphere, 6, 12000)
    assert solved(name, problem) < 0.02
    assert problem.tasks[1].best_fitness < 0.02 and problem.used <= 12000


@pytest.mark.parametrize("name", ("JADE", "L-SHADE"))
def test_adaptive_differential_evolution_leaves_the_local_optima_of_rastrigin(name):
    assert solved(name, single(rastrigin, 6, 12000)) < 1.0


@pytest.mark.parametrize("name", ("MFEA", "DEORA"))
def test_a_second_task_with_the_same_optimum_does_not_hurt(name):
    assert solved(name, pair("same place", 5000)) < 5.0  # random search: about 19


@pytest.mark.parametrize("method", METHODS, ids=lambda m: m.name)
def test_the_same_seed_gives_the_same_bits_and_the_budget_holds(method):
    found = []
    for seed in (3, 3, 4):
        problem = twins(sphere, 4, 1230)
        method.load()(problem, np.random.default_rng(seed))
        assert problem.used <= 1230 and problem.spent
        found.append(problem.tasks[0].best_genes)
    assert np.array_equal(found[0], found[1]) and not np.array_equal(found[0], found[2])


def test_rows_beyond_the_budget_are_not_evaluated():
    seen = []

    def count(x):
        seen.append(len(x))
        return x.sum(axis=1)

    problem = Problem([Task("f", np.zeros(2), np.ones(2), count, cost=10)], 35, 100)
    fitness = problem.evaluate(np.full((5, 2), 0.5))
    assert seen == [3] and np.isinf(fitness[3:]).all() and problem.spent and problem.used == 30
    assert problem.evaluate(np.zeros((1, 2)))[0] == np.inf and seen == [3]


def test_a_task_without_cost_is_held_by_the_number_of_evaluations():
    free = Task("free", np.zeros(1), np.ones(1), lambda x: x[:, 0], cost=0)
    problem = Problem([free], 1, 7)
    problem.evaluate(np.zeros((20, 1)))
    assert free.evaluations == 7 and problem.spent and problem.progress == 1.0


def test_crossover_keeps_the_mean_and_mutation_keeps_the_box():
    rng = np.random.default_rng(0)
    a, b = 0.3 + 0.1 * rng.random((2, 4000, 3))
    first, second = operators.simulated_binary_crossover(a, b, rng)
    inside = ((first > 0) & (first < 1) & (second > 0) & (second < 1)).all(axis=1)
    assert np.allclose((first + second)[inside], (a + b)[inside]) and inside.mean() > 0.9
    mutated = operators.polynomial_mutation(a, rng)
    assert (mutated >= 0).all() and (mutated <= 1).all()
    assert 0.25 < (mutated != a).mean() < 0.42  # one gene of three


def test_two_others_are_others():
    first, second = operators.two_others(7, np.random.default_rng(0), 9)
    own = np.arange(7)
    assert not ((first == own) | (second == own) | (first == second)).any() and second.max() < 9


def test_states_of_apso():
    assert [apso.next_state(f, apso.EXPLORATION) for f in (0.65, 0.35, 0.05, 0.95)] == [
        apso.EXPLORATION, apso.EXPLOITATION, apso.CONVERGENCE, apso.JUMPING_OUT,
    ]  # fmt: skip
    assert apso.next_state(0.25, apso.EXPLOITATION) == apso.EXPLOITATION  # it stays where it may
    pulls = apso.adapted(np.array([2.4, 2.0]), apso.CONVERGENCE, 0.1)
    assert pulls.sum() == pytest.approx(4.0) and pulls[0] > pulls[1]


def test_mating_is_learned_from_how_far_populations_share_their_place():
    rng = np.random.default_rng(0)
    near, far = rng.normal(0.3, 0.02, (30, 3)), rng.normal(0.7, 0.02, (60, 3))
    divided = np.concatenate([near, far[:30]])  # half of it is where the other task's are
    assert mfea2.learned_mating(divided, far, 2, rng) > 0.5
    assert mfea2.learned_mating(near, far, 2, rng) < 0.1


def test_what_is_usual_is_transferred():
    rng = np.random.default_rng(0)
    known = rng.normal(0.5, 0.02, (50, 3))
    candidates = np.array([[0.1, 0.1, 0.1], [0.5, 0.51, 0.49], [0.9, 0.5, 0.5]])
    assert np.array_equal(mtea_ad.usual(candidates, known, 0.3, 3), candidates[1:2])


def test_deora_gives_more_to_the_task_that_gains():
    chances = deora.chances(np.array([[0.4, 0.0], [0.0, 0.1]] * 5))
    assert chances.sum() == pytest.approx(1.0) and chances[0] > chances[1] > 0.05


def test_deora_rewards_the_task_that_gave_the_bases_of_better_trials():
    before, after = np.array([4.0, 2.0, 8.0, 8.0]), np.array([4.0, 1.0, 8.0, 4.0])
    bases = np.array([0, 1, 0, 1])  # both trials of the second task's bases were better
    found = deora.rewards(before, after, bases, 0, 2)
    assert found == pytest.approx([0.5 * 0.5 + 0.5 * 0.25, 0.5 * 0.5 + 0.5 * 0.5])
    assert deora.changed(np.array([0.7, 0.3]), found, 0, 0.01) == pytest.approx([0.69, 0.31])
    assert deora.changed(np.array([0.7, 0.3]), found[::-1], 0, 0.01) == pytest.approx([0.71, 0.29])
    assert deora.rewards(before, after, np.zeros(4, dtype=int), 0, 2)[1] == 0.0


def test_deora_takes_bases_from_the_other_task_and_differences_from_its_own():
    rows = [np.full((50, 3), 0.2), np.full((50, 3), 0.8)]  # no differences within a task
    trials, bases = deora._trials(rows, 0, np.array([0.5, 0.5]), np.random.default_rng(0))
    moved = (trials == 0.8).any(axis=1)
    assert np.isin(trials, (0.2, 0.8)).all() and np.array_equal(moved, bases == 1)
    assert 10 < moved.sum() < 40


def test_ranks_and_survivors_of_mfea():
    assert mfea.ranks(np.array([[3.0, 1.0], [1.0, 2.0]])).tolist() == [[1, 0], [0, 1]]
    x = np.arange(6.0)[:, None]
    skill = np.array([0, 0, 0, 1, 1, 1])
    rows, kept, fitness = mfea.survivors(x, skill, np.array([3, 1, 2, 9, 7, 8.0]), 4, 2)
    assert sorted(zip(kept, fitness)) == [(0, 1.0), (0, 2.0), (1, 7.0), (1, 8.0)]
    assert len(rows) == 4


def test_equal_ranks_are_not_all_of_the_first_task():
    costs = np.repeat(np.arange(100.0)[:, None], 2, axis=1)
    assert 0.3 < mfea.skills(costs, np.random.default_rng(0)).mean() < 0.7


def test_lehmer_mean_of_jade():
    assert jade.lehmer_mean(np.array([1.0, 3.0])) == pytest.approx(2.5)


def test_emtr_ssc_goes_over_to_the_dense_task_and_transfers():
    def pose(x):
        return ((x - 0.1) ** 2).sum(axis=1)

    box = np.array([np.pi, np.pi / 2, np.pi, 0.5, 0.5, 0.5])
    tasks = [Task("alpha", -box, box, pose), Task("beta", -box[:3], box[:3], pose, 0),
             Task("alpha sparse", -box, box, pose)]  # fmt: skip
    problem = Problem(tasks, 10**6, 10**6, lambda angles: np.full(3, 0.1))
    emtr_ssc.optimise(problem, np.random.default_rng(0))
    assert tasks[0].evaluations == 50 * 40 + 50 and tasks[2].evaluations == 50 * 60
    assert np.allclose(tasks[0].best_genes, 0.1, atol=1e-3)
    with pytest.raises(ValueError, match="no knowledge complement"):
        emtr_ssc.optimise(Problem(tasks, 10**6, 10**6), np.random.default_rng(0))


def test_the_nearest_alias_is_the_same_rotation():
    from emtr_bench.protocol import euler_zyx

    ranges = np.array([2.0, 1.0, 2.0]) * np.pi
    rng = np.random.default_rng(0)
    for unit, goal in rng.random((20, 2, 3)):
        alias = emtr_ssc._nearest_alias(unit, goal)
        a, b = (-0.5 * ranges + values * ranges for values in (unit, alias))
        assert np.allclose(euler_zyx(a), euler_zyx(b))
        away = np.abs((alias - goal) * ranges).sum()
        assert away <= np.abs((unit - goal) * ranges).sum() + 1e-12


def test_a_method_of_the_users_own(tmp_path, monkeypatch):
    (tmp_path / "my_search.py").write_text(
        "def optimise(problem, rng):\n"
        "    while not problem.spent:\n"
        "        problem.evaluate(rng.random((20, problem.dimensions)))\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    method = user_method("my_search:optimise")
    assert method.kind == MULTI and len(method.tasks) == 3
    problem = single(sphere, 3, 300)
    method.load()(problem, np.random.default_rng(0))
    assert problem.used == 300 and problem.tasks[0].best_fitness < 5000.0
    sys.modules.pop("my_search")
    for wrong in ("my_search", ":optimise"):
        with pytest.raises(ValueError, match="expected MODULE:FUNCTION"):
            user_method(wrong)
    with pytest.raises(ValueError, match="no_such_module"):
        user_method("no_such_module:optimise").load()


def test_each_method_has_a_file_that_names_its_paper():
    folder = REPOSITORY / "tools" / "bench" / "evolving_methods"
    for method in METHODS:
        text = (folder / f"{method.place.partition(':')[0].split('.')[-1]}.py").read_text()
        assert text.startswith(f'"""{method.name}: ')
