"""What is no regular file is read and written as a stream, and never replaced."""

from __future__ import annotations

import gzip
import json
import os
import signal
import stat
import subprocess
import threading
import time

import cloud_files
import numpy as np
import pytest
from conftest import QUICK, surface

POINTS = surface(240, 3).astype("f4")


@pytest.fixture
def shell(command, small, tmp_path):
    """Runs a line of bash where $CLI is the command with what makes it quick."""

    def call(line: str, **options) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            ["bash", "-c", line],
            cwd=tmp_path,
            env=os.environ | {"CLI": f"{command} {' '.join(QUICK)}"},
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
            **options,
        )

    return call


@pytest.fixture
def matrix(run, small) -> str:
    return run(*small, *QUICK).stdout


def lines_of(text: str) -> str:
    assert len(text.splitlines()) == 4
    return text


@pytest.mark.parametrize("name", ["/dev/stdout", "-", "/dev/fd/1", "/proc/self/fd/1"])
def test_standard_output_is_not_cut(shell, matrix, tmp_path, name):
    done = shell(f"(echo before; $CLI a.pcd b.pcd -o {name}; echo after) > log")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "log").read_text() == "before\n" + lines_of(matrix) + "after\n"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.pcd", "b.pcd", "log"]


def test_a_link_to_standard_output(shell, matrix, tmp_path):
    (tmp_path / "out").symlink_to("/dev/stdout")
    shell("(echo before; $CLI a.pcd b.pcd -o out) > log")
    assert (tmp_path / "log").read_text() == "before\n" + matrix
    assert (tmp_path / "out").is_symlink()


@pytest.mark.parametrize("option", ["-o", "--report", "--aligned"])
def test_null_device(run, small, option):
    before = os.stat("/dev/null")
    done = run(*small, *QUICK, option, "/dev/null")
    assert done.returncode in (0, 3), done.stderr
    after = os.stat("/dev/null")
    assert stat.S_ISCHR(after.st_mode) and after.st_ino == before.st_ino


def test_named_pipes(run, small, tmp_path, matrix):
    """The reader of each gets everything, and the pipe stays a pipe."""
    names = {"-o": "T.pipe", "--report": "r.pipe", "--aligned": "m.pipe"}
    found = {}
    readers = []
    for name in names.values():
        os.mkfifo(tmp_path / name)
        readers.append(
            threading.Thread(target=lambda n=name: found.update({n: (tmp_path / n).read_bytes()}))
        )
        readers[-1].start()
    done = run(*small, *QUICK, *[word for item in names.items() for word in item])
    for reader in readers:
        reader.join(timeout=20)
    assert done.returncode in (0, 3), done.stderr
    assert found["T.pipe"].decode() == matrix
    assert json.loads(found["r.pipe"])["files"]["aligned"] == "m.pipe"
    (tmp_path / "m.pcd").write_bytes(found["m.pipe"])  # as the source, which is PCD
    assert len(cloud_files.read_pcd(tmp_path / "m.pcd")[0]) == 240
    assert all(stat.S_ISFIFO((tmp_path / name).stat().st_mode) for name in names.values())


@pytest.mark.parametrize(("name", "magic"), [("ply", "ply\n"), ("obj", "v "), (".PCD", "# .PCD")])
def test_format_of_a_stream(shell, name, magic):
    done = shell(f"$CLI a.pcd b.pcd -o T.txt --aligned - --aligned-format {name} | head -c 6")
    assert done.stdout.startswith(magic)


@pytest.mark.parametrize(
    "line",
    [
        "$CLI - b.pcd < a.pcd",
        "cat a.pcd | $CLI - b.pcd",
        "$CLI /dev/stdin b.pcd < a.pcd",
        "$CLI a.pcd - < b.pcd",
        "$CLI <(cat a.pcd) <(cat b.pcd)",
        "gzip -k a.pcd && $CLI <(zcat a.pcd.gz) b.pcd",
        "gzip -k a.pcd && $CLI - b.pcd < a.pcd.gz",
        "gzip a.pcd && $CLI a.pcd.gz b.pcd",
        "gzip a.pcd && mv a.pcd.gz A.PCD.GZ && $CLI A.PCD.GZ b.pcd",
        "(head -c 99 a.pcd | gzip; tail -c +100 a.pcd | gzip) > a.gz; $CLI - b.pcd < a.gz",
        "mkfifo a.pipe && (cat a.pcd > a.pipe & $CLI a.pipe b.pcd)",
        "mkfifo p.pcd && (cat a.pcd > p.pcd & $CLI p.pcd b.pcd)",
    ],
)
def test_clouds_from_streams(shell, matrix, line):
    done = shell(line)
    assert done.stdout == matrix, done.stderr


WRITERS = {
    "pcd": lambda path: cloud_files.write_pcd(path, POINTS, data="ascii"),
    "pcd, binary": lambda path: cloud_files.write_pcd(path, POINTS),
    "ply": lambda path: cloud_files.write_ply(path, POINTS),
    "obj": lambda path: cloud_files.write_obj(path, POINTS),
    "npy": lambda path: np.save(path.open("wb"), POINTS),
    "text": lambda path: path.write_text(cloud_files.text_rows(cloud_files.table(POINTS))),
}


@pytest.mark.parametrize("kind", WRITERS)
def test_format_is_known_by_the_beginning(shell, tmp_path, kind):
    cloud_files.write_pcd(tmp_path / "whole.pcd", POINTS)
    WRITERS[kind](tmp_path / "cloud")
    done = shell("$CLI - whole.pcd < cloud")
    assert done.stdout == shell("$CLI whole.pcd whole.pcd").stdout, done.stderr
    assert len(done.stdout.splitlines()) == 4


@pytest.mark.parametrize(
    ("line", "pattern"),
    [
        ("$CLI - - < a.pcd", "source and target both read the stream '/dev/stdin'"),
        ("$CLI - /dev/fd/0 < a.pcd", "both read the stream '/dev/fd/0'"),
        ("$CLI a.pcd b.pcd --report -", "the matrix (without --output) and --report both write"),
        ("$CLI a.pcd b.pcd -o - --aligned /dev/stdout", "--output and --aligned both write"),
        ("mkfifo p; $CLI a.pcd b.pcd -o p --report ./p", "--output and --report both write"),
        ("$CLI a.pcd b.pcd -o T --aligned-format ply", "--aligned-format: expected --aligned"),
        (
            "$CLI a.pcd b.pcd --aligned - -o T --aligned-format stl",
            "'stl' is not .pcd, .ply or .obj",
        ),
        ("$CLI a.pcd b.pcd --input-format dwg", "--input-format: 'dwg' is not .pcd"),
    ],
)
def test_streams_that_cannot_be_meant(shell, line, pattern):
    done = shell(line)
    assert done.returncode == 1 and pattern in done.stderr, done.stderr
    assert not done.stdout


@pytest.mark.parametrize(
    ("line", "pattern"),
    [
        ("$CLI /dev/null b.pcd", "'/dev/null': is empty"),
        ("$CLI - b.pcd < /dev/null", "'/dev/stdin': is empty"),
        ("ln -s /dev/zero z.pcd; $CLI z.pcd b.pcd", "'z.pcd': does not begin like a .pcd file"),
        ("$CLI /dev/zero b.pcd", "its format is not known by its beginning; name it by --input"),
        ("$CLI --input-format ply - b.pcd < a.pcd", "not begin like a .ply file, but like a .pcd"),
        ("cp a.pcd a.pcd.gz; $CLI a.pcd.gz b.pcd", "'a.pcd.gz': is not compressed by gzip"),
        ("gzip -c a.pcd | head -c 900 > a.pcd.gz; $CLI a.pcd.gz b.pcd", "'a.pcd.gz': truncated"),
        ("gzip -c a.pcd | head -c 900 | $CLI - b.pcd", "'/dev/stdin': truncated: its gzip data"),
        ("head -c 900 a.pcd | $CLI - b.pcd", "'/dev/stdin': truncated: its header declares"),
        ("gzip -k a.pcd; printf 'XXXXXXXX' | dd of=a.pcd.gz bs=1 seek=600 conv=notrunc;"
         " $CLI a.pcd.gz b.pcd", "'a.pcd.gz': damaged: its gzip data"),
        ("TMPDIR=/nowhere $CLI - b.pcd < a.pcd", "'/dev/stdin': needs a temporary file in TMPDIR"),
        ("$CLI a.pcd b.pcd -o /dev/fd/77", "'/dev/fd/77': cannot be written"),
        ("$CLI a.pcd b.pcd -o /dev/stdin < /dev/null", "'/dev/stdin': cannot be written"),
        ("$CLI a.pcd b.pcd -o T --aligned m.ply.gz", "--aligned does not compress"),
        ("$CLI a.pcd b.pcd -o T --aligned /dev/full", "'/dev/full': cannot be written: No space"),
    ],
)  # fmt: skip
def test_streams_that_fail(shell, tmp_path, line, pattern):
    done = shell(line)
    assert done.returncode == 2 and pattern in done.stderr, done.stderr
    assert not done.stdout and not (tmp_path / "T").exists()


def test_a_matrix_needs_no_temporary_file(shell, matrix):
    for name in ("", "-o -", "-o >(cat)"):
        done = shell(f"TMPDIR=/nowhere $CLI a.pcd b.pcd {name}; sleep 0.2")
        assert done.stdout == matrix, done.stderr


def test_text_files_from_streams(shell, tmp_path, matrix):
    (tmp_path / "g.txt").write_text("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n")
    done = shell("$CLI a.pcd b.pcd --guess - < g.txt")
    assert len(done.stdout.splitlines()) == 4, done.stderr


def test_a_reader_who_leaves_stops_the_output_files(shell, tmp_path):
    """The pipe has no reader any more when the cloud is written, so no file is put in place."""
    done = shell("set -o pipefail; $CLI a.pcd b.pcd -o T.txt --aligned - | true")
    assert done.returncode == 2 and "standard output cannot be written: Broken pipe" in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.pcd", "b.pcd"]


def test_ctrl_c_ends_the_wait_for_a_reader(command, small, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    process = subprocess.Popen(
        [command, *small, *QUICK, "-q", "-o", "pipe", "--report", "r.json"],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        text=True,
    )
    for _ in range(200):  # until it waits, beside its report
        time.sleep(0.1)
        if any(path.name.startswith(".r.json") for path in tmp_path.iterdir()):
            break
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    talk = process.communicate(timeout=20)[1]
    assert process.returncode == 130
    assert "stopped before 'pipe' was written" in talk
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.pcd", "b.pcd", "pipe"]


def test_bomb_fills_no_memory(run, tmp_path):
    """Zeros pack a thousand to one: they are unpacked to disk, and refused at the first one."""
    (tmp_path / "bomb.xyz.gz").write_bytes(gzip.compress(b"1 2 3\n" * 10 + bytes(1 << 26)))
    cloud_files.write_pcd(tmp_path / "b.pcd", POINTS)
    done = run("bomb.xyz.gz", "b.pcd", "-o", "T.txt")
    assert done.returncode == 2 and "'bomb.xyz.gz': line 11 has a zero byte" in done.stderr
