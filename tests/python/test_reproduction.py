"""The reproduction of the paper: the log that it resumes from, its tables, tests and report."""

import json

import numpy as np
import pytest
from accuracy_fakes import REPOSITORY
from emtr_bench.pairs import DataError
from emtr_bench.reproduce import claims, plan, published, significance, tables
from emtr_bench.reproduce.figures_of_runs import mean_over_pairs, percent, spread
from emtr_bench.reproduce.published import Published
from emtr_bench.reproduce.run_log import RunLog
from emtr_bench.reproduce.table import Cell, Table
from evolving_methods.methods import METHODS


def record(section, method, pair="bunny", index=0, row="Bunny", **figures):
    values = {"E_R": 0.5, "E_t": 0.01, "seconds": 1.0, "evolution_seconds": 0.5, "queries": 10**7}
    return {"section": section, "method": method, "pair": pair, "index": index, "row": row,
            "tier": "paper", **values, **figures}  # fmt: skip


def test_a_log_goes_on_after_an_interruption(tmp_path):
    path = tmp_path / "runs.jsonl"
    log = RunLog(path, {"seed": 0})
    log.append([record("library", plan.OURS, index=i, E_R=np.float64(i)) for i in range(3)])
    log.close()
    with path.open("a") as file:
        file.write('{"section": "library", "me')  # the power went
    log = RunLog(path, {"seed": 0})
    assert [r["E_R"] for r in log.records] == [0.0, 1.0, 2.0]
    assert log.has(("library", plan.OURS, "bunny", 2))
    assert not log.has(("library", plan.OURS, "bunny", 3))
    log.append([record("library", plan.OURS, index=3, E_R=float("nan"))])
    log.close()
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    assert len(lines) == 5 and lines[-1]["E_R"] is None


def test_a_log_of_other_options_is_refused(tmp_path):
    RunLog(tmp_path / "runs.jsonl", {"seed": 0}).close()
    with pytest.raises(DataError, match=r"runs\.jsonl: it was made with other options"):
        RunLog(tmp_path / "runs.jsonl", {"seed": 1})


def test_a_log_with_a_bad_line_is_refused_by_its_number(tmp_path):
    path = tmp_path / "runs.jsonl"
    path.write_text('{"options": {}}\nnot json\n')
    with pytest.raises(DataError, match="line 2 is no JSON"):
        RunLog(path, {})


def test_only_what_is_missing_is_run(tmp_path, monkeypatch):
    from emtr_bench.pairs import Pair
    from emtr_bench.reproduce import execute

    pair = Pair("bunny", "paper", tmp_path, "Bunny")
    done = []

    def library(method, work, context):
        done.append(method)
        return {"E_R": 1.0}

    monkeypatch.setitem(execute._SECTIONS, "library", library)
    log = RunLog(tmp_path / "runs.jsonl", {})
    log.append([record("library", "a")])
    work = plan.Work(pair, 0, (("library", "a"), ("library", "b")))
    execute.execute([work], plan.Context(), log, 1)
    assert done == ["b"] and [r["method"] for r in log.records] == ["a", "b"]
    log.close()


def test_published_figures():
    assert published.value("errors_alpha_beta", "Bunny", "E_R_alpha") == Published(0.233, 0.12)
    assert published.value("sparse_to_dense", "7a (stand-in)", "ratio") == Published(51.1)
    assert published.value("errors_vs_traditional", "Armadillo", "ICP+", metric="E_R_deg") is None
    assert published.value("success_ratio", "my pair", "average_success_ratio_percent") is None
    names = {row["method"] for row in published.table("success_ratio")}
    assert {method.name for method in METHODS} | {plan.OURS} == names


def test_means_are_over_successes_and_over_pairs():
    runs = [record("library", plan.OURS, "a", i, E_R=e) for i, e in enumerate((1.0, 3.0, 90.0))]
    runs += [record("library", plan.OURS, "b", 0, E_R=None)]
    assert spread(runs, "E_R") == Published(2.0, np.sqrt(2.0))
    assert percent(runs) == 50.0
    assert mean_over_pairs(runs, percent) == pytest.approx(100.0 / 3.0)
    assert spread(runs[2:], "E_R") is None


def test_a_cell_has_both_figures_and_the_csv_too():
    cell = Cell(Published(0.5, 0.1), Published(0.233, 0.12))
    table = Table("t", "T", ["data", "E_R"], [("Bunny", [cell])])
    assert table.markdown().splitlines()[-1] == "| Bunny | 0.500±0.100 (0.233±0.120) |"
    assert table.csv().splitlines() == ["data,E_R,E_R std,E_R paper,E_R paper std",
                                        "Bunny,0.5,0.1,0.233,0.12"]  # fmt: skip
    assert Cell(None, 1.0).text() == "- (1.000)" and Cell(float("nan")).text() == ""


def some_runs():
    found = []
    for pair in ("a", "b", "c", "d", "e", "f"):
        for i in range(2):
            found += [
                record("library", plan.OURS, pair, i, E_R=0.4 + 0.01 * i),
                record("library", plan.DENSE_ONLY, pair, i, queries=2 * 10**7),
                record("evolving", "PSO", pair, i, E_R=90.0, fitness=0.9),
                record("tasks", plan.PYTHON, pair, i, E_R_beta=2.0 + i, E_t_beta=0.02, E_R=0.4),
            ]
    return found


def test_tables_of_runs():
    made = {table.name: table for table in tables.made(some_runs())}
    ratio = dict(made["sparse_to_dense"].rows)["Bunny"][-1]
    assert ratio.ours == pytest.approx(50.0) and ratio.paper == Published(48.7)
    success = {name: cells[0].ours for name, cells in made["success_ratio"].rows}
    assert success["PSO"] == 0.0 and success[f"**{plan.OURS}**"] == 100.0
    beta = made["errors_alpha_beta"].rows[0][1][0]
    assert beta.ours.mean == pytest.approx(2.5) and beta.paper == Published(1.284, 0.847)
    assert "errors_vs_traditional" not in made and "sweep" not in made
    assert tables.lower_in(made["sparse_to_dense"], 0) == (0, 6)


def test_claims_are_tested_pair_by_pair():
    found = {test.claim: test for tests in claims.families(some_runs()).values() for test in tests}
    won = found["higher success than PSO, by pair"]
    assert won.count == 6 and won.median_difference == 100.0 and won.p == pytest.approx(1 / 64)
    assert found["alpha's E_R is below beta's"].p < 0.01


def test_holm():
    assert significance.holm([0.01, 0.04, 0.03]) == pytest.approx([0.03, 0.06, 0.06])
    assert significance.holm([0.9, 0.8]) == [1.0, 1.0]
    same = significance.tested([significance.Claim("same", [1.0, 1.0], [1.0, 1.0], "less")])
    assert same[0].p == 1.0 and same[0].verdict == "not significant"


def test_the_paper_has_one_set_of_figures():
    """The accuracy benchmark's own list has the same."""
    from emtr_bench.paper_tables import MEAN_SUCCESS, ROWS

    for name, row in ROWS.items():
        found = published.value("sparse_to_dense", name, "E_R_with")
        assert found == Published(*row.rotation)
        assert published.value("sparse_to_dense", name, "NN_with") == Published(row.queries)
    average = published.value("success_ratio", plan.OURS, "average_success_ratio_percent")
    assert average == Published(MEAN_SUCCESS)


def test_the_command_is_a_program():
    assert (REPOSITORY / "tools" / "bench" / "reproduce").stat().st_mode & 0o111
