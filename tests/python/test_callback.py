"""Progress, stopping, exceptions and Ctrl-C; the GIL is free in between."""

import gc
import signal
import subprocess
import sys
import textwrap
import threading
import time
import weakref

import numpy as np
import pytest
from children import environment
from stages import STAGES

import pyemtr

ALL = {
    "iterations": 8,
    "stall_iterations": 0,
    "threads": 2,
    "dense_points": 3000,
    "fallback_search": "always",
    "fallback_points": 4000,
}  # quick, and through all stages


def test_each_stage_and_iteration_is_told(pair):
    seen = []
    result = pyemtr.register(pair.source, pair.target, callback=seen.append, **ALL)
    assert list(dict.fromkeys(step.stage for step in seen)) == STAGES
    # While it lasts, the same progress may be told once more.
    evolution = list(dict.fromkeys(step for step in seen if step.stage == "evolution"))
    assert [step.iteration for step in evolution] == list(range(9))
    assert all(isinstance(step, pyemtr.Progress) and step.iterations == 8 for step in evolution)
    assert [step.best_alpha for step in evolution[1:]] == result.history["alpha"].tolist()
    assert [step.best_beta for step in evolution[1:]] == result.history["beta"].tolist()
    assert result.iterations == 8


@pytest.mark.parametrize(
    "changes, absent",
    [
        ({"preset": "paper"}, {"seeds", "candidates", "fallback_search", "refinement"}),
        ({"fallback_search": "off"}, {"fallback_search"}),
        ({"refine": False}, {"fallback_search", "refinement"}),
        ({"candidates": 0}, {"candidates", "fallback_search"}),
    ],
)
def test_a_stage_that_does_not_run_is_not_told(pair, changes, absent):
    seen = []
    result = pyemtr.register(
        pair.source, pair.target, iterations=8, threads=2, callback=seen.append, **changes
    )
    told = list(dict.fromkeys(step.stage for step in seen))
    assert told == [stage for stage in STAGES if stage not in absent]
    assert [stage for stage in STAGES if result.timings[stage] == 0] == (
        [stage for stage in STAGES if stage in absent]
    )


def test_watching_changes_no_bit(pair):
    alone = pyemtr.register(pair.source, pair.target, **ALL)
    watched = pyemtr.register(pair.source, pair.target, callback=lambda progress: None, **ALL)
    assert alone.transformation.tobytes() == watched.transformation.tobytes()


@pytest.mark.parametrize("stage", STAGES)
def test_true_stops_at_any_stage(pair, stage):
    result = pyemtr.register(
        pair.source, pair.target, **ALL, callback=lambda progress: progress.stage == stage
    )
    assert result.reason == "interrupted" and not result.registered
    done = STAGES[: STAGES.index(stage)]
    assert result.iterations == (8 if "evolution" in done else 0)
    assert np.isfinite(result.transformation).all() == ("seeds" in done)  # one of them at least
    assert np.isfinite(result.confidence) == ("candidates" in done)
    assert result.used_fallback_search == ("fallback_search" in done)
    assert result.refined == ("refinement" in done)


def test_stopped_between_iterations_the_best_pose_so_far_is_given(pair):
    result = pyemtr.register(
        pair.source,
        pair.target,
        iterations=50,
        stall_iterations=0,
        coarse_points=0,
        threads=2,
        callback=lambda progress: progress.iteration == 5,
    )
    assert result.reason == "interrupted" and result.iterations == 5
    assert len(result.history["alpha"]) == 5 and np.isfinite(result.transformation).all()
    problem = pyemtr.Problem(pair.source, pair.target, iterations=50, stall_iterations=0, threads=2)
    again = problem.solve(lambda progress: progress.iteration == 5)
    assert again.transformation.tobytes() == result.transformation.tobytes()


class Oops(Exception):
    pass


@pytest.mark.parametrize("stage", STAGES)
@pytest.mark.parametrize("error", [Oops("mine"), SystemExit(3), KeyboardInterrupt()])
def test_what_the_callback_raises_reaches_the_caller(pair, stage, error):
    calls = []

    def callback(progress):
        calls.append(progress)
        if progress.stage == stage:
            raise error

    with pytest.raises(type(error)) as caught:
        pyemtr.register(pair.source, pair.target, callback=callback, **ALL)
    assert caught.value is error
    assert [step.stage for step in calls].count(stage) == 1  # it was not called again


def test_nothing_of_a_failed_run_is_kept(pair):
    class Callback:
        def __call__(self, progress):
            raise Oops

    callback = Callback()
    alive = weakref.ref(callback)
    with pytest.raises(Oops):
        pyemtr.register(pair.source, pair.target, callback=callback)
    del callback
    gc.collect()
    assert alive() is None


def test_a_problem_is_not_entered_again_from_its_own_callback(pair):
    problem = pyemtr.Problem(pair.source, pair.target, iterations=3, threads=2)

    def callback(progress):
        assert problem.queries >= 0  # to look is allowed
        problem.evaluate_beta(np.zeros((1, 3)))

    with pytest.raises(RuntimeError, match="callback"):
        problem.solve(callback)
    assert len(problem.evaluate_beta(np.zeros((1, 3)))) == 1  # and it works again afterwards


def test_other_threads_run_meanwhile(pair):
    """The longest a second thread is held up is far less than the run, which calls back rarely."""
    stamps, done = [], threading.Event()

    def tick():
        while not done.is_set():
            stamps.append(time.perf_counter())
            time.sleep(0.001)

    problem = pyemtr.Problem(pair.source, pair.target, threads=1)
    particles = np.random.default_rng(0).uniform(-1, 1, (30000, 6))
    ticker = threading.Thread(target=tick)
    ticker.start()
    start = time.perf_counter()
    problem.evaluate_alpha(particles)  # one call of C without any callback
    end = time.perf_counter()
    done.set()
    ticker.join()
    during = [stamp for stamp in stamps if start < stamp < end]
    assert end - start > 0.1 and len(during) > 10


def test_the_time_limit_gives_the_best_pose_so_far(pair):
    result = pyemtr.register(pair.source, pair.target, time_limit=1e-9)
    assert result.reason == "time_limit" and not result.registered
    assert np.isnan(result.transformation).all()
    problem = pyemtr.Problem(pair.source, pair.target, time_limit=1e-9, threads=2)
    result = problem.solve()
    assert result.reason == "time_limit" and np.isfinite(result.transformation).all()
    long = pyemtr.register(pair.source, pair.target, time_limit=1e6, **ALL)
    assert long.reason == "registered" and long.settings["time_limit"] == 1e6
    alone = pyemtr.register(pair.source, pair.target, **ALL)
    assert long.transformation.tobytes() == alone.transformation.tobytes()


@pytest.mark.parametrize("value", [-1, float("nan"), float("inf")])
def test_a_time_limit_is_a_number_of_seconds(pair, value):
    with pytest.raises(ValueError, match="time_limit"):
        pyemtr.register(pair.source, pair.target, time_limit=value)


def test_the_callback_may_register_clouds_itself(pair):
    alone = pyemtr.register(pair.source, pair.target, **ALL).transformation.tobytes()
    inner = []

    def callback(progress):
        if progress.iteration == 3 and not inner:
            inner.append(
                pyemtr.register(
                    pair.source, pair.target, callback=lambda step: None, **ALL
                ).transformation.tobytes()
            )

    outer = pyemtr.register(pair.source, pair.target, callback=callback, **ALL)
    assert inner == [alone] and outer.transformation.tobytes() == alone


def test_preprocessed_clouds_beside_arrays_call_back_too(pair):
    model = pyemtr.Cloud(pair.target)
    for clouds in ((pair.source, model), (model, pair.source), (model, model)):
        seen = []
        result = pyemtr.register(*clouds, callback=seen.append, **ALL)
        assert seen[0].stage == "normalization"
        plain = [pair.target if cloud is model else cloud for cloud in clouds]
        again = pyemtr.register(*plain, **ALL)
        assert result.transformation.tobytes() == again.transformation.tobytes()
        assert pyemtr.register(*clouds, time_limit=1e-9).reason == "time_limit"


CHILD = """
    import signal, numpy, shapes, pyemtr
    pair = shapes.make_pair(1)
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may have it ignored
    callback = {callback}
    try:
        {run}
    except KeyboardInterrupt:
        print("interrupted", flush=True)
"""
RUNS = {
    "register": "print('ready', flush=True); pyemtr.register(pair.source, pair.target, "
    "iterations=1000000, stall_iterations=0, threads=1, callback=callback)",
    "solve": "problem = pyemtr.Problem(pair.source, pair.target, iterations=1000000, "
    "stall_iterations=0, threads=1); "
    "print('ready', flush=True); problem.solve(callback)",
}


@pytest.mark.parametrize("callback", ["None", "lambda progress: None"])
@pytest.mark.parametrize("run", RUNS)
def test_ctrl_c(run, callback, tmp_path):
    code = textwrap.dedent(CHILD).format(run=RUNS[run], callback=callback)
    with subprocess.Popen(
        [sys.executable, "-c", code],
        stdout=subprocess.PIPE,
        text=True,
        env=environment(),
        cwd=tmp_path,
    ) as child:
        try:
            assert child.stdout.readline() == "ready\n"
            time.sleep(1)
            assert child.poll() is None  # a million iterations take hours
            child.send_signal(signal.SIGINT)
            out, _ = child.communicate(timeout=60)
        finally:
            child.kill()
    assert out == "interrupted\n" and child.returncode == 0


CALLS = {
    "Cloud": lambda many: pyemtr.Cloud(many, threads=1),
    "Problem": lambda many: pyemtr.Problem(many, many, threads=1),
    "residuals": lambda many: pyemtr.residuals(many, many[:100_000], np.eye(4), threads=1),
}


@pytest.fixture(scope="module")
def many():
    return np.random.default_rng(0).normal(size=(3_000_000, 3))


@pytest.mark.parametrize("name", CALLS)
def test_signals_reach_calls_without_a_callback(name, many):
    """Those that come after a call are handled once, however many they are."""
    handled = []

    def handler(*_):
        handled.append(1)
        if len(handled) == 4:
            raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, handler)
    signal.setitimer(signal.ITIMER_REAL, 0.015, 0.015)
    try:
        with pytest.raises(KeyboardInterrupt):
            CALLS[name](many)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert len(handled) >= 4
