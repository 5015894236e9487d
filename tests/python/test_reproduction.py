"""The reproduction of the paper: the log that it resumes from, its tables, tests and report."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from accuracy_fakes import REPOSITORY
from emtr_bench.pairs import DataError
from emtr_bench.reproduce import (
    claims,
    differences,
    order,
    plan,
    published,
    significance,
    sweep,
    tables,
)
from emtr_bench.reproduce.figures_of_runs import mean_over_pairs, percent, spread
from emtr_bench.reproduce.published import Published
from emtr_bench.reproduce.run_log import RunLog
from emtr_bench.reproduce.table import Cell, Table
from evolving_methods.methods import METHODS

import pyemtr


def record(section, method, pair="bunny", index=0, row="Bunny", **figures):
    values = {
        "E_R": 0.5,
        "E_t": 0.01,
        "seconds": 1.0,
        "cpu": 1.0,
        "cpu_search": 0.5,
        "queries": 10**7,
    }
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


def test_long_sections_have_one_motion_of_each_kind(tmp_path):
    from emtr_bench.pairs import Pair
    from emtr_bench.protocol import CLASSES

    pair = Pair("bunny", "paper", tmp_path, "Bunny")
    sections, names = ("library", "precision", "traditional"), {"traditional": ["FGR"]}
    every = [plan.runs_of(sections, pair, i, [pair], plan.Context(), names) for i in range(20)]
    found = [{section for section, _ in runs} for runs in every]
    assert found == [set(sections)] * len(CLASSES) + [{"library"}] * (20 - len(CLASSES))


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


def test_the_order_of_the_methods_is_beside_the_published_one():
    right = {"PSO": 3, "DEORA": 0, "EMFPCR": 2}  # of four; published: DEORA, EMFPCR, PSO
    runs = [record("library", plan.OURS, pair, i) for pair in ("a", "b") for i in range(20)]
    runs += [
        record("evolving", method, pair, i, E_R=0.4 if i % 4 < count else 90.0)
        for method, count in right.items() for pair in ("a", "b") for i in range(20)
    ]  # fmt: skip
    (said,) = order.text(runs)
    assert "with as many queries: EMTR-SSC 100.0, PSO 75.0, EMFPCR 50.0, DEORA 0.0;" in said
    assert "published: EMTR-SSC 87.7, DEORA 55.0, EMFPCR 39.7, PSO 30.7." in said
    assert "tau is 0.00" in said
    for ahead in ("PSO is ahead of DEORA", "PSO is ahead of EMFPCR", "EMFPCR is ahead of DEORA"):
        assert ahead in said
    runs += [record("evaluations", method, "a", 0) for method in right]
    assert "with as many evaluations: " in order.text(runs)[0]
    assert "No two are swapped" in order.text(runs)[0]
    assert order.text(some_runs()) == []


def test_the_sweep_has_the_errors_of_both_stages():
    runs = [record("sweep", "delta 0.6", "a", i, E_R=0.2, E_R_sparse=1.0 + i) for i in range(2)]
    runs.append(record("sweep", "delta 0.0", "a", 0, E_R=0.3, E_R_sparse=None))
    made = sweep.table(runs)
    rows = {name: [cell.ours for cell in cells] for name, cells in made.rows}
    assert made.columns[2:4] == ["E_R, sparse stage", "E_R"]
    assert rows["delta 0.6"][1].mean == pytest.approx(1.5)
    assert rows["delta 0.6"][2].mean == pytest.approx(0.2)
    assert rows["delta 0.0"][1] is None and rows["delta 0.0"][2].mean == pytest.approx(0.3)


def test_the_sparse_stage_of_a_sweep_is_the_run_stopped_at_the_switch(relief, monkeypatch):
    from emtr_bench.reproduce import cases

    source, target, _ = relief
    seen = {}

    def errors(case, T):
        seen.setdefault("poses", []).append(T)
        return (1.0, 0.1) if len(seen["poses"]) == 2 else (0.5, 0.05)

    case = SimpleNamespace(source=source, target=target)
    monkeypatch.setattr(cases, "moved_pair", lambda pair, index: case)
    monkeypatch.setattr(sweep, "pose_errors", errors)
    found = sweep.run("delta 0.2", None, 0, 3, 1)
    assert (found["E_R"], found["E_R_sparse"], found["E_t_sparse"]) == (0.5, 1.0, 0.1)
    options = {"preset": "paper", "seed": 3, "threads": 1, "switch_fraction": 0.2}
    stopped = pyemtr.register(source, target, callback=lambda p: p.iteration == 20, **options)
    assert stopped.transformation.tobytes() == seen["poses"][1].tobytes()
    none = sweep.run("delta 0.0", None, 0, 3, 1)
    assert none["E_R_sparse"] is None and len(seen["poses"]) == 3


def test_the_mean_over_the_rows_is_told_with_and_without_other_data():
    rows = [("Bunny", 0.2, 0.4), ("7a (stand-in)", 1.0, 0.1)]
    cells = [(row, [Cell(Published(ours), Published(paper))]) for row, ours, paper in rows]
    said = differences.text([], [Table("sparse_to_dense", "", [], cells)])
    assert any("in 1 of 2 rows. Over all rows it is 0.600 (0.250), without other data it is "
               "0.200 (0.400). Section" in line for line in said)  # fmt: skip
    said = differences.text([], [Table("sparse_to_dense", "", [], cells[:1])])
    assert any("1 rows. Over all rows it is 0.200 (0.400). Section" in line for line in said)


def test_pictures_have_each_method_once_and_ours_the_last(tmp_path):
    from emtr_bench.reproduce import scenes

    T = np.eye(4).tolist()
    pair = SimpleNamespace(name="bunny", paper_row="Bunny")
    runs = [record("library", plan.OURS, T=T), record("library", plan.DEFAULT, T=T)]
    runs += [record("evolving", "PSO", fitness=0.5), record("evolving", "CMA-ES", T=T)]
    runs += [record("evaluations", "PSO", T=T), record("evaluations", "PSO", index=1, T=T)]
    runs += [record("traditional", "FGR", T=None, E_R=None)]
    found = scenes.methods(runs, pair)
    assert list(found) == ["PSO", "CMA-ES", "FGR", plan.OURS]
    assert found["PSO"]["section"] == "evaluations" and found["PSO"]["index"] == 0
    cloud = np.random.default_rng(0).normal(size=(300, 3))
    case = SimpleNamespace(source=cloud, target=cloud, scale=3.0)
    case.motion = SimpleNamespace(T_true=np.eye(4))
    path = scenes._picture(case, found, tmp_path / "bunny.png")
    assert path.read_bytes().startswith(b"\x89PNG")


def test_what_the_larger_budget_gives_has_its_table_and_its_sentence():
    runs = some_runs() + [record("evaluations", "PSO", pair, 0) for pair in ("a", "b")]
    made = {table.name: table for table in tables.made(runs)}
    assert [cells[0].ours for _, cells in made["success_by_pair_evaluations"].rows] == [100.0] * 2
    assert [cells[0].ours for _, cells in made["success_by_pair"].rows] == [0.0] * 6
    said = "PSO succeeds in 0.0 % with EMTR-SSC's queries, and in 100.0 % with its evaluations"
    assert any(said in line for line in differences.text(runs, []))
    assert not any("The budget decides" in line for line in differences.text(some_runs(), []))


def test_errors_against_the_traditional_methods_are_of_the_same_motions():
    runs = [record("library", plan.OURS, index=i, E_R=1.0 + i) for i in range(3)]
    runs += [record("traditional", "FGR", index=0, E_R=2.0)]
    rows = tables.traditional(runs).rows
    assert rows[0][1][-1].ours == Published(1.0) and rows[0][1][-2].ours == Published(2.0)


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


def test_a_pair_of_the_modelnet_protocol():
    from emtr_bench.protocol import apply
    from emtr_bench.reproduce import modelnet

    first, second = (modelnet.made(f"{modelnet.MADE_NAME} {i}") for i in (1, 2))
    assert len(first[0]) != len(second[0]) or not np.allclose(first[0], second[0])
    source, target, T = modelnet.pair(*first, modelnet.CLEAN, 3)
    assert source.shape == target.shape == (1024, 3) and np.linalg.norm(source, axis=1).max() <= 1
    placed = apply(T, source)
    assert np.allclose(sorted(map(tuple, placed)), sorted(map(tuple, target)))
    source, target, T = modelnet.pair(*first, modelnet.NOISY, 3)
    distances = np.linalg.norm(apply(T, source)[:, None] - target[None], axis=2).min(axis=1)
    assert 0.005 < np.median(distances) < 0.1 and distances.max() < 0.3
    assert np.abs(T[:3, 3]).max() <= 0.5


def test_shapes_of_modelnet_are_the_unseen_ones_of_forty(tmp_path):
    from emtr_bench.reproduce import modelnet

    for i in range(40):
        for part, count in (("train", 1), ("test", 3)):
            folder = tmp_path / f"category{i:02}" / part
            folder.mkdir(parents=True)
            for k in range(count):
                (folder / f"category{i:02}_{k:04}.off").write_text("OFF")
    found = modelnet.shapes(tmp_path, 1266)
    assert len(found) == 60 and all("/test/" in path for path in found)
    assert "category20" in found[0] and "category39" in found[-1]
    assert len(modelnet.shapes(tmp_path, 7)) == 7
    with pytest.raises(DataError, match="CATEGORY/test/SHAPE"):
        modelnet.shapes(tmp_path / "category00" / "train", 5)


@pytest.fixture(scope="module")
def relief():
    """Two clouds of one surface, and a pyemtr.Problem of them as preset paper sees them."""
    import pyemtr

    rng = np.random.default_rng(1)
    u, v = rng.uniform(-1, 1, (2, 6000))
    z = 0.3 * np.sin(3 * u + v) * np.cos(2 * v) + 0.2 * np.exp(-8 * ((u - 0.3) ** 2 + v**2))
    target = np.column_stack([u, v, z])
    source = target[u > -0.6] @ np.diag([1.0, -1.0, -1.0]) + [5, 6, 7]
    return source, target, pyemtr.Problem(source, target, preset="paper", threads=1)


def test_the_fitness_in_python_is_the_librarys(relief):
    from emtr_bench.reproduce import chamfer, precision

    source, target, problem = relief
    reading = (*precision.OPTIMA["optimum: as it is"][:2], problem.c_dense / problem.leaf_dense)
    fitness = chamfer.fitness(problem, source, target, reading)
    T = np.diag([1.0, -1.0, -1.0, 1.0])
    T[:3, 3] = -T[:3, :3] @ [5, 6, 7]
    for particle in (problem.to_particle(T), np.array([0.3, 0.2, -0.1, 0.02, 0.0, 0.05])):
        assert fitness(particle) == pytest.approx(problem.evaluate_alpha(particle), rel=1e-4)
    rows = np.array([[0.3, 0.2, -0.1, 0.02, 0.0, 0.05], problem.to_particle(T)])
    assert fitness(rows) == pytest.approx(problem.evaluate_alpha(rows), rel=1e-4)
    dense = chamfer.fitness(problem, source, target, ("centroids", "centroids", reading[2]))
    assert dense(problem.to_particle(T)) > fitness(problem.to_particle(T))


def test_farthest_points_are_far_apart():
    from emtr_bench.reproduce import chamfer

    points = np.random.default_rng(0).random((500, 3))
    chosen = chamfer.farthest(points, 20)
    distances = np.linalg.norm(chosen[:, None] - chosen[None], axis=2) + np.eye(20)
    assert len(np.unique(chosen, axis=0)) == 20 and distances.min() > 0.3


def test_methods_drive_the_librarys_tasks(relief):
    from emtr_bench.reproduce import cases
    from evolving_methods.problem import Problem

    _, _, problem = relief
    tasks = cases.tasks(problem)
    limit = cases.budget(problem, cases.EQUAL_QUERIES) // 20
    for method in METHODS[::3]:
        run = Problem([tasks[name] for name in method.tasks], limit, 4000)
        before = problem.queries
        method.load()(run, np.random.default_rng(0))
        assert problem.queries - before == run.used <= limit
    assert cases.budget(problem, cases.EQUAL_EVALUATIONS) > 1.8 * 20 * limit


def test_what_is_not_there_is_told(monkeypatch, tmp_path):
    from emtr_bench.reproduce import traditional

    monkeypatch.setenv("EMTR_BUILD_DIR", str(tmp_path))
    monkeypatch.setattr(traditional, "FOLDER", tmp_path)
    found, missing = traditional.there()
    assert found == [] and "EMTR_BUILD_BENCH" in missing[0] and "tools/bench/peers" in missing[1]


def test_a_report_of_runs(tmp_path):
    from emtr_bench.reproduce import report

    shapes = [record("modelnet", f"default, {kind}", "made shape 1", row="", tier="modelnet")
              for kind in ("clean", "noisy")]  # fmt: skip
    about = {"command": "reproduce", "motions": "2 motions each", "made": "by a test",
             "missing": ["FGR: no Open3D"], "planned": 50}  # fmt: skip
    path = report.write(tmp_path, some_runs() + shapes, [], about)
    text = path.read_text()
    assert "With as many queries EMTR-SSC is ahead of 1 of 1" in text
    assert "which was not run here (section `evaluations`)" in text
    assert "6 pairs, 2 motions each" in text and "* Not run, FGR: no Open3D" in text
    assert "| PointNetLK (cited) | - (0.847)" in text and "| emtr default, all | 0.500 |" in text
    for line in text.splitlines():
        if line.startswith("!["):
            assert (tmp_path / line.partition("](")[2].rstrip(")")).is_file()
    assert (tmp_path / "tables" / "sparse_to_dense.csv").read_text().startswith("data,E_R with,")


def test_a_log_that_is_read_is_left_as_it_is(tmp_path):
    path = tmp_path / "runs.jsonl"
    with pytest.raises(DataError, match="no such log"):
        RunLog(path, {}, read=True)
    log = RunLog(path, {})
    log.append([record("library", plan.OURS)])
    log.close()
    with path.open("a") as file:
        file.write('{"section": "lib')  # another process is writing
    before = path.read_bytes()
    log = RunLog(path, {}, read=True)
    assert len(log.records) == 1 and path.read_bytes() == before
    with pytest.raises(ValueError, match="reading only"):
        log.append([record("library", plan.FAST)])
    log.close()
