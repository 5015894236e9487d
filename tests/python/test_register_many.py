"""register_many() gives what register() gives, and its records can be taken up again."""

from __future__ import annotations

import csv
import json
import os
import threading
import time
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest
from many_pairs import SETTINGS, comparable, run, surface, write_clouds, write_table

import pyemtr
from pyemtr.batch import work

A, B, C = surface(1), surface(2), surface(3)


def test_each_result_is_that_of_register() -> None:
    records = run([(A, B), (B, C, "second", {"seed": 5}), {"source": A, "target": C, "seed": 6}])
    expected = [
        pyemtr.register(A, B, threads=1, **SETTINGS),
        pyemtr.register(B, C, threads=1, seed=5, **SETTINGS),
        pyemtr.register(A, C, threads=1, seed=6, **SETTINGS),
    ]
    for record, alone in zip(records, expected):
        result = record.result
        assert result is not None
        found, wanted = result.to_dict(), alone.to_dict()
        found.pop("timings"), wanted.pop("timings")
        assert found == wanted
    assert [record.name for record in records] == [None, "second", None]
    assert [record.index for record in records[1:]] == [1, 2]


@pytest.mark.parametrize("preset", ["paper", "fast"])
def test_a_result_without_refinement_comes_back(preset: str) -> None:
    settings = {"preset": preset, "iterations": 2, "population": 4, "refine": False}
    (record,) = pyemtr.register_many([(A, B)], **settings)
    alone = pyemtr.register(A, B, threads=1, **settings).to_dict()
    assert record.values["refinement"] is None
    assert {**record.result.to_dict(), "timings": 0} == {**alone, "timings": 0}


def test_a_bad_pair_is_recorded_and_the_others_go_on() -> None:
    records = run([(A, [[1, 2, 3]]), ("none.npy", B), (A, B, {"seed": -1}), (A, B)])
    assert [record.status for record in records][:3] == ["error"] * 3
    assert records.counts["error"] == 3 and records[3].result is not None
    assert records[0].error == "target: cloud: 1 finite points of 1, expected at least 10"
    assert "none.npy" in records[1].error and "seed" in records[2].error
    assert records[1].result is None and records[1].values["source"] == "none.npy"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([(A, B)],), None),
        ((5,), "pairs: expected an iterable"),
        (([A],), r"pairs\[0\]: expected \(source, target\)"),
        (([(A, B), "a b"],), r"pairs\[1\]"),
        (([(A, B, "n", 5)],), "a name and then a dict"),
        (([(A, B, 5)],), "a name and then a dict|name: expected a string"),
        (([{"source": A}],), "a dict without 'target'"),
        (([], "fast"), "executor: expected an executor"),
    ],
)
def test_wrong_arguments(arguments: tuple, message: str | None) -> None:
    if message is None:
        assert len(run(*arguments)) == 1
        return
    with pytest.raises(TypeError, match=message):
        run(*arguments)


def test_wrong_settings_of_all_pairs_are_refused_at_once(tmp_path: Path) -> None:
    with pytest.raises(TypeError, match="did you mean seeds"):
        run([(A, B)], sedes=1, out=tmp_path / "out")
    with pytest.raises(ValueError, match="iterations"):
        run([(A, B)], iterations=-1, out=tmp_path / "out")
    with pytest.raises(ValueError, match="chunksize: expected 1"):
        run([(A, B)], chunksize=0, out=tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_records_are_on_disk_and_in_the_table(tmp_path: Path) -> None:
    names = write_clouds(tmp_path, 3)
    pairs = [(tmp_path / names[0], tmp_path / names[i % 3], f"p, {i}") for i in range(4)]
    pairs.append((tmp_path / "none.npy", tmp_path / names[0], "bad"))
    records = run(pairs, out=tmp_path / "out")
    assert repr(records).endswith(f"in {tmp_path / 'out'}>")
    lines = (tmp_path / "out" / "results.jsonl").read_text().splitlines()
    assert sorted(json.loads(line)["index"] for line in lines) == list(range(5))
    with open(tmp_path / "out" / "results.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["name"] for row in rows] == ["p, 0", "p, 1", "p, 2", "p, 3", "bad"]
    pose = [float(rows[1][f"t{r}{c}"]) for r in range(4) for c in range(4)]
    assert np.array_equal(np.reshape(pose, (4, 4)), records[1].result.transformation)
    assert rows[4]["status"] == "error" and "none.npy" in rows[4]["error"] and not rows[4]["t00"]


def test_a_run_is_taken_up_where_it_ended(tmp_path: Path, monkeypatch) -> None:
    names = [str(tmp_path / name) for name in write_clouds(tmp_path, 3)]
    pairs = [(names[i % 3], names[(i + 1) % 3], {"seed": i}) for i in range(6)]
    whole = run(pairs, out=tmp_path / "whole")
    done = (tmp_path / "whole" / "results.jsonl").read_text().splitlines(keepends=True)
    (tmp_path / "out").mkdir()
    torn = "".join(done[:3]) + done[3][:100]
    (tmp_path / "out" / "results.jsonl").write_text(torn)
    seen = []
    original = work.register

    def register(*clouds, **settings):
        seen.append(settings["seed"])
        return original(*clouds, **settings)

    monkeypatch.setattr(work, "register", register)
    again = run(pairs, out=tmp_path / "out")
    kept = {json.loads(line)["index"] for line in done[:3]}
    assert sorted(seen) == sorted(set(range(6)) - kept)
    assert comparable(again) == comparable(whole)
    seen.clear()
    assert comparable(run(pairs, out=tmp_path / "out")) == comparable(whole) and not seen


def test_errors_are_tried_again_on_demand(tmp_path: Path) -> None:
    names = [str(tmp_path / name) for name in write_clouds(tmp_path, 2)]
    late = tmp_path / "late.npy"
    pairs = [(names[0], late), (names[0], names[1])]
    first = run(pairs, out=tmp_path / "out")
    assert first.counts["error"] == 1
    np.save(late, A)
    assert run(pairs, out=tmp_path / "out").counts["error"] == 1
    again = run(pairs, out=tmp_path / "out", retry_errors=True)
    assert again.counts["error"] == 0 and len(again) == 2
    assert comparable(again)[1] == comparable(first)[1]


def test_a_folder_of_another_run_is_refused(tmp_path: Path) -> None:
    names = [str(tmp_path / name) for name in write_clouds(tmp_path, 3)]
    out = tmp_path / "out"
    run([(names[0], names[1]), (names[1], names[2])], out=out)
    before = (out / "results.jsonl").read_bytes()
    for pairs, more, what in (
        ([(names[0], names[2])], {}, "the target"),
        ([(names[0], names[1])], {"seed": 3}, "the seed 0, and the pair has 3"),
        ([(names[0], names[1])], {"preset": "default"}, "the preset"),
        ([(names[0], names[1])], {}, "a record of pair 1, and there are 1 pairs"),
        ([(names[0], names[1], "name")], {}, "the name"),
    ):
        with pytest.raises(ValueError, match=what):
            run(pairs, out=out, **more)
    assert (out / "results.jsonl").read_bytes() == before
    run([(names[0], names[1]), (names[1], names[2])], out=out, threads=2)  # the same bits


def test_two_runs_do_not_share_a_folder(tmp_path: Path) -> None:
    started, go_on = threading.Event(), threading.Event()

    def pairs():
        started.set()
        assert go_on.wait(60)
        yield A, B

    first = ThreadPoolExecutor(1)
    running = first.submit(run, pairs(), out=tmp_path)
    assert started.wait(60)
    with pytest.raises(BlockingIOError, match="another run writes to this folder"):
        run([(A, B)], out=tmp_path)
    go_on.set()
    assert len(running.result()) == 1
    run([(A, B)], out=tmp_path)


def test_a_cloud_of_many_pairs_is_read_once(tmp_path: Path, monkeypatch) -> None:
    path = write_clouds(tmp_path, 1)[0]
    made = []

    class Counted(pyemtr.Cloud):
        def __init__(self, points, **more) -> None:
            made.append(points)
            time.sleep(0.01)  # so that others want it meanwhile
            super().__init__(points, **more)

    monkeypatch.setattr(work, "Cloud", Counted)
    pairs = [(tmp_path / path, A, {"seed": seed}) for seed in range(8)]
    run(pairs, workers=4)
    assert len(made) == 2
    made.clear()
    run(pairs, workers=4, memory_limit=0)  # nothing is kept, and all the same
    assert len(made) > 2


def test_user_provided_data_of_a_pair_count(tmp_path: Path) -> None:
    rows = np.column_stack([np.arange(40)] * 2)
    matched = A @ np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))[0]
    (record,) = run([(A, matched, {"correspondences": rows})])
    alone = pyemtr.register(A, matched, correspondences=rows, threads=1, **SETTINGS)
    assert record.values["counts"]["correspondences"] == alone.correspondences == 40


def test_an_interrupt_ends_the_run_and_keeps_what_is_done(tmp_path: Path) -> None:
    def pairs():
        yield from ((A, B, {"seed": seed}) for seed in range(20))
        raise KeyboardInterrupt

    before = threading.active_count()
    with pytest.raises(KeyboardInterrupt):
        run(pairs(), out=tmp_path, workers=2)
    assert threading.active_count() == before
    done = comparable(tmp_path / "results.jsonl")
    assert all(record["reason"] != "interrupted" for record in done.values())
    again = run([(A, B, {"seed": seed}) for seed in range(20)], out=tmp_path)
    assert len(again) == 20


def test_processes_give_the_same(tmp_path: Path) -> None:
    names = [str(tmp_path / name) for name in write_clouds(tmp_path, 2)]
    cloud = pyemtr.Cloud(C)
    pairs = [(names[0], names[1]), (A, cloud), (names[1], cloud, {"seed": 2}), ("no.npy", A)]
    expected = comparable(run(pairs))
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        assert comparable(run(pairs, pool, chunksize=2)) == expected
        assert comparable(run(pairs, pool, out=tmp_path / "out")) == expected
    with ThreadPoolExecutor(2) as pool:
        assert comparable(run(pairs, pool)) == expected
        with pytest.raises(ValueError, match="workers: an executor has its own"):
            run(pairs, pool, workers=2)


class Deadly:
    """Ends the process that unpacks it."""

    def __reduce__(self):
        return os._exit, (1,)


def test_a_process_that_dies_ends_the_run_and_it_can_be_taken_up(tmp_path: Path) -> None:
    names = [str(tmp_path / name) for name in write_clouds(tmp_path, 2)]
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        run(names_pairs := [(names[0], names[1])], pool, out=tmp_path / "out")
        with pytest.raises(BrokenExecutor):
            run([*names_pairs, (Deadly(), names[1])], pool, out=tmp_path / "out")
    assert list(comparable(tmp_path / "out" / "results.jsonl")) == [0]
    records = run([*names_pairs, (A, names[1])], out=tmp_path / "out")
    assert records.counts["error"] == 0 and len(records) == 2


def test_a_table_is_as_good_as_a_list(tmp_path: Path) -> None:
    names = write_clouds(tmp_path, 2)
    np.savetxt(tmp_path / "guess.txt", np.eye(4))
    path = write_table(
        tmp_path,
        [
            "c0.npy,c1.npy,one,,on,,",
            'c1.npy,c0.npy,"two, three",7,,guess.txt,0 0 1',
            f"{tmp_path / names[0]},c1.npy,,,off,,",
        ],
        "source,target,name,seed,free-space,guess,axis",
    )
    first, second = (str(tmp_path / name) for name in names)
    listed = [
        (first, second, "one", {"free_space": True}),
        (second, first, "two, three", {"seed": 7, "guess": np.eye(4), "axis": [0, 0, 1]}),
        (first, second, {"free_space": False}),
    ]
    by_table, by_list = comparable(run(path)), comparable(run(listed))
    assert by_table[0]["source"] == "c0.npy" and by_list[0]["source"] == first
    for records in (by_table, by_list):
        for record in records.values():
            del record["source"], record["target"]
    assert by_table == by_list


@pytest.mark.parametrize(
    ("header", "row", "message"),
    [
        ("source", "a", "line 1: expected a column called target"),
        ("source,target,source", "a,b,c", "line 1: two columns are called source"),
        ("source,target,sede", "a,b,1", "line 1: unknown setting 'sede'; did you mean seed"),
        ("source,target,seed", "a,b", "line 2: expected 3 cells, got 2"),
        ("source,target,seed", "a,b,-1", "line 2: seed: expected a whole number"),
        ("source,target,iterations", "a,b,1e9", "line 2: iterations: expected a whole number"),
        ("source,target,iterations", "a,b,99999999", "line 2: .*iterations"),
        ("source,target,preset", "a,b,quick", "line 2: preset: 'quick' is not one of"),
        ("source,target,guess", "a,b,none.txt", "line 2: .*none.txt"),
        ("source,target,axis", "a,b,0 1", "line 2: axis: expected 3 numbers"),
        ("source,target,refine", "a,b,yes", "line 2: refine: expected on, off, 1 or 0"),
        ("source,target", ",b", "line 2: source: expected a file"),
        ("source,target", 'a,"b', "line 2: "),
    ],
)
def test_a_wrong_table_is_refused_by_its_line(tmp_path, header, row, message) -> None:
    path = write_table(tmp_path, [row], header)
    with pytest.raises(ValueError, match=message) as refused:
        run(path, out=tmp_path / "out")
    assert str(path) in str(refused.value) and not (tmp_path / "out").exists()


def test_a_folder_of_pairs(tmp_path: Path) -> None:
    plyfile = pytest.importorskip("plyfile")
    for number, name in enumerate(("b/two", "a/one")):
        (tmp_path / name).mkdir(parents=True)
        for role in ("source", "target"):
            rows = np.array(list(map(tuple, surface(number))), dtype=[(c, "f8") for c in "xyz"])
            element = plyfile.PlyElement.describe(rows, "vertex")
            plyfile.PlyData([element]).write(str(tmp_path / name / f"{role}.ply"))
    records = run(tmp_path)
    assert [record.name for record in records] == ["a/one", "b/two"]
    assert records[0].values["target"] == "a/one/target.ply"
    (tmp_path / "c").mkdir()
    with pytest.raises(ValueError, match="no folder in it has"):
        run(tmp_path / "c")
    (record,) = run(tmp_path / "a" / "one")
    assert record.name == "one" and record.values["source"] == "source.ply"
