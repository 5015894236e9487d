"""Pages of many pairs: whole or absent, of the records that are there, and an index of all."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import formats
import numpy as np
import pytest
from children import environment
from many_pairs import SETTINGS, run, surface, write_clouds, write_table

import pyemtr
from pyemtr.batch import pages, work


def entries(folder: Path) -> list[dict[str, Any]]:
    text = (folder / "index.html").read_text()
    (payload,) = re.findall(r'id="payload">(.*?)</script>', text, re.DOTALL)
    return json.loads(payload)["entries"]


def payload_of(page: Path) -> dict[str, Any]:
    (payload,) = re.findall(r'id="payload">(.*?)</script>', page.read_text(), re.DOTALL)
    return json.loads(payload)


def made(folder: Path) -> dict[str, int]:
    """The files of a folder of pages, and when each was written."""
    return {path.name: path.stat().st_mtime_ns for path in (folder / "pairs").iterdir()}


@pytest.fixture
def pairs(tmp_path) -> list[Any]:
    names = [tmp_path / name for name in write_clouds(tmp_path, 3)]
    return [(names[0], names[1], "a <b>"), (names[1], names[2]), (names[0], tmp_path / "none.npy")]


def test_each_result_has_a_page_and_the_index_has_all_pairs(pairs, tmp_path) -> None:
    records = run(pairs, out=tmp_path / "out", html=tmp_path / "html")
    assert sorted(made(tmp_path / "html")) == [
        "000000.html", "000000.png", "000001.html", "000001.png",
    ]  # fmt: skip
    rows = entries(tmp_path / "html")
    assert [row["name"] for row in rows] == ["a <b>", "c1.npy → c2.npy", "c0.npy → none.npy"]
    assert [row["page"] for row in rows] == ["pairs/000000.html", "pairs/000001.html", None]
    assert rows[2]["reason"] == "error" and "none.npy" in rows[2]["reason_text"]
    assert rows[0]["thumbnail"].startswith("data:image/png;base64,") and not rows[2]["thumbnail"]
    for row, record in zip(rows[:2], records):
        payload = payload_of(tmp_path / "html" / row["page"])
        assert payload["report"]["confidence"] == row["confidence"] == record.result.confidence
        assert payload["report"]["transformation"] == record.values["transformation"]
        assert payload["report"]["history"]["alpha"]
    assert payload_of(tmp_path / "html" / rows[1]["page"])["report"]["files"] == {
        "source": "c1.npy", "target": "c2.npy",
    }  # fmt: skip


def test_without_html_the_records_are_the_same(pairs, tmp_path) -> None:
    plain, shown = run(pairs), run(pairs, html=tmp_path / "html")
    for one, other in zip(plain, shown):
        assert {**one.values, "seconds": 0} == {**other.values, "seconds": 0}


def test_pages_of_recorded_pairs_are_made_without_registering_again(
    pairs, tmp_path, monkeypatch
) -> None:
    direct = run(pairs, out=tmp_path / "out", html=tmp_path / "direct")

    def register(*clouds: Any, **settings: Any) -> None:
        raise AssertionError("it is recorded")

    monkeypatch.setattr(work, "register", register)
    again = run(pairs, out=tmp_path / "out", html=tmp_path / "later")
    assert [one.values for one in again] == [one.values for one in direct]
    for name in made(tmp_path / "direct"):
        first, second = (tmp_path / kind / "pairs" / name for kind in ("direct", "later"))
        assert first.read_bytes() == second.read_bytes()
    assert (tmp_path / "direct" / "index.html").read_bytes() == (
        tmp_path / "later" / "index.html"
    ).read_bytes()


def test_only_what_is_missing_is_made(pairs, tmp_path) -> None:
    run(pairs, out=tmp_path / "out", html=tmp_path / "html")
    before = made(tmp_path / "html")
    (tmp_path / "html" / "pairs" / "000001.html").unlink()
    (tmp_path / "html" / "index.html").unlink()
    run(pairs, out=tmp_path / "out", html=tmp_path / "html")
    after = made(tmp_path / "html")
    assert after.keys() == before.keys()
    assert {name for name in after if after[name] != before[name]} == {"000001.html", "000001.png"}
    assert len(entries(tmp_path / "html")) == 3


def test_a_page_of_another_run_is_made_again(pairs, tmp_path) -> None:
    run(pairs, out=tmp_path / "out", html=tmp_path / "html")
    other = run(pairs, out=tmp_path / "other", html=tmp_path / "html", seed=5)
    payload = payload_of(tmp_path / "html" / "pairs" / "000000.html")
    assert payload["report"]["seed"] == other[0].values["seed"] == 5


def test_a_page_that_cannot_be_written_leaves_no_record(pairs, tmp_path, monkeypatch) -> None:
    original = pages.write_whole

    def write_whole(path: Path, content: bytes) -> None:
        if path.name == "000001.html":
            raise OSError(28, "No space left on device", str(path))
        original(path, content)

    monkeypatch.setattr(pages, "write_whole", write_whole)
    with pytest.raises(OSError, match="No space left"):
        run(pairs, out=tmp_path / "out", html=tmp_path / "html", workers=1)
    monkeypatch.undo()
    assert not (tmp_path / "html" / "pairs" / "000001.html").exists()
    lines = (tmp_path / "out" / "results.jsonl").read_text().splitlines()
    assert 1 not in [json.loads(line)["index"] for line in lines]
    assert len(run(pairs, out=tmp_path / "out", html=tmp_path / "html")) == 3
    assert (tmp_path / "html" / "pairs" / "000001.html").exists()


def test_clouds_in_memory_and_other_processes(tmp_path) -> None:
    clouds = [surface(1), pyemtr.Cloud(surface(2)), surface(3)]
    listed = [(clouds[0], clouds[1], "p"), (clouds[1], clouds[2], "q")]
    run(iter(listed), html=tmp_path / "threads")
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        run(listed, pool, html=tmp_path / "processes")
    for name in ("000000.png", "000001.png"):
        first, second = (tmp_path / kind / "pairs" / name for kind in ("threads", "processes"))
        assert first.read_bytes() == second.read_bytes()
    assert [row["name"] for row in entries(tmp_path / "processes")] == ["p", "q"]


def test_a_large_cloud_in_a_file_is_read_for_its_page(tmp_path) -> None:
    np.save(tmp_path / "large.npy", surface(1, 200_001))
    np.save(tmp_path / "small.npy", surface(2, 500))
    run([(tmp_path / "large.npy", tmp_path / "small.npy")], html=tmp_path / "html")
    report = payload_of(tmp_path / "html" / "pairs" / "000000.html")["report"]
    assert report["counts"]["read_source"] == 200_001
    assert (tmp_path / "html" / "pairs" / "000000.html").stat().st_size < 3e6


@pytest.mark.parametrize("ending", sorted(formats.WRITERS))
def test_a_cloud_of_any_format_has_its_page(tmp_path, ending) -> None:
    """The page shows what was registered: a mesh by the points that are spread over it."""
    path = formats.write(tmp_path / f"a{ending}", formats.relief())
    np.save(tmp_path / "b.npy", surface(2))
    (record,) = run([(path, tmp_path / "b.npy")], html=tmp_path / "html", mesh_points=700)
    assert record.error is None
    (row,) = entries(tmp_path / "html")
    payload = payload_of(tmp_path / "html" / row["page"])
    read = 700 if formats.is_mesh(path) else len(formats.relief()[0])
    assert payload["report"]["counts"]["read_source"] == read
    assert payload["report"]["files"]["source"] == f"a{ending}"
    assert payload["clouds"]["source"]["shown"] > 0.9 * read and row["thumbnail"]


def test_the_vertices_of_a_mesh_have_a_page(tmp_path) -> None:
    path = formats.write(tmp_path / "a.off", formats.relief())
    np.save(tmp_path / "b.npy", surface(2))
    pairs = [(path, tmp_path / "b.npy")]
    run(pairs, out=tmp_path / "out", html=tmp_path / "html", mesh_points=0)
    run(pairs, out=tmp_path / "out", html=tmp_path / "later", mesh_points=0)  # from the record
    for folder in ("html", "later"):
        report = payload_of(tmp_path / folder / "pairs" / "000000.html")["report"]
        assert report["counts"]["read_source"] == len(formats.relief()[0])


def test_a_format_whose_package_is_missing_is_told(tmp_path, monkeypatch) -> None:
    np.save(tmp_path / "b.npy", surface(2))
    (tmp_path / "a.e57").write_bytes(b"content")
    monkeypatch.setitem(sys.modules, "pye57", None)
    with pytest.raises(ImportError, match=r"a\.e57: E57 files need the package pye57"):
        run([(tmp_path / "a.e57", tmp_path / "b.npy")], html=tmp_path / "html")


def test_the_pages_of_an_older_run_by_the_module(tmp_path) -> None:
    write_clouds(tmp_path, 3)
    table = write_table(tmp_path, ["c0.npy,c1.npy", "c1.npy,c2.npy", "none.npy,c0.npy"])
    pyemtr.register_many(str(table), out=tmp_path / "out", **SETTINGS)
    before = (tmp_path / "out" / "results.jsonl").read_bytes()

    def call() -> subprocess.CompletedProcess[str]:
        words = ["pairs.csv", "--out", "out", "--html", "html"]
        return subprocess.run(
            [sys.executable, "-m", "pyemtr.batch", *words],
            cwd=tmp_path, capture_output=True, text=True, env=environment(), check=False,
        )  # fmt: skip

    done = call()
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert len(made(tmp_path / "html")) == 4 and len(entries(tmp_path / "html")) == 3
    assert (tmp_path / "out" / "results.jsonl").read_bytes() == before
    (tmp_path / "c1.npy").unlink()
    (tmp_path / "html" / "pairs" / "000000.html").unlink()
    done = call()
    assert done.returncode == 2 and "no page: pair 0: " in done.stderr and "c1.npy" in done.stderr
    assert [row["page"] for row in entries(tmp_path / "html")] == [None, "pairs/000001.html", None]
