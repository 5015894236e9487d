"""Scans that do not belong together: which they are, and what is said when one is taken."""

import json

import accuracy_fakes
import numpy as np
import pytest
from accuracy_fakes import FakeEngine, Options
from emtr_bench import layout, pairings, pairs, unrelated


@pytest.fixture
def data(tmp_path, monkeypatch):
    folder = accuracy_fakes.write_data(tmp_path / "data")
    monkeypatch.setenv("EMTR_DATA", str(folder))
    return folder


def named(*names):
    return [pairs.Pair(name, "standard", None) for name in names]


def test_no_two_scans_of_one_object_are_paired():
    found = pairings.choose(named("bunny_045_000", "goicp_bunny", "trex_01_05", "bimba_n0_02"), 10)
    both = {(p.source.name, p.target.name) for p in found}
    assert len(both) == 10  # of twelve, less the two of the bunny
    assert ("bunny_045_000", "goicp_bunny") not in both
    assert ("goicp_bunny", "bunny_045_000") not in both
    assert ("trex_01_05", "bimba_n0_02") in both


def test_the_choice_is_always_the_same_and_a_longer_one_goes_on():
    names = ("bunny_1", "trex_01_05", "bimba_n0_02", "kitti_05_00")
    short, long = (pairings.choose(named(*names), count) for count in (3, 12))
    assert short == long[:3]
    assert [p.name for p in pairings.choose(named(*reversed(names)), 12)] == [p.name for p in long]


def test_clouds_are_of_one_size_and_moved(data):
    (one, two, _) = layout.read_folder(data)
    pairing = pairings.Pairing(3, one, two)
    source, target = pairings.clouds(pairing)
    radii = [np.linalg.norm(c - c.mean(axis=0), axis=1).max() for c in (source, target)]
    assert radii[0] == pytest.approx(radii[1])
    np.testing.assert_array_equal(target, pairs.load(two).target)
    again, _ = pairings.clouds(pairing)
    other, _ = pairings.clouds(pairings.Pairing(4, one, two))
    np.testing.assert_array_equal(again, source)
    assert not np.allclose(other, source)


def test_each_has_its_seed_and_a_crash_is_one_lost_run(data):
    chosen = pairings.choose(layout.read_folder(data), 4)
    engine = FakeEngine(spoiled={7: (9.0, 0.0)}, crashing=(8,))
    runs = list(unrelated.run_all(chosen, engine.register, Options(seed=6), 1))
    assert [run.seed for run in runs] == [6, 7, 8, 9]
    assert [run.registered for run in runs] == [True, False, False, True]
    assert "not to my taste" in runs[2].error and "CRASHED: 1 runs" in unrelated.text(runs)
    two = list(unrelated.run_all(chosen, engine.register, Options(seed=6), 2))
    assert [run.registered for run in two] == [run.registered for run in runs]


def test_those_taken_are_named_and_miss_the_mark(data, tmp_path, capsys):
    path = tmp_path / "runs.json"
    argv = ["--transforms", "1", "--tier", "all", "--unrelated", "3", "--require"]
    engine = FakeEngine(spoiled={1: (9.0, 0.0)})
    assert accuracy_fakes.run_accuracy([*argv, "--json", str(path)], engine) == 1
    output = capsys.readouterr().out
    assert "unrelated scans: 2 of 3 called registered (none should be)" in output
    assert "seed 0: confidence 0.750" in output and "seed 1: confidence" not in output
    assert "marks: 2 of 3 unrelated scans called registered" in output
    value = json.loads(path.read_text())
    assert [run["registered"] for run in value["unrelated"]] == [True, False, True]
    assert value["unrelated"][0]["source"] != value["unrelated"][0]["target"]
    assert len(value["runs"]) == 3

    engine = FakeEngine(spoiled={1: (9.0, 0.0), 2: (9.0, 0.0), 3: (9.0, 0.0)})
    assert (
        accuracy_fakes.run_accuracy([*argv, "--seed", "1"], engine) == 1
    )  # the poses are wrong too
    assert "unrelated scans: 0 of 3" in capsys.readouterr().out


def test_fewer_pairings_than_asked_for_are_told(data, capsys):
    assert accuracy_fakes.run_accuracy(["--transforms", "1", "--unrelated", "9"], FakeEngine()) == 0
    output = capsys.readouterr().out
    assert "--unrelated 9: the chosen pairs make 2 pairings" in output and "of 2 called" in output


def test_a_pair_without_a_pose_is_unrelated(data, tmp_path, capsys):
    (data / "pairs" / "objects" / "hare" / "T_gt.txt").write_text("none\n")
    path = tmp_path / "runs.json"
    words = ["--transforms", "1", "--tier", "all", "--json", str(path)]
    assert accuracy_fakes.run_accuracy(words, FakeEngine()) == 0
    output = capsys.readouterr().out
    assert "unrelated scans: 1 of 1 called registered" in output and "  hare seed 0" in output
    value = json.loads(path.read_text())
    assert [run["pair"] for run in value["runs"]] == ["hall", "duck"]
    assert [(run["source"], run["target"]) for run in value["unrelated"]] == [("hare", "hare")]
    assert accuracy_fakes.run_accuracy(["--pair", "hare"], FakeEngine()) == 2
    assert "none of the chosen pairs has a pose" in capsys.readouterr().err


def test_a_crash_ends_with_1(data, capsys):
    argv = ["--transforms", "1", "--unrelated", "2"]
    assert accuracy_fakes.run_accuracy(argv, FakeEngine(crashing=(1,))) == 1
    assert accuracy_fakes.run_accuracy(argv, FakeEngine()) == 0
