"""Outputs come whole or not at all, and standard output holds the matrix and nothing else."""

from __future__ import annotations

import json
import os
import subprocess

import numpy as np
import pytest
from conftest import ENDLESS, QUICK

GUESS = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"


def test_matrix_on_standard_output_and_in_a_file_are_the_same(run, small, tmp_path):
    printed = run(*small, *QUICK)
    filed = run(*small, *QUICK, "-o", "T.txt")
    assert filed.stdout == ""
    assert printed.stdout == (tmp_path / "T.txt").read_text()
    assert len(printed.stdout.splitlines()) == 4
    matrix = np.loadtxt(tmp_path / "T.txt")
    assert matrix.shape == (4, 4)
    assert np.allclose(matrix[:3, :3] @ matrix[:3, :3].T, np.eye(3), atol=1e-12)
    assert matrix[3].tolist() == [0, 0, 0, 1]
    assert "Saving T.txt [done" in filed.stderr


def test_matrix_has_all_digits(run, small, tmp_path):
    run(*small, *QUICK, "-o", "T.txt", "--report", "r.json")
    report = json.loads((tmp_path / "r.json").read_text())  # shortest text that reads back
    assert np.loadtxt(tmp_path / "T.txt").tolist() == report["transformation"]


def test_talk_tells_points_times_and_verdict(run, small):
    done = run(*small, *QUICK)
    for text in (
        "> Loading a.pcd [done, ",
        " ms : 240 points]",
        "> Registering [done, ",
        "source 240 finite points, 0 dropped",
        "evolution ",
        "> Verdict ",
        "> T (source into target, q = R p + t)",
    ):
        assert text in done.stderr
    assert "\033" not in done.stderr and "\r" not in done.stderr


def test_quiet_leaves_warnings_only(run, small):
    done = run(*small, *QUICK, "--quiet")
    lines = done.stderr.splitlines()
    assert lines == [line for line in lines if line.startswith("pcl_emtr: warning: ")]
    assert done.stdout == run(*small, *QUICK).stdout


@pytest.mark.parametrize("option", ["-o", "--aligned", "--report"])
@pytest.mark.parametrize(
    ("place", "pattern"),
    [
        ("nowhere/x{}", "No such file or directory"),
        ("folder{}", "is a directory"),
        ("a.pcd/x{}", "Not a directory"),
    ],
)
def test_unwritable_place(refused, small, tmp_path, option, place, pattern):
    path = place.format(".ply" if option == "--aligned" else ".txt")
    if path.startswith("folder"):
        (tmp_path / path).mkdir()
    outputs = {"-o": "T.txt", "--aligned": "m.ply", "--report": "r.json"} | {option: path}
    message = refused(2, *small, *[word for item in outputs.items() for word in item])
    assert f"'{path}': " in message and pattern in message


def test_unwritable_place_is_found_before_the_work(refused, clouds):
    """A hundred million iterations would take days."""
    refused(2, *clouds, *ENDLESS, "--population", "1000", "-o", "nowhere/T.txt")


@pytest.mark.skipif(os.geteuid() == 0, reason="root writes everywhere")
def test_write_protected(refused, small, tmp_path):
    (tmp_path / "T.txt").write_text("old")
    (tmp_path / "T.txt").chmod(0o444)
    assert "Permission denied" in refused(2, *small, "-o", "T.txt")


def test_aligned_of_unknown_extension(refused, small):
    assert "'m.tif': unknown extension '.tif', --aligned expects .pcd, .ply or .obj" in refused(
        2, *small, "--aligned", "m.tif"
    )


def test_full_disk_leaves_nothing(refused, small, tmp_path):
    """A limit on file sizes stands in for a full disk: the cloud does not fit, so nothing stays."""
    import resource
    import signal

    def limit() -> None:
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (600, 600))

    (tmp_path / "T.txt").write_text("old")
    for name in ("m.pcd", "m.ply", "m.obj"):
        message = refused_after_work(small, tmp_path, refused, name, limit)
        assert f"'{name}': cannot be written whole" in message
        assert (tmp_path / "T.txt").read_text() == "old"


def refused_after_work(small, tmp_path, refused, name, limit) -> str:
    return refused(
        2,
        *small,
        *QUICK,
        "--quiet",
        "--minimum-fitness-gap",
        "0",
        "--maximum-fitness",
        "1",
        "-o",
        "T.txt",
        "--aligned",
        name,
        preexec_fn=limit,
    )


def test_full_standard_output(run, small, tmp_path):
    with open("/dev/full", "w") as full:
        done = run(*small, *QUICK, "--aligned", "m.pcd", stdout=full)
    assert done.returncode == 2
    assert "pcl_emtr: error: standard output cannot be written" in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.pcd", "b.pcd"]


def test_closed_standard_output_is_found_before_the_work(command, small, tmp_path):
    done = subprocess.run(
        ["sh", "-c", f'"{command}" a.pcd b.pcd {" ".join(ENDLESS)} >&-'],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=30,
        check=False,
    )
    assert done.returncode == 2
    assert "standard output is closed" in done.stderr


def test_replaces_files_and_follows_links(run, small, tmp_path):
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "T.txt").write_text("old")
    (tmp_path / "real" / "T.txt").chmod(0o640)
    (tmp_path / "T.txt").symlink_to("real/T.txt")
    run(*small, *QUICK, "-o", "T.txt")
    assert (tmp_path / "T.txt").is_symlink()
    assert np.loadtxt(tmp_path / "real" / "T.txt").shape == (4, 4)
    assert (tmp_path / "real" / "T.txt").stat().st_mode & 0o777 == 0o640
    assert sorted(path.name for path in (tmp_path / "real").iterdir()) == ["T.txt"]


def test_new_files_have_usual_rights(run, small, tmp_path):
    run(*small, *QUICK, "-o", "T.txt", preexec_fn=lambda: os.umask(0o027))
    assert (tmp_path / "T.txt").stat().st_mode & 0o777 == 0o640


def test_all_outputs_and_nothing_else(run, small, tmp_path):
    run(*small, *QUICK, "-o", "T.txt", "--aligned", "m.PLY", "--report", "r.json")
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "T.txt",
        "a.pcd",
        "b.pcd",
        "m.PLY",
        "r.json",
    ]


@pytest.mark.parametrize(
    ("text", "pattern"),
    [
        ("", "4 lines of 4 numbers"),
        ("1 2 3\n", "4 lines of 4 numbers"),
        (GUESS + "0 0 0 1\n", "4 lines of 4 numbers"),
        (GUESS.replace("1", "one"), "'one' is not"),
        (GUESS.replace("1", "nan"), "'nan' is not a finite"),
        (GUESS.replace("1", "2"), "not a rigid"),
    ],
)
def test_bad_guess(refused, small, tmp_path, text, pattern):
    (tmp_path / "g.txt").write_text(text)
    message = refused(2, *small, "--guess", "g.txt")
    assert message.startswith("pcl_emtr: error: 'g.txt': ") and pattern in message


def test_missing_guess(refused, small):
    assert "'g.txt': No such file" in refused(2, *small, "--guess", "g.txt")


def test_guess_is_tried(run, clouds, tmp_path, pair):
    """With one iteration of two particles only the guess can be right."""
    np.savetxt(tmp_path / "g.txt", pair.T, header="source into target")
    few = ["--preset", "paper", "--iterations", "1", "--population", "2", "--switch-fraction", "1"]
    without = np.array(run(*clouds, *few).stdout.split(), float).reshape(4, 4)
    done = run(*clouds, *few, "--guess", "g.txt", "--report", "r.json")
    found = np.array(done.stdout.split(), float).reshape(4, 4)
    assert pair.error(without)[0] > 5
    assert pair.error(found)[0] < 1
    assert json.loads((tmp_path / "r.json").read_text())["guess"] == pair.T.tolist()
