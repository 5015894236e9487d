"""results.jsonl: a record is in it whole or not at all."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from children import environment

from pyemtr.batch.record import Line
from pyemtr.batch.record_file import RecordFile


def line(index: int, status: str = "registered", text: str = "") -> str:
    return f'{{"index":{index},"status":"{status}","text":"{text}"}}\n'


def record(index: int, text: str = "") -> Line:
    return Line(index, "registered", line(index, text=text))


def test_a_torn_last_line_is_cut_off_and_the_rest_stays(tmp_path: Path) -> None:
    path = tmp_path / "results.jsonl"
    for torn in ('{"index":1,"st', "x" * 200_000):
        path.write_text(line(0) + torn)
        records = RecordFile(tmp_path)
        assert list(records.places) == [0] and path.read_text() == line(0)
        records.append([record(1), record(2)])
        assert records.read(2)["index"] == 2 and len(list(records)) == 3
        records.close()
    path.write_text("torn alone")
    records = RecordFile(tmp_path)
    assert not records.places and path.read_text() == ""
    records.close()


@pytest.mark.parametrize("content", ["no json\n", "{}\n", "[1]\n", line(0) + line(0)])
def test_what_is_no_record_is_refused_by_its_line(tmp_path: Path, content: str) -> None:
    (tmp_path / "results.jsonl").write_text(content)
    with pytest.raises(ValueError, match=r"results.jsonl: line [12]: expected the record"):
        RecordFile(tmp_path)
    assert (tmp_path / "results.jsonl").read_text() == content
    os.unlink(tmp_path / "results.jsonl")
    RecordFile(tmp_path).close()  # the refused one let go of the folder


def test_a_full_disk_leaves_no_part_of_a_record(tmp_path: Path) -> None:
    """The limit of a file's size stands for a disk that is full in the middle of a record."""
    code = f"""
import resource, signal
from pathlib import Path
from pyemtr.batch.record import Line
from pyemtr.batch.record_file import RecordFile
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
records = RecordFile(Path({str(tmp_path)!r}))
records.append([{record(0)!r}])
resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
try:
    records.append([{record(1, "x" * 200)!r}])
except OSError as error:
    print("refused:", error)
"""
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        env=environment(),
        text=True,
        stdout=subprocess.PIPE,
        check=True,
    )
    assert done.stdout.startswith("refused:")
    assert (tmp_path / "results.jsonl").read_text() == line(0)


def test_the_lock_is_that_of_the_process_and_not_of_its_children(tmp_path: Path) -> None:
    code = f"""
import os, sys, time
from pathlib import Path
from pyemtr.batch.record_file import RecordFile
records = RecordFile(Path({str(tmp_path)!r}))
child = os.fork()
if child == 0:
    os.close(1)
    time.sleep(60)
    os._exit(0)
print(child, flush=True)
time.sleep(60)
"""
    process = subprocess.Popen(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        env=environment(),
        text=True,
        stdout=subprocess.PIPE,
    )
    orphan = int(process.stdout.readline())
    try:
        with pytest.raises(BlockingIOError, match="another run"):
            RecordFile(tmp_path)
        process.kill()
        process.wait()
        os.kill(orphan, 0)  # it lives, and does not keep the folder
        RecordFile(tmp_path).close()
    finally:
        process.kill()
        process.stdout.close()
        os.kill(orphan, signal.SIGKILL)
