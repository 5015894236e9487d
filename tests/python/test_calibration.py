"""The calibration: its figures by hand, the files it reads, and a run with a made-up library."""

import json
import math

import accuracy_fakes
import numpy as np
import pytest
from accuracy_fakes import FakeEngine
from emtr_bench.calibration import program
from emtr_bench.calibration.arguments import parser
from emtr_bench.calibration.figures import calibration, share
from emtr_bench.calibration.judged import Judged, read
from emtr_bench.pairs import DataError


def drawn(count, honest, seed=0):
    """Runs that are right as often as their confidence says, or than its square says."""
    rng = np.random.default_rng(seed)
    confidence = rng.uniform(size=count)
    right = rng.uniform(size=count) < (confidence if honest else confidence**2)
    return [Judged(float(c), bool(r), bool(c > 0.5), True) for c, r in zip(confidence, right)]


def test_bins_and_errors_by_hand():
    runs = [Judged(0.0, False, False, False), Judged(0.4, True, False, True),
            Judged(0.5, False, True, True), Judged(0.9, True, True, True),
            Judged(1.0, True, True, True)]  # fmt: skip
    found = calibration(runs, 2)
    assert (found.runs, found.right, found.unrelated) == (5, 3, 1)
    low, high = found.bins
    assert (low.low, low.high, low.count, high.count) == (0.0, 0.5, 2, 3)
    assert low.confidence == pytest.approx(0.2) and low.right.value == 0.5
    assert high.confidence == pytest.approx(0.8) and high.right.value == pytest.approx(2 / 3)
    assert found.error == pytest.approx((2 * 0.3 + 3 * (0.8 - 2 / 3)) / 5)
    assert found.brier == pytest.approx((0.0 + 0.36 + 0.25 + 0.01 + 0.0) / 5)
    assert found.auc == pytest.approx(5 / 6)  # only 0.4 against 0.5 is the wrong way round
    assert found.precision.value == found.recall.value == pytest.approx(2 / 3)


def test_an_honest_confidence_has_no_error_and_a_boast_has():
    honest, boast = (calibration(drawn(20000, kind), 10) for kind in (True, False))
    assert honest.error < 0.02 and boast.error == pytest.approx(1 / 6, abs=0.02)
    inside = [row.right.low <= row.confidence <= row.right.high for row in honest.bins]
    assert sum(inside) >= 8  # of ten intervals of 95 %
    assert not any(row.right.low <= row.confidence <= row.right.high for row in boast.bins[2:8])


def test_wilsons_interval():
    # R: prop.test(8, 10, correct = FALSE)
    found = share(8, 10)
    assert (found.value, found.low, found.high) == (
        0.8, pytest.approx(0.4901625, abs=1e-6), pytest.approx(0.9433178, abs=1e-6))  # fmt: skip
    assert share(5, 5).high == 1.0 and share(0, 5).low == 0.0
    assert math.isnan(share(0, 0).value)


def test_an_empty_bin_and_a_missing_kind_are_no_numbers():
    found = calibration([Judged(0.95, True, True, True)], 10)
    assert [row.count for row in found.bins] == [0] * 9 + [1]
    assert math.isnan(found.bins[0].confidence) and math.isnan(found.auc)
    assert found.error == pytest.approx(0.05)


@pytest.fixture
def data(tmp_path, monkeypatch):
    monkeypatch.setenv("EMTR_DATA", str(accuracy_fakes.write_data(tmp_path)))


@pytest.fixture
def files(data, tmp_path):
    """Two files of preset default, one of them with unrelated scans, and one of paper."""
    paths = [tmp_path / f"{name}.json" for name in ("a", "b", "paper")]
    words = [["--seed", "0", "--unrelated", "2"], ["--seed", "5"], ["--preset", "paper"]]
    for path, more in zip(paths, words):
        engine = FakeEngine(spoiled={1: (90.0, 0.0)}, crashing=(2,))
        accuracy_fakes.run_accuracy(
            ["--tier", "all", "--transforms", "4", "--json", str(path), *more], engine
        )
    return paths


def test_files_of_one_preset_are_taken_together(files):
    found = read(files)
    assert list(found) == ["default"]  # paper gives no confidence
    runs = found["default"]
    # Three pairs by four motions each, of which one in the first file crashed; and two unrelated.
    assert len(runs) == 3 * 3 + 2 + 3 * 4
    assert sum(not run.related for run in runs) == 2
    assert not any(run.joint for run in runs if not run.related)
    assert {run.confidence for run in runs} == {0.25, 0.75}
    with pytest.raises(DataError, match="no run has a confidence"):
        read(files[2:])


def test_what_is_no_such_file_is_named(tmp_path):
    other = tmp_path / "other.json"
    other.write_text('{"benchmark": "stages"}')
    with pytest.raises(DataError, match=r"other\.json: not written by accuracy"):
        read([other])
    other.write_text("no JSON")
    for path in (other, tmp_path / "none.json"):
        with pytest.raises(DataError, match=path.name):
            read([path])


def test_prints_and_writes_what_it_found(files, tmp_path, capsys):
    pytest.importorskip("matplotlib")
    plot, path = tmp_path / "c.png", tmp_path / "c.json"
    words = [*map(str, files), "--bins", "4", "--json", str(path), "--plot", str(plot)]
    assert program.calibration(parser().parse_args(words), FakeEngine()) == 0
    printed = capsys.readouterr().out
    assert "preset default: 23 runs, 2 of them of scans" in printed
    assert "0.25 to 0.50" in printed and "expected calibration error" in printed
    value = json.loads(path.read_text())["presets"]["default"]
    assert value["runs"] == 23 and len(value["bins"]) == 4
    assert value["bins"][0]["confidence"] is None  # no run
    assert plot.read_bytes().startswith(b"\x89PNG") and not list(tmp_path.glob("*.part"))


def test_makes_the_runs_when_it_is_given_none(data, capsys):
    words = ["--transforms", "2", "--unrelated", "1", "--presets", "default"]
    assert program.calibration(parser().parse_args(words), FakeEngine()) == 0
    printed = capsys.readouterr().out
    assert "preset default: 7 runs, 1 of them" in printed
    assert program.calibration(parser().parse_args(["--presets", "paper"]), FakeEngine()) == 2
    crashed = program.calibration(parser().parse_args(words), FakeEngine(crashing=(1,)))
    assert crashed == 1


@pytest.mark.parametrize(
    "words", [["--data", "/nowhere"], ["--presets", "best"], ["--tier", "nice"], ["none.json"]]
)
def test_an_error_names_this_program_and_not_the_one_that_it_runs(data, capsys, words):
    assert program.calibration(parser().parse_args(words), FakeEngine()) == 2
    assert capsys.readouterr().err.startswith("calibration: ")


def test_the_pairs_are_chosen_as_elsewhere(data, capsys):
    words = ["--transforms", "2", "--pair", "duck", "hare"]
    assert program.calibration(parser().parse_args(words), FakeEngine()) == 0
    assert "preset default: 6 runs, 2 of them" in capsys.readouterr().out
