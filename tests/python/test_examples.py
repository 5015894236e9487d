"""The examples run as they are, and find what they say."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from children import environment

FOLDER = Path(__file__).resolve().parents[2] / "examples" / "python"
SCRIPTS = {
    "cad_to_scan": "rmse",
    "lidar_pair": "confidence",
    "localize": r"(?s)registered by last pose.*\n0 wrong poses.*last pose, CPU: median \d+ ms",
    "many_scans": "registered 6 scans",
    "object_scan": "within 1 mm",
    "own_optimizer": "TaskAlpha: .* generations",
    "room": "distance between the scanners 4.05",
}


def test_every_example_is_listed() -> None:
    modules = {"scenes"}  # what they share
    assert {path.stem for path in FOLDER.glob("*.py")} == SCRIPTS.keys() | modules
    page = (FOLDER.parents[1] / "docs" / "ENTRY_POINTS.md").read_text()
    assert set(re.findall(r"`examples/python/(\w+)\.py` \|", page)) == SCRIPTS.keys()


@pytest.mark.parametrize("name", SCRIPTS)
def test_it_registers_its_data(name: str, tmp_path: Path) -> None:
    if name == "many_scans":
        pytest.importorskip("gtsam", reason="gtsam is not installed")
    if name == "own_optimizer":
        pytest.importorskip("scipy", reason="SciPy is not installed")
    done = subprocess.run(
        [sys.executable, str(FOLDER / f"{name}.py")],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        timeout=300,
        env=environment(),
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert re.search(SCRIPTS[name], done.stdout), done.stdout
    errors = [float(number) for number in re.findall(r"rotation error ([\d.]+)", done.stdout)]
    assert errors and errors[-1] < 0.1
    assert "registered" in done.stdout and "not registered" not in done.stdout
    assert not list(tmp_path.iterdir())
