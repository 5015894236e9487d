"""tools/bench/report: which parts it runs, and what it says of those that fail."""

import argparse

import pytest
from emtr_bench.locations import REPOSITORY
from emtr_bench.report import arguments, program, running
from emtr_bench.report.parts import NAMES, Part


def script(folder, name, body):
    path = folder / name
    path.write_text(f"#!/bin/sh\n{body}\n")
    path.chmod(0o755)
    return path


def test_a_part_that_wrote_nothing_loses_its_old_figures(tmp_path):
    path = tmp_path / "x.json"
    good = script(tmp_path, "good", f"echo '{{}}' > {path}; exit 1")
    bad = script(tmp_path, "bad", "exit 3")
    part = Part("x", "regress", (str(good),), path)
    assert running.run(part) == "" and running.kept(part).status == 1
    assert running.kept(part).machine["cpu"]
    failure = running.run(Part("x", "regress", (str(bad), "--now"), path))
    assert failure == f"{bad} --now: ended with 3 and wrote no {path}"
    assert running.kept(part) is None and not path.exists()


@pytest.mark.parametrize(
    ("only", "ran"), [(None, list(NAMES)), (["regress"], ["regress"]), ([], [])]
)
def test_only_what_is_asked_for_is_run(tmp_path, monkeypatch, only, ran):
    seen = []
    monkeypatch.setattr(program, "_run", lambda part: seen.append(part.section) or "")
    asked = argparse.Namespace(only=only, smoke=True, sweep=False)
    out = tmp_path / "BENCHMARK.md"
    assert program.make(tmp_path, tmp_path, out, ["paper"], asked) == 0
    there = [name for name in ran if (REPOSITORY / "tools" / "bench" / name).exists()]
    assert seen == there and out.read_text().startswith("# Benchmarks")
    assert not list(tmp_path.glob("*.part"))


@pytest.fixture
def report(tmp_path, monkeypatch):
    """The command, in a repository without any benchmark."""
    monkeypatch.setattr(program, "REPOSITORY", tmp_path)
    monkeypatch.setattr(running, "REPOSITORY", tmp_path)
    return lambda *words: program.report(arguments.parser().parse_args(words))


def test_the_page_alone(report, tmp_path):
    assert report("--only", "--presets", "paper") == 0
    assert (tmp_path / "BENCHMARK.md").read_text().startswith("# Benchmarks")


@pytest.mark.parametrize(("smoke", "status"), [((), 1), (("--smoke",), 0)])
def test_a_benchmark_that_is_not_there(report, tmp_path, capsys, smoke, status):
    assert report("--only", "regress", "--out", str(tmp_path / "page.md"), *smoke) == status
    assert "left out: there is no tools/bench/regress" in capsys.readouterr().out
    assert "Not measured" in (tmp_path / "page.md").read_text()
    assert not (tmp_path / "BENCHMARK.md").exists()


@pytest.mark.parametrize(
    "code",
    ["exit 3", """echo '{"toolchain": {}, "programs": {}}' >build/bench/regress.json; exit 1"""],
)
def test_a_benchmark_that_fails(report, tmp_path, capsys, code):
    (tmp_path / "tools" / "bench").mkdir(parents=True)
    script(tmp_path / "tools" / "bench", "regress", code)
    assert report("--only", "regress") == 1
    assert "report: tools/bench/regress --json" in capsys.readouterr().err


def test_a_preset_that_there_is_not(report, tmp_path, capsys):
    assert report("--presets", "paper", "better") == 2
    assert "report: --presets better: no such preset" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
