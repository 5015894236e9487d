"""Exit codes 0 and 3, the truth found, and the same bits for any number of threads."""

from __future__ import annotations

import json
import os
import pty
import signal
import subprocess
import termios
import time

import cloud_files
import numpy as np
import pytest
from conftest import ENDLESS, QUICK


def matrix(text: str) -> np.ndarray:
    return np.array(text.split(), float).reshape(4, 4)


def test_registered(run, clouds, pair):
    done = run(*clouds, "--threads", "2")
    assert done.returncode == 0, done.stderr
    assert "> Verdict registered" in done.stderr and "warning" not in done.stderr
    angle, distance = pair.error(matrix(done.stdout))
    assert angle < 5 and distance < 0.1


def test_unrelated_clouds_are_not_registered(run, tmp_path):
    rng = np.random.default_rng(0)
    cloud_files.write_pcd(tmp_path / "a.pcd", rng.normal(size=(1500, 3)))
    cloud_files.write_pcd(tmp_path / "b.pcd", rng.uniform(-1, 1, (1500, 3)) * [5, 1, 0.02])
    done = run("a.pcd", "b.pcd", "-o", "T.txt", "--aligned", "m.pcd", "--threads", "2")
    assert done.returncode == 3, done.stderr
    assert "pcl_emtr: warning: not registered: " in done.stderr
    assert "the transformation is doubtful" in done.stderr
    assert "> Verdict not registered" in done.stderr
    assert np.loadtxt(tmp_path / "T.txt").shape == (4, 4)
    assert (tmp_path / "m.pcd").is_file()


def test_a_ball_can_spin(run, tmp_path):
    """Every rotation fits, which is one answer and not many."""
    rng = np.random.default_rng(2)
    for name, offset in (("a.pcd", [0, 0, 0]), ("b.pcd", [4, 5, 6])):
        points = rng.normal(size=(3000, 3))
        points /= np.linalg.norm(points, axis=1)[:, None]
        cloud_files.write_pcd(tmp_path / name, points + offset)
    done = run("a.pcd", "b.pcd", "--threads", "2", "--report", "r.json")
    assert done.returncode == 3, done.stderr
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["reason"] == "degenerate" and report["confidence"] > 0.9
    assert f"warning: not registered: {report['reason_text']}" in done.stderr
    assert report["refinement"]["unconstrained_directions"] == 3
    assert report["symmetry"]["symmetry"] == "continuous"


def test_threads_do_not_change_a_byte(run, clouds, tmp_path):
    found = {}
    for threads in (1, 2, 4, 8):
        done = run(*clouds, "--iterations", "20", "--threads", threads, "-o", "T.txt")
        assert done.returncode in (0, 3), done.stderr
        found[threads] = (tmp_path / "T.txt").read_bytes()
    assert len(set(found.values())) == 1, found


def test_seeds_matter(run, clouds):
    """To the swarm alone; a refinement would bring it to the same place from any seed."""
    few = ["--preset", "paper", "--iterations", "5", "--threads", "1"]
    assert run(*clouds, *few).stdout == run(*clouds, *few, "--seed", "0").stdout
    assert run(*clouds, *few).stdout != run(*clouds, *few, "--seed", "1").stdout


class Running:
    """A run of days, caught in the evolution: its progress line on a terminal tells when."""

    def __init__(self, command, folder, *arguments) -> None:
        self.master, slave = pty.openpty()
        self.process = subprocess.Popen(
            [command, "a.pcd", "b.pcd", *ENDLESS, "--threads", "1", *arguments],
            cwd=folder,
            stdout=subprocess.PIPE,
            stderr=slave,
        )
        self.terminal = os.ttyname(slave)
        os.close(slave)
        self.talk = ""
        while "/1000000  best alpha" not in self.talk:
            self.talk += os.read(self.master, 65536).decode()

    def end(self) -> int:
        """Reads what is still said; the exit code."""
        while True:
            try:
                self.talk += os.read(self.master, 65536).decode()
            except OSError:  # the other end is closed
                break
        os.close(self.master)
        assert not self.process.communicate(timeout=60)[0]
        return self.process.returncode


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupt_gives_the_best_pose_so_far(command, clouds, tmp_path, number):
    running = Running(command, tmp_path, "-o", "T.txt")
    running.process.send_signal(number)
    assert running.end() == 128 + number, running.talk
    assert "warning: not registered: " in running.talk and "doubtful" in running.talk
    assert np.isfinite(np.loadtxt(tmp_path / "T.txt")).all()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["T.txt", "a.pcd", "b.pcd"]


def test_second_interrupt_ends_the_program(command, clouds, tmp_path):
    """The terminal is held up, so the program waits for it and cannot meet the first request."""
    running = Running(command, tmp_path, "-o", "T.txt")
    terminal = os.open(running.terminal, os.O_RDWR | os.O_NOCTTY)
    termios.tcflow(terminal, termios.TCOOFF)
    time.sleep(1)
    running.process.send_signal(signal.SIGINT)
    time.sleep(1)
    assert running.process.poll() is None
    running.process.send_signal(signal.SIGINT)
    running.process.wait(60)
    termios.tcflow(terminal, termios.TCOON)
    os.close(terminal)
    assert running.end() == -signal.SIGINT, running.talk
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.pcd", "b.pcd"]


def test_interrupt_before_any_pose(command, tmp_path):
    """A cloud large enough that its features take longer than the signal needs."""
    rng = np.random.default_rng(1)
    cloud_files.write_pcd(tmp_path / "a.pcd", rng.uniform(size=(200000, 3)))
    (tmp_path / "b.pcd").write_bytes((tmp_path / "a.pcd").read_bytes())
    process = subprocess.Popen(
        [
            command,
            "a.pcd",
            "b.pcd",
            "--dense-points",
            "200000",
            "--coarse-points",
            "0",
            "--threads",
            "1",
            "-o",
            "T.txt",
        ],
        cwd=tmp_path,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    for line in process.stderr:  # the second cloud is loaded, the work begins
        if "Loading b.pcd" in line:
            break
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    _, talk = process.communicate(timeout=200)
    assert process.returncode == 130, talk
    assert "before any pose was known; nothing is written" in talk
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.pcd", "b.pcd"]


def test_the_time_limit_gives_the_best_pose_so_far(run, small, tmp_path):
    long = run(
        *small,
        *ENDLESS,
        "--time-limit",
        "3",
        "-o",
        "T.txt",
        "--report",
        "r.json",
        "--threads",
        "1",
    )
    assert long.returncode == 3, long.stderr
    assert "the time limit was reached; the transformation is doubtful" in long.stderr
    assert np.isfinite(np.loadtxt(tmp_path / "T.txt")).all()
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["reason"] == "time_limit" and not report["registered"]
    assert 0 < report["counts"]["iterations"] < 1000000
    none = run(*small, "--time-limit", "1e-9", "-o", "none.txt")
    assert none.returncode == 3
    assert "the time limit was reached before any pose was known; nothing is written" in none.stderr
    assert not (tmp_path / "none.txt").exists()


def test_quiet_keeps_the_warning(run, small):
    done = run(*small, *QUICK, "--quiet", "--minimum-confidence", "1")
    assert done.returncode == 3
    assert done.stderr.startswith("pcl_emtr: warning: not registered: ")


def test_one_thread_only_for_nested_regions(run, clouds):
    environment = os.environ | {"OMP_NUM_THREADS": "4,1"}
    nested = run(*clouds, "--quiet", env=environment)
    assert nested.returncode == 0, nested.stderr
    assert nested.stdout == run(*clouds, "--quiet", "--threads", "1").stdout
