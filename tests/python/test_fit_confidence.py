"""The fit of the confidence: its samples by hand, a known model found again, whole runs."""

import json
import math

import accuracy_fakes
import numpy as np
import pytest
from accuracy_fakes import FakeEngine
from emtr_bench.fit_confidence import program
from emtr_bench.fit_confidence.arguments import parser
from emtr_bench.fit_confidence.model import fit
from emtr_bench.fit_confidence.samples import Pose, Sample, features, read, samples
from emtr_bench.pairs import DataError

RIGHT = Pose(0.9, 0.8, 0.02, 100.0, True)
WRONG = Pose(0.5, 0.7, 0.07, 50.0, False)
WORSE = Pose(0.2, 0.4, 0.0, 10.0, False)


def test_terms_by_hand():
    gap, violation, evidence = features([RIGHT, WRONG])
    assert gap == pytest.approx(math.log(0.4)) and evidence == pytest.approx(math.log(100))
    assert violation == pytest.approx(math.sqrt(0.025))
    alone = features([Pose(0.0, 0.0, 0.0, 0.0, False)])
    assert alone == (math.log(1e-3), 0.0, 0.0)


def test_a_run_with_right_poses_says_what_its_answer_would_have_been_without():
    found = samples("lidar", [RIGHT, WRONG, RIGHT, WORSE])
    assert found == [
        Sample("lidar", features([RIGHT, WRONG]), True),
        Sample("lidar", features([WRONG, WORSE]), False, True),
    ]
    assert samples("lidar", [WRONG, WORSE]) == [Sample("lidar", features([WRONG, WORSE]), False)]
    rival = Pose(0.85, 0.9, 0.0, 90.0, False)
    assert samples("lidar", [RIGHT, rival]) == [Sample("lidar", features([rival]), False, True)]
    assert samples("lidar", [RIGHT]) == [Sample("lidar", features([RIGHT]), True)]


def drawn(count, bias, weights):
    rng = np.random.default_rng(5)
    made = []
    for index in range(count):
        terms = rng.normal(size=3)
        probability = 1 / (1 + math.exp(-bias - float(terms @ weights)))
        made.append(Sample(f"source {index % 7}", tuple(terms), bool(rng.random() < probability)))
    return made


def test_finds_a_known_model_again_and_is_calibrated_on_sources_not_seen():
    weights = np.array([1.5, -2.0, 0.5])
    found = fit(drawn(6000, 0.4, weights), 0.5, 10)
    assert found.bias == pytest.approx(0.4, abs=0.15)
    assert found.weights == pytest.approx(weights, abs=0.2)
    assert found.figures is not None
    assert found.figures.runs == 6000 and found.figures.error < 0.03 and found.figures.auc > 0.85


def test_one_source_gives_no_figures():
    one = [Sample("one", made.features, made.right) for made in drawn(50, 0.0, np.ones(3))]
    assert fit(one, 0.5, 10).figures is None


@pytest.fixture
def runs(tmp_path, monkeypatch):
    monkeypatch.setenv("EMTR_DATA", str(accuracy_fakes.write_data(tmp_path)))
    path = tmp_path / "runs.json"
    words = ["--tier", "all", "--transforms", "3", "--unrelated", "2", "--json", str(path)]
    accuracy_fakes.run_accuracy(words, FakeEngine(spoiled={1: (90.0, 0.0)}))
    return path


def test_reads_runs_and_leaves_pairs_out(runs):
    found = read([runs])
    # Nine runs, of which six are right and have a wrong alternative; and two unrelated.
    assert len(found) == 9 + 6 + 2 and sum(sample.right for sample in found) == 6
    assert {sample.source for sample in found} == {"objects", "rooms", "unrelated"}
    assert {sample.source for sample in read([runs], ["hall"])} == {"objects", "unrelated"}
    with pytest.raises(DataError, match="both right and wrong"):
        read([runs], ["duck", "hare", "hall"])


def test_prints_and_writes_the_model(runs, tmp_path, capsys):
    path = tmp_path / "model.json"
    words = [str(runs), "--json", str(path)]
    assert program.fit_confidence(parser().parse_args(words), FakeEngine()) == 0
    printed = capsys.readouterr().out
    assert "fitted to 17 answers of 3 sources" in printed and "log_gap" in printed
    assert "on sources not seen: 17 runs, 2 of them" in printed
    value = json.loads(path.read_text())
    assert len(value["weights"]) == 3 and value["figures"]["runs"] == 17


def test_makes_the_runs_when_it_is_given_none(runs, capsys):
    assert program.fit_confidence(parser().parse_args(["--smoke"]), FakeEngine()) == 0
    assert "fitted to" in capsys.readouterr().out


def test_an_error_names_this_program_and_not_the_one_that_it_runs(runs, capsys):
    assert program.fit_confidence(parser().parse_args(["--tier", "nice"]), FakeEngine()) == 2
    assert capsys.readouterr().err.startswith("fit_confidence: --tier nice: no such tier")


def test_what_is_no_such_file_is_named(tmp_path, capsys):
    other = tmp_path / "other.json"
    other.write_text('{"benchmark": "stages"}')
    assert program.fit_confidence(parser().parse_args([str(other)]), FakeEngine()) == 2
    assert "other.json: not written by accuracy" in capsys.readouterr().err
