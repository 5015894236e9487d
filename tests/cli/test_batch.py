"""Many pairs by the command: its records are those of pyemtr, and a killed run goes on."""

from __future__ import annotations

import csv
import json
import os
import pty
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import surface

SMALL = ["--preset", "fast", "--iterations", "2", "--population", "4"]


def write_clouds(folder: Path, count: int = 3) -> None:
    for i in range(count):
        np.save(folder / f"c{i}.npy", surface(300, i) @ np.linalg.qr(surface(3, 20 + i))[0])


def write_list(folder: Path, rows: list[str], header: str = "source,target") -> Path:
    path = folder / "pairs.csv"
    path.write_text("\n".join([header, *rows]) + "\n")
    return path


def records(folder: Path) -> dict[int, dict[str, Any]]:
    found = [json.loads(line) for line in (folder / "results.jsonl").read_text().splitlines()]
    for record in found:
        record.pop("seconds", None)
    by_index = {record["index"]: record for record in found}
    assert len(by_index) == len(found), "two records of one pair"
    return by_index


def table(folder: Path) -> list[dict[str, str]]:
    with (folder / "results.csv").open(newline="") as file:
        return list(csv.DictReader(file))


@pytest.fixture
def six(tmp_path: Path) -> Path:
    write_clouds(tmp_path)
    return write_list(
        tmp_path, [f"c{i % 3}.npy,c{(i + 1) % 3}.npy,{i}" for i in range(6)], "source,target,seed"
    )


def test_python_and_the_command_write_the_same(run, tmp_path: Path) -> None:
    pyemtr = pytest.importorskip("pyemtr")
    write_clouds(tmp_path)
    np.savetxt(tmp_path / "guess.txt", np.eye(4))
    path = write_list(
        tmp_path,
        [
            'c0.npy,c1.npy,"one, ""two""",,,,',
            "c1.npy,c2.npy,,18446744073709551615,off,guess.txt,0 0 1",
            f"{tmp_path}/c2.npy,c0.npy,x,7,,,",
            "none.npy,c0.npy,bad,,,,",
        ],
        "source,target,name,seed,free-space,guess,axis",
    )
    done = run("--batch", path, "--out", tmp_path / "a", *SMALL)
    assert done.returncode == 2 and "pair 3 (bad): " in done.stderr
    settings = {"preset": "fast", "iterations": 2, "population": 4}
    pyemtr.register_many(path, out=tmp_path / "b", **settings)
    a, b = records(tmp_path / "a"), records(tmp_path / "b")
    for found in (a, b):
        assert "none.npy" in found[3].pop("error")
    assert a == b
    assert a[0]["name"] == 'one, "two"' and a[1]["guess"] == np.eye(4).tolist()
    for row, other in zip(table(tmp_path / "a"), table(tmp_path / "b")):
        assert list(row) == list(other)
        for name in set(row) - {"seconds", "error"}:
            assert row[name] == other[name] or float(row[name]) == float(other[name])
    # Each goes on with the other's folder.
    assert run("--batch", path, "--out", tmp_path / "b", *SMALL).returncode == 2
    assert len(pyemtr.register_many(path, out=tmp_path / "a", **settings)) == 4
    assert records(tmp_path / "a")[0] == records(tmp_path / "b")[0]


def test_a_record_is_what_one_pair_reports(run, tmp_path: Path, six: Path) -> None:
    run("--batch", six, "--out", "out", *SMALL)
    run("c0.npy", "c1.npy", "-o", "T.txt", "--report", "r.json", "--threads", "1", *SMALL)
    alone = json.loads((tmp_path / "r.json").read_text())
    record = records(tmp_path / "out")[0]
    shared = set(alone) & set(record)
    assert {"transformation", "quality", "settings", "counts", "reason"} <= shared
    for name in ("read_source", "read_target"):
        del alone["counts"][name]
    assert {name: alone[name] for name in shared} == {name: record[name] for name in shared}
    row = table(tmp_path / "out")[0]
    pose = [float(row[f"t{i}{j}"]) for i in range(4) for j in range(4)]
    assert pose == np.ravel(alone["transformation"]).tolist()


def test_a_torn_line_is_cut_off_and_only_what_is_missing_is_done(run, tmp_path, six) -> None:
    run("--batch", six, "--out", "whole", *SMALL)
    lines = (tmp_path / "whole" / "results.jsonl").read_text().splitlines(keepends=True)
    (tmp_path / "out").mkdir()
    file = tmp_path / "out" / "results.jsonl"
    file.write_text("".join(lines[:2]) + lines[2][:500])
    run("--batch", six, "--out", "out", *SMALL)
    assert file.read_text().splitlines(keepends=True)[:2] == lines[:2]
    assert records(tmp_path / "out") == records(tmp_path / "whole")
    before = file.read_bytes()
    assert run("--batch", six, "--out", "out", *SMALL).returncode in (0, 3)
    assert file.read_bytes() == before


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM])
def test_a_run_that_is_stopped_goes_on(run, command, tmp_path: Path, number: int) -> None:
    write_clouds(tmp_path)
    rows = [f"c{i % 3}.npy,c{(i + 1) % 3}.npy,{i}" for i in range(40)]
    path = write_list(tmp_path, rows, "source,target,seed")
    process = subprocess.Popen(
        [str(command), "--batch", str(path), "--out", str(tmp_path / "out"), *SMALL],
        stderr=subprocess.PIPE,
        text=True,
    )
    file = tmp_path / "out" / "results.jsonl"
    while not file.is_file() or file.read_bytes().count(b"\n") < 3:
        time.sleep(0.001)
        assert process.poll() is None
    process.send_signal(number)
    _, told = process.communicate(timeout=60)
    if number == signal.SIGTERM:
        assert process.returncode == 143 and "the same command goes on" in told
        assert not (tmp_path / "out" / "results.csv").exists()
    done = run("--batch", path, "--out", "out", *SMALL)
    assert done.returncode in (0, 3) and len(records(tmp_path / "out")) == 40
    run("--batch", path, "--out", "whole", "--workers", "1", *SMALL)
    assert records(tmp_path / "out") == records(tmp_path / "whole")


def test_errors_are_tried_again_on_demand(run, tmp_path: Path) -> None:
    write_clouds(tmp_path)
    path = write_list(tmp_path, ["c0.npy,late.npy", "c0.npy,c1.npy"])
    arguments = ["--batch", path, "--out", "out", *SMALL]
    assert run(*arguments).returncode == 2
    np.save(tmp_path / "late.npy", surface(300, 9))
    assert run(*arguments).returncode == 2
    assert run(*arguments, "--retry-errors").returncode in (0, 3)
    assert len(records(tmp_path / "out")) == 2


def test_a_folder_of_another_run_is_refused(run, refused, tmp_path: Path, six: Path) -> None:
    run("--batch", six, "--out", "out", *SMALL)
    batch = ["--batch", six, "--out", "out", *SMALL]
    assert "has the dense_points" in refused(2, *batch, "--dense-points", "500")
    assert run(*batch, "--threads", "2").returncode in (0, 3)  # the same bits
    write_list(tmp_path, ["c0.npy,c2.npy,0"], "source,target,seed")
    assert "a record of pair 5, and there are 1 pairs" in refused(2, *batch)
    (tmp_path / "out" / "results.jsonl").write_text("no record\n")
    assert "results.jsonl': line 1: expected the record" in refused(2, *batch)


def test_a_second_run_on_the_folder_is_refused(refused, tmp_path: Path, six: Path) -> None:
    """A process of its own holds the lock: such locks go when their process closes the file, as
    reading it here would."""
    (tmp_path / "out").mkdir()
    code = (
        "import fcntl, sys; file = open(sys.argv[1], 'w'); fcntl.lockf(file, fcntl.LOCK_EX);"
        " print('locked', flush=True); sys.stdin.read()"
    )
    holder = subprocess.Popen(
        [sys.executable, "-c", code, str(tmp_path / "out" / "results.lock")],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
    )
    assert holder.stdout.readline() == b"locked\n"
    told = refused(2, "--batch", six, "--out", "out", *SMALL)
    holder.communicate()
    assert "another run writes to this folder" in told


def test_a_full_disk_is_told_and_leaves_whole_records(run, command, tmp_path, six) -> None:
    limited = f"ulimit -f 16; trap '' XFSZ; exec '{command}' --batch '{six}' --out out "
    done = subprocess.run(
        ["bash", "-c", limited + " ".join(SMALL)],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
    )
    assert done.returncode == 2 and "is the disk full?" in done.stderr
    done_before = records(tmp_path / "out")
    assert 0 < len(done_before) < 6
    run("--batch", six, "--out", "out", *SMALL)
    assert len(records(tmp_path / "out")) == 6


def test_a_folder_of_pairs(run, tmp_path: Path) -> None:
    for name in ("b/two", "a/one"):
        (tmp_path / "data" / name).mkdir(parents=True)
        for role in ("source", "target"):
            rows = "\n".join(" ".join(map(str, p)) for p in surface(300, len(name + role)))
            (tmp_path / "data" / name / f"{role}.ply").write_text(
                "ply\nformat ascii 1.0\nelement vertex 300\nproperty float x\nproperty float y\n"
                f"property float z\nend_header\n{rows}\n"
            )
    run("--batch", "data", "--out", "out", *SMALL)
    found = records(tmp_path / "out")
    assert [found[i]["name"] for i in (0, 1)] == ["a/one", "b/two"]
    assert found[1]["source"] == "b/two/source.ply"
    (tmp_path / "empty").mkdir()
    assert "no folder in it has source.ply" in run("--batch", "empty", "--out", "o").stderr


@pytest.mark.parametrize(
    ("header", "row", "message"),
    [
        ("source", "a", "line 1: expected a column called target"),
        ("source,target,source", "a,b,c", "line 1: two columns are called source"),
        ("source,target,sede", "a,b,1", "line 1: 'sede' is no column and no setting; did you mean"),
        ("source,target,seed", "a,b", "line 2: expected 3 cells, got 2"),
        ("source,target,seed", "a,b,-1", "line 2: seed: '-1' is not a whole number"),
        ("source,target,iterations", "a,b,1e9", "line 2: iterations: '1e9' is not a whole"),
        ("source,target,preset", "a,b,quick", "line 2: preset: 'quick' is not one of"),
        ("source,target,guess", "a,b,none.txt", "none.txt"),
        ("source,target,axis", "a,b,0 1", "line 2: axis: expected 3 numbers"),
        ("source,target", ",b", "line 2: source: expected a file"),
        ("source,target", 'a,"b', "line 2: the quotes of a cell do not end"),
        ("source,target", '"a"x,b', "line 2: a quoted cell does not end"),
    ],
)
def test_a_wrong_list_is_refused_by_its_line(refused, tmp_path, header, row, message) -> None:
    path = write_list(tmp_path, [row], header)
    told = refused(2, "--batch", path, "--out", "out")
    assert message in told and "pairs.csv" in told and not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--batch", "pairs.csv"], "--batch: expected --out"),
        (["c0.npy", "c1.npy", "--out", "out"], "--out: expected --batch"),
        (["c0.npy", "c1.npy", "--batch", "pairs.csv", "--out", "o"], "source and --batch"),
        (["--batch", "pairs.csv", "--out", "o", "-o", "T.txt"], "--output and --batch"),
        (["--batch", "pairs.csv", "--out", "o", "--workers", "-1"], "--workers: '-1' is not"),
        ([], "source is required"),
    ],
)
def test_options_that_do_not_fit(refused, tmp_path, six, arguments, message) -> None:
    assert message in refused(1, *arguments)


def test_the_status_line_is_for_terminals(run, command, tmp_path: Path, six: Path) -> None:
    done = run("--batch", six, "--out", "piped", *SMALL)
    assert "\r" not in done.stderr and "6 of 6 pairs: " in done.stderr and not done.stdout
    assert not run("-q", "--batch", six, "--out", "quiet", *SMALL).stderr
    reader, writer = pty.openpty()
    process = subprocess.Popen(
        [str(command), "--batch", str(six), "--out", "shown", *SMALL],
        cwd=tmp_path,
        stderr=writer,
        env={**os.environ, "TERM": "xterm"},
    )
    os.close(writer)
    shown = b""
    try:
        while part := os.read(reader, 4096):
            shown += part
    except OSError:  # the end, as a terminal tells it
        pass
    os.close(reader)
    process.wait(60)
    assert b"/6 pairs, " in shown and b" pairs/s, 0:0" in shown and b" left" in shown
    assert shown.rindex(b"\r\x1b[K") < shown.rindex(b"6 of 6 pairs: ")


def test_pages_are_made_and_go_on(run, six, tmp_path, python_with_pyemtr):
    """With --html each result has a page, and those of an earlier run stay."""
    batch = ["--batch", six, "--out", "out", "--html", "html", *SMALL]
    assert run(*batch, env=python_with_pyemtr).returncode in (0, 3)
    pages = tmp_path / "html" / "pairs"
    assert len(list(pages.glob("*.html"))) == len(list(pages.glob("*.png"))) == 6
    text = (tmp_path / "html" / "index.html").read_text()
    assert text.count('"page":"pairs/00000') == 6 and "data:image/png;base64" in text
    (pages / "000003.html").unlink()
    before = {path.name: path.stat().st_mtime_ns for path in pages.glob("*.html")}
    assert run(*batch, env=python_with_pyemtr).returncode in (0, 3)
    after = {path.name: path.stat().st_mtime_ns for path in pages.glob("*.html")}
    assert len(after) == 6 and all(after[name] == time for name, time in before.items())


def test_pages_need_the_package_before_anything_is_done(refused, six, tmp_path):
    (tmp_path / "empty").mkdir()
    environment = {"PATH": str(tmp_path / "empty")}
    told = refused(2, "--batch", six, "--out", "out", "--html", "html", *SMALL, env=environment)
    assert "pip install 'pyemtr[files]'" in told and not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (["--html", "-"], "--html: expected a folder"),
        (["--html", "p", "--html-unit", "mm"], "--html-unit and --batch"),
        (["--html", "p", "--input-format", "npy"], "--input-format and --html with --batch"),
    ],
)
def test_wrong_usage_of_pages(refused, six, more, message):
    assert message in refused(1, "--batch", six, "--out", "out", *more)
