"""The benchmark for real: with the library, on generated pairs where no data are."""

import json
import os
import subprocess
import sys

import numpy as np
from accuracy_fakes import REPOSITORY
from emtr_bench import runner
from emtr_bench.engine import PyemtrEngine

SCRIPT = REPOSITORY / "tools" / "bench" / "accuracy"


def run(*argv, **environment):
    return subprocess.run(
        [sys.executable, str(SCRIPT), *argv],
        capture_output=True,
        text=True,
        env={**os.environ, **environment},
        check=False,
    )


def test_generated_pairs_stand_in_for_the_data(tmp_path):
    path = tmp_path / "smoke.json"
    done = run("--smoke", "--threads", "2", "--failures", "--json", str(path), EMTR_DATA="/nowhere")
    assert done.returncode == 0, done.stderr
    assert "EMTR_DATA=/nowhere is not there: the generated pairs in" in done.stdout
    value = json.loads(path.read_text())
    assert [(r["index"], r["error"]) for r in value["runs"]] == 2 * [(0, None), (1, None)]
    # Easy pairs: poses near the truth show that nothing between file and score is reversed.
    assert all(r["joint"] for r in value["runs"])


def test_the_real_library_keeps_to_the_papers_formula():
    done = run("--smoke", "--queries", "--require", "--threads", "2", EMTR_DATA="/nowhere")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "2 of 2 pairs PASS" in done.stdout


def test_queries_are_counted_over_all_iterations_where_the_evolution_would_end_early():
    done = run("--smoke", "--queries", "--preset", "default", EMTR_DATA="/nowhere")
    rows = [
        line.split() for line in done.stdout.splitlines() if line.endswith(("  PASS", "  FAIL"))
    ]
    assert len(rows) == 2, done.stdout + done.stderr
    for _, _, _, formula, counted, without, counted_without, *_ in rows:
        assert formula == counted and without == counted_without


def test_unknown_settings_are_refused_by_name():
    done = run("--smoke", "--set", "popluation=3", EMTR_DATA="/nowhere")
    assert done.returncode == 2 and "did you mean population" in done.stderr


def test_data_that_are_asked_for_and_not_there_are_no_reason_for_others():
    done = run("--data", "/nowhere")
    assert done.returncode == 2 and done.stderr.startswith("accuracy: --data /nowhere: no such")


def test_the_library_is_told_where_the_sensors_stood(pair):
    options = runner.Options(preset="fast", threads=2, settings={"iterations": 3})
    for sensors in (None, runner.Sensors(np.array([1.0, 2.0, 3.0]), np.zeros(3))):
        outcome = PyemtrEngine().register(pair.source, pair.target, options, sensors)
        places = [outcome.settings[f"{side}_viewpoint"] for side in ("source", "target")]
        assert places == ([None, None] if sensors is None else [[1, 2, 3], [0, 0, 0]])
        assert outcome.settings["iterations"] == 3 and 0 < outcome.quality["confidence"] <= 1
