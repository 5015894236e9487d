"""The progress line: on a terminal only, and gone at the end."""

from __future__ import annotations

import os
import pty
import subprocess


def talk_on_terminal(command, folder, *arguments) -> tuple[str, str]:
    """What standard error gets when it is a terminal, and standard output, which is a pipe."""
    master, slave = pty.openpty()
    process = subprocess.Popen(
        [command, "a.pcd", "b.pcd", "--iterations", "800", "--stall-iterations", "0", *arguments],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=slave,
        env=os.environ | {"TERM": "xterm"},
    )
    os.close(slave)
    talk = b""
    while True:
        try:
            chunk = os.read(master, 65536)
        except OSError:  # the other end is closed
            break
        if not chunk:
            break
        talk += chunk
    os.close(master)
    output = process.communicate(timeout=60)[0]
    assert process.returncode in (0, 3)
    return talk.decode(), output.decode()


def test_progress_on_a_terminal(command, clouds, tmp_path):
    talk, output = talk_on_terminal(command, tmp_path)
    shown = [part for part in talk.split("\r\033[K") if part]
    for stage in (
        "normalization",
        "downsampling",
        "features",
        "matching",
        "seeds",
        "evolution",
        "candidates",
        "refinement",
        "verdict",
    ):
        assert any(part.startswith(stage) for part in shown), stage
    assert "/800  best alpha " in talk and "best beta " in talk
    assert "\033[K" not in output and len(output.splitlines()) == 4


def test_progress_line_is_erased(command, clouds, tmp_path):
    talk, _ = talk_on_terminal(command, tmp_path)
    last = talk.rindex("verdict\r\033[K")  # nothing of it is left before the summary
    assert "Registering" in talk[last:]
    assert "\033[K" not in talk[last + len("verdict\r\033[K") :]


def test_no_progress_when_quiet(command, clouds, tmp_path):
    talk, _ = talk_on_terminal(command, tmp_path, "--quiet")
    assert "\033[K" not in talk and "evolution" not in talk


def test_no_progress_in_a_file(run, clouds):
    done = run(*clouds, "--iterations", "30")
    assert "\033" not in done.stderr and "best alpha" not in done.stderr
