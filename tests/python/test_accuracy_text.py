"""The benchmark from the command line inwards: tables, JSON, exit codes."""

import json
import subprocess
import sys

import accuracy_fakes
import pytest
from accuracy_fakes import REPOSITORY, FakeEngine
from emtr_bench import accuracy_text, arguments, interpreter, queries, records


@pytest.fixture
def data(tmp_path, monkeypatch):
    folder = accuracy_fakes.write_data(tmp_path / "data")
    monkeypatch.setenv("EMTR_DATA", str(folder))
    return folder


def table_row(output, name):
    (line,) = (line for line in output.splitlines() if line.startswith(name))
    return line.split()


def test_the_table_puts_ours_beside_the_papers(data, capsys):
    assert (
        accuracy_fakes.run_accuracy(["--transforms", "5"], FakeEngine(spoiled={3: (90.0, 0.0)}))
        == 0
    )
    output = capsys.readouterr().out
    assert max(len(line) for line in output.splitlines()) <= 160
    hare = table_row(output, "hare")
    assert hare[1:4] == ["Bunny", "80.0", "80.0"]
    assert hare[7] == "0.233±0.120" and hare[9] == "0.175±0.085" and hare[12] == "8.42"
    assert hare[14:] == ["100.0", "100.0", "65.0"]
    assert table_row(output, "hall")[1] == "7a"
    assert table_row(output, "mean")[1:5] == ["2", "pairs", "80.0", "80.0"]
    paper = table_row(output, "  the paper's")
    assert paper[2:5] == ["2", "rows", "87.7"] and paper[-1] == "7.39"
    assert "lowest row: hare 80.0 % (the paper's lowest: 75 %)" in output
    assert "LRxLT 0 %" in output and "SRxST 100 %" in output
    assert "duck" not in output


def test_columns_are_aligned(data, capsys):
    assert accuracy_fakes.run_accuracy(["--transforms", "2", "--tier", "all"], FakeEngine()) == 0
    lines = capsys.readouterr().out.splitlines()
    heads = next(line for line in lines if line.startswith("pair"))
    for name in ("hare", "duck", "mean", "  mean of paper"):
        line = next(line for line in lines if line.startswith(name))
        for head in ("joint%", "+alt%", "median", "sec", "rec%", "conf%"):
            end = heads.index(head) + len(head)
            assert line[end - 1].strip() and not line[end : end + 1].strip(), (name, head)


def test_every_tier_has_a_mean_when_there_are_several(data, capsys):
    assert accuracy_fakes.run_accuracy(["--transforms", "1", "--tier", "all"], FakeEngine()) == 0
    output = capsys.readouterr().out
    assert "  mean of paper" in output and "  mean of standard" in output
    # Published figures stand below the mean of published rows only.
    assert output.count("the paper's  ") == 1


def test_the_json_holds_every_run(data, tmp_path, capsys):
    path = tmp_path / "runs.json"
    engine = FakeEngine(spoiled={1: (20.0, 0.0)}, crashing=(2,))
    assert accuracy_fakes.run_accuracy(["--transforms", "3", "--json", str(path)], engine) == 1
    value = json.loads(path.read_text())
    assert len(value["runs"]) == 6 and [p["pair"] for p in value["pairs"]] == ["hare", "hall"]
    good, bad, lost = value["runs"][:3]
    assert (good["pair"], good["index"], good["class"], good["seed"]) == ("hare", 0, "SRxST", 0)
    assert good["joint"] is True and good["reason"] == "registered" and good["fitness_gap"] == 0.125
    assert good["inlier_rmse"] is None  # NaN is no JSON
    assert good["queries"]["complement"] == 9 and good["seconds"] == {"total": 0.5}
    assert len(good["T_est"]) == len(good["T_true"]) == 4
    assert bad["E_R"] == pytest.approx(20.0, abs=1e-3) and bad["joint"] is False
    assert lost["T_est"] is None and lost["E_R"] is None and "not to my taste" in lost["error"]
    assert value["pairs"][0]["crashed"] == 1
    assert value["pairs"][0]["paper"]["queries"] == 8.42
    assert value["mean"]["success"] == pytest.approx(100 / 3)
    assert (good["confidence"], bad["confidence"]) == (0.75, 0.25)
    assert value["mean"]["auc"] == 1.0 and value["unrelated"] == []
    assert len(good["alternatives"]) == 1 and good["among_alternatives"] is False
    assert value["options"]["preset"] == "default" and value["emtr_version"] == "0.0.fake"
    assert "CRASHED: 2 runs" in capsys.readouterr().out


def test_the_footer_judges_the_verdict(data, capsys):
    # Right: 0, 1 and 4. Of the spoiled, 2 is held right, and 3 has the truth as an alternative.
    engine = FakeEngine(spoiled={2: (9.0, 0.0), 3: (9.0, 0.0)}, sure=(2,), aware=(2, 3))
    assert accuracy_fakes.run_accuracy(["--pair", "hare", "--transforms", "5"], engine) == 0
    output = capsys.readouterr().out
    assert table_row(output, "hare")[2:5] == ["60.0", "60.0", "80.0"]
    assert "with the truth among the alternatives (+alt%): 80.0 %" in output
    assert "precision 75.0 %, recall 100.0 %" in output
    assert "ROC curve of the confidence 0.750" in output  # 3 of 3 above one, even with the other


def test_without_candidates_there_is_no_confidence(data, capsys):
    assert (
        accuracy_fakes.run_accuracy(["--preset", "paper", "--transforms", "2"], FakeEngine()) == 0
    )
    output = capsys.readouterr().out
    assert table_row(output, "hare")[14:] == ["100.0", "100.0", "-"]
    assert "curve of the confidence -" in output and "preset paper" in output


def test_a_json_that_cannot_be_written_leaves_nothing(tmp_path):
    target = tmp_path / "there" / "runs.json"
    with pytest.raises(FileNotFoundError):
        records.write(target, {"a": 1})
    target = tmp_path / "runs.json"
    with pytest.raises(TypeError):
        records.write(target, {"a": object()})
    assert list(tmp_path.iterdir()) == []


def test_failures_say_whether_the_search_or_the_objective_failed(data, capsys):
    engine = FakeEngine(spoiled={0: (90.0, 0.0), 1: (80.0, 0.0)})
    accuracy_fakes.run_accuracy(["--pair", "hare", "--transforms", "3", "--failures"], engine)
    lines = [line for line in capsys.readouterr().out.splitlines() if line.startswith("  hare[")]
    assert len(lines) == 2
    assert lines[0].startswith("  hare[0] seed 0 SRxST: E_R 90.00") and lines[0].endswith("search")
    assert lines[1].startswith("  hare[1] seed 1 SRxLT: E_R 80.00")
    assert lines[1].endswith("objective")


def test_require_asks_for_the_papers_marks(data, capsys):
    base = ["--transforms", "10", "--require"]
    assert accuracy_fakes.run_accuracy(base, FakeEngine()) == 0
    assert "marks: met" in capsys.readouterr().out
    # 7 of 10 in each row: both the mean and the rows fall short.
    engine = FakeEngine(spoiled=dict.fromkeys(range(3), (90.0, 0.0)))
    assert accuracy_fakes.run_accuracy(base, engine) == 1
    output = capsys.readouterr().out
    assert "mean success 70.0 % < 87.7 %; hare 70.0 % < 75 %; hall 70.0 % < 75 %" in output
    assert accuracy_fakes.run_accuracy(base[:-1], engine) == 0


def test_queries_are_compared_with_the_formula(data, capsys):
    assert accuracy_fakes.run_accuracy(["--queries"], FakeEngine()) == 0
    output = capsys.readouterr().out
    # 12 sparse of 80 dense: 50 (60 x 12 + 40 x 80) and 50 x 100 x 80.
    assert table_row(output, "hare")[1:] == (
        ["12", "80", "196000", "196000", "400000", "400000", "49.00", "48.7", "PASS"]
    )
    assert "2 of 2 pairs PASS" in output


def test_one_query_too_many_fails(data, capsys):
    assert accuracy_fakes.run_accuracy(["--queries"], FakeEngine(miscounts=1)) == 0
    assert "0 of 2 pairs PASS" in capsys.readouterr().out
    assert accuracy_fakes.run_accuracy(["--queries", "--require"], FakeEngine(miscounts=1)) == 1


@pytest.mark.parametrize(("fraction", "first"), [(0.6, 60), (0.601, 61), (0.0, 0), (1.0, 100)])
def test_the_switch_comes_at_the_ceiling(fraction, first):
    budget = queries.Budget(50, 100, fraction)
    assert budget.with_switch(7, 11) == 50 * (first * 7 + (100 - first) * 11)


@pytest.mark.parametrize(
    ("argv", "message"),
    [
        (["--preset", "best"], "there is no preset 'best'"),
        (["--tier", "nice"], "--tier nice: no such tier"),
        (["--pair", "cow"], "--pair cow: no such pair"),
        (["--queries", "--set", "sparse_to_dense=0"], "do not --set it"),
        (["--queries", "--unrelated", "2"], "no --unrelated"),
        (["--data", "/nowhere"], "--data /nowhere: no such folder"),
        (["--smoke", "--tier", "nice"], "--tier nice: no such tier"),
    ],
)
def test_what_cannot_be_run_is_said_and_ends_with_2(data, capsys, argv, message):
    assert accuracy_fakes.run_accuracy(argv, FakeEngine()) == 2
    captured = capsys.readouterr()
    assert message in captured.err and captured.err.startswith("accuracy: ")


def test_a_missing_file_ends_with_2(data, capsys):
    (data / "pairs" / "objects" / "hare" / "source.ply").unlink()
    assert accuracy_fakes.run_accuracy([], FakeEngine()) == 2
    assert "source.ply: expected a PLY file" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "expected"),
    [("a=1", ("a", 1)), ("a=1.5", ("a", 1.5)), ("a=1e-3", ("a", 1e-3)), ("a=grid", ("a", "grid"))],
)
def test_settings_keep_their_type(text, expected):
    name, value = arguments.setting(text)
    assert (name, value) == expected and type(value) is type(expected[1])


@pytest.mark.parametrize(
    "argv", [["--set", "a"], ["--set", "=1"], ["--set", "a="], ["--transforms", "0"],
             ["--jobs", "-1"], ["--threads", "x"], ["--surprise"]],
)  # fmt: skip
def test_bad_arguments_end_with_2(argv, capsys):
    with pytest.raises(SystemExit) as ended:
        accuracy_fakes.run_accuracy(argv, FakeEngine())
    assert ended.value.code == 2


def test_smoke_takes_the_smallest_two_pairs_twice(data, capsys):
    assert accuracy_fakes.run_accuracy(["--smoke", "--tier", "all"], FakeEngine()) == 0
    output = capsys.readouterr().out
    assert "2 transforms a pair" in output
    assert "hare" in output and "hall" in output and "duck" not in output


def test_help_ends_with_0(capsys):
    with pytest.raises(SystemExit) as ended:
        accuracy_fakes.run_accuracy(["--help"], FakeEngine())
    assert ended.value.code == 0 and "exit code" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("script", "missing"),
    [
        ("bench/accuracy", "pyemtr and no plyfile"),
        ("reproducibility", "numpy and no plyfile and no Cython"),
    ],
)
def test_the_script_says_how_to_get_what_it_lacks(script, missing, tmp_path):
    # A copy elsewhere finds no build/venv to go on with; -S hides what is installed.
    names = (
        "__init__", "arguments", "interpreter", "locations", "pair_arguments", "searched_scales",
    )  # fmt: skip
    for part in (script, *(f"bench/emtr_bench/{name}.py" for name in names)):
        copy = tmp_path / "tools" / part
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text((REPOSITORY / "tools" / part).read_text())
    program = tmp_path / "tools" / script
    done = subprocess.run(
        [sys.executable, "-S", "-E", str(program)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert done.stderr.startswith(f"{program.name}: ") and f"has no {missing}. " in done.stderr
    packages = f"'{tmp_path}[bench]'" if "pyemtr" in missing else "numpy plyfile Cython"
    assert f"-m pip install {packages}\n" in done.stderr
    assert ("tools/quickstart" in done.stderr) == ("pyemtr" in missing)


@pytest.mark.parametrize("inside", [True, False])
def test_the_next_step_is_for_the_environment_that_there_is(inside, monkeypatch, tmp_path):
    monkeypatch.setattr(interpreter, "REPOSITORY", tmp_path)
    monkeypatch.setattr(sys, "base_prefix", "/usr" if inside else sys.prefix)
    with pytest.raises(FileNotFoundError) as told:
        interpreter.python_with("numpy", "no_such_module")
    said, venv = str(told.value), tmp_path / "build" / "venv"
    assert said.startswith(f"{sys.executable} has no no_such_module. ")
    if inside:
        assert said.endswith(f"\n  '{sys.executable}' -m pip install no_such_module")
    else:
        line = f"'{venv}/bin/python' -m pip install numpy no_such_module"
        assert f"\n  python3 -m venv '{venv}' && {line}\n" in said
    (venv / "bin").mkdir(parents=True)
    (venv / "bin" / "python").touch()
    assert interpreter.python_with("no_such_module") == venv / "bin" / "python"


def test_wide_figures_stay_in_their_columns():
    for spread in ((3.36, 10.712), (42.6, 0.5), (119.0, 170.0), (0.1, 0.02)):
        assert len(accuracy_text._spread(accuracy_text.Spread(*spread))) < 12
