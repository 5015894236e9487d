"""Too little memory is said in one line, with exit code 2, and no file is left half written."""

from __future__ import annotations

import resource
import subprocess

import pytest

OUTPUTS = ("T.txt", "r.json", "moved.ply")


@pytest.fixture(scope="module")
def least(command) -> int:
    """Megabytes of address space in which the command can be loaded at all."""
    low, high = 1, 4096
    while high - low > 8:
        middle = (low + high) // 2
        done = subprocess.run(
            [str(command), "--version"],
            preexec_fn=lambda most=middle: limit(most),
            capture_output=True,
            check=False,
        )
        low, high = (low, middle) if done.returncode == 0 else (middle, high)
    return high


def limit(megabytes: int) -> None:
    resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))


@pytest.mark.parametrize("preset", ["fast", "paper"])
def test_memory_that_runs_out(run, clouds, tmp_path, least, preset):
    """From what the command itself needs, in steps, until it is enough."""
    seen = set()
    for more in (0, 1, 2, 4, 8, 12, 16, 24, 32, 48, 64, 96, 128, 512):
        most = least + more
        done = run(
            *clouds, "--preset", preset, "--threads", "2", "-o", "T.txt", "--report", "r.json",
            "--aligned", "moved.ply", "-q", preexec_fn=lambda most=most: limit(most),
        )  # fmt: skip
        seen.add(done.returncode)
        if done.returncode in (0, 3):
            assert all((tmp_path / name).stat().st_size for name in OUTPUTS)
        else:
            assert done.returncode == 2, (more, done.stderr)
            lines = [line for line in done.stderr.splitlines() if not line.startswith("> Loading")]
            assert len(lines) == 1 and lines[0].startswith("pcl_emtr: error: "), done.stderr
            assert "memory" in lines[0]
            assert sorted(path.name for path in tmp_path.iterdir()) == sorted(clouds)
        for name in OUTPUTS:
            (tmp_path / name).unlink(missing_ok=True)
    assert seen in ({0, 2}, {2, 3}, {0, 2, 3})
