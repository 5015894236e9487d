"""Instruction counts: the comparison, the verdict, and what is read out of callgrind."""

import argparse
import json
import shutil
import subprocess
import sys

import pytest
from accuracy_fakes import REPOSITORY
from emtr_bench.regress import counting, program, records, toolchain
from emtr_bench.regress.comparison import Comparison
from emtr_bench.regress.counting import Count
from emtr_bench.regress.programs import PROGRAMS, RegressFailure

LISTING = """\
--------------------------------------------------------------------------------
Ir                      file:function
--------------------------------------------------------------------------------
2,000,000 (100.0%)  ???:main [/b/tools/pcl_emtr]
1,900,000 (95.00%)  ???:emtr_register [/b/libemtr.so]
1,500,000 (75.00%)  ???:emtr::Team::with(int, std::function<void (emtr::Team&)> const&) [/b/l.so]
1,499,000 (74.95%)  ???:emtr::Team::with(int, std::function<void (emtr::Team&)> const&) [clone ._omp_fn.0] [/b/l.so]
  400,000 (20.00%)  ???:emtr::(anonymous namespace)::Grid::squared(emtr::View<float> const&)'2 [/b/l.so]
  300,000 (15.00%)  ???:flann::Index::search(int) [/b/l.so]
      100 ( 0.01%)  ???:emtr::small() [/b/l.so]
"""

TOOLS = {"compiler": "GNU 12", "pcl": "1.13"}


def arguments(**changes):
    return argparse.Namespace(**{"tolerance": 0.03, **changes})


def comparison(before, after):
    return Comparison("a program", Count(before, {}), Count(after, {}))


def test_own_functions_by_their_short_names():
    assert counting.own_functions(LISTING, 1000) == {
        "emtr_register": 1900000,
        "emtr::Team::with": 1500000,
        "emtr::Grid::squared": 400000,
    }


@pytest.mark.parametrize(
    ("after", "status", "said"),
    [(1029, 0, "no program is slower"), (1031, 1, "SLOWER"), (960, 0, "faster by more than 3 %")],
)
def test_the_verdict(capsys, after, status, said):
    assert program._verdict([comparison(1000, after)], [], arguments()) == status
    output = capsys.readouterr().out
    assert said in output
    assert ("tools/bench/regress --update" in output) == (said != "no program is slower")


def test_another_toolchain_is_said_and_not_judged(capsys):
    different = toolchain.differences(TOOLS, {**TOOLS, "compiler": "GNU 14"})
    assert different == ["compiler GNU 12, here GNU 14"]
    assert program._verdict([comparison(1000, 2000)], different, arguments()) == 0
    assert "not judged" in capsys.readouterr().out
    assert toolchain.differences(TOOLS, dict(TOOLS)) == []


def test_functions_that_changed_most_come_first():
    before = Count(10**6, {"emtr::a": 500000, "emtr::b": 300000, "emtr::gone": 10000,
                           "emtr::same": 1000})  # fmt: skip
    after = Count(11 * 10**5, {"emtr::a": 520000, "emtr::b": 380000, "emtr::same": 1001})
    found = Comparison("p", before, after)
    assert found.change == pytest.approx(0.1)
    assert [f[0] for f in found.functions()] == ["emtr::b", "emtr::a", "emtr::gone"]
    first = found.text().splitlines()[1].split()
    assert first[0] == "emtr::b" and first[-5] == "+8.00"


def test_records_survive_a_round_trip_and_bad_ones_are_refused(tmp_path):
    path = tmp_path / "regress.json"
    record = records.Record(TOOLS, {"p": Count(5, {"emtr::f": 3})})
    records.write(path, record)
    assert records.read(path) == record
    path.write_text('{"programs": {}}')
    with pytest.raises(RegressFailure, match=r"regress\.json: expected counts made by --update"):
        records.read(path)


def test_the_committed_record_knows_every_program():
    record = records.read(records.FILE)
    assert set(record.counts) == {p.name for p in PROGRAMS}
    for count in record.counts.values():
        assert count.functions["emtr::evolve"] < count.instructions


def run(*argv):
    script = str(REPOSITORY / "tools" / "bench" / "regress")
    return subprocess.run(
        [sys.executable, script, *argv], capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize(
    "argv", [["a", "b", "c"], ["a", "b", "--update"], ["--update", "--only", PROGRAMS[0].name],
             ["--only", "nothing"], ["--tolerance", "-1"]],
)  # fmt: skip
def test_bad_arguments_end_with_2(argv):
    done = run(*argv)
    assert done.returncode == 2 and "regress: error:" in done.stderr


def test_a_build_without_the_command_is_named(tmp_path):
    done = run(str(tmp_path))
    assert done.returncode == 2 and f"no {tmp_path}/tools/pcl_emtr" in done.stderr


@pytest.mark.skipif(shutil.which("valgrind") is None, reason="no valgrind")
def test_two_builds_are_counted_and_compared(tmp_path):
    """Two stand-ins for the command, one of which does half as much again."""
    compiler = shutil.which("c++") or pytest.skip("no compiler")
    for name, rounds in (("before", 1000000), ("after", 1500000)):
        place = tmp_path / name / "tools"
        place.mkdir(parents=True)
        (place / "main.cpp").write_text(
            "namespace emtr { __attribute__((noinline)) int spin(int n) "
            "{ volatile int k = 0; while (k < n) k = k + 1; return k; } }\n"
            f"int main() {{ return emtr::spin({rounds}) == {rounds} ? 0 : 1; }}\n"
        )
        subprocess.run(
            [compiler, "-O1", str(place / "main.cpp"), "-o", str(place / "pcl_emtr")], check=True
        )
    builds = [str(tmp_path / name) for name in ("before", "after")]
    one = ["--only", PROGRAMS[0].name]
    slower, faster = run(*builds, *one), run(*reversed(builds), *one)
    assert slower.returncode == 1 and "+50.0" in slower.stdout and "emtr::spin" in slower.stdout
    assert faster.returncode == 0 and "-33.3" in faster.stdout
    path = tmp_path / "counts.json"
    assert run(builds[0], *one, "--json", str(path)).returncode == 0
    assert json.loads(path.read_text())["programs"][PROGRAMS[0].name]["instructions"] > 10**6
