"""The comparison for real, as the check runs it: with the libraries that are there."""

import json
import os
import subprocess
import sys

from accuracy_fakes import REPOSITORY
from emtr_bench.peers.methods import all_methods

SCRIPT = REPOSITORY / "tools" / "bench" / "peers"


def run(*argv):
    return subprocess.run(
        [sys.executable, str(SCRIPT), *argv],
        capture_output=True,
        text=True,
        env={**os.environ, "EMTR_DATA": "/nowhere"},
        check=False,
    )


def test_every_preset_runs_and_what_is_missing_is_named(tmp_path):
    import pyemtr

    path = tmp_path / "peers.json"
    done = run("--smoke", "--json", str(path))
    assert done.returncode == 0, done.stdout + done.stderr
    value = json.loads(path.read_text())
    expected = all_methods(pyemtr.presets())
    missing = [method.name for method in expected if method.missing()]
    assert list(value["left_out"]) == missing
    for name in missing:
        assert f"left out: {name} (no " in done.stdout
    assert [r["method"] for r in value["runs"]] == [
        method.name for method in expected if method.name not in missing
    ]
    # An easy pair: success shows that nothing on the way to a worker and back is reversed.
    assert all(r["success"] for r in value["runs"] if r["method"].startswith("emtr-"))
    assert value["machine"]["pyemtr"] == pyemtr.__version__


def test_unknown_methods_and_presets_are_refused_by_name():
    done = run("--smoke", "--only", "teaser")
    assert done.returncode == 2 and "--only teaser: no such method" in done.stderr
    done = run("--smoke", "--presets", "best")
    assert done.returncode == 2 and "--presets best: no such preset" in done.stderr


def test_help_needs_no_more_than_python():
    done = subprocess.run(
        [sys.executable, "-S", "-E", str(SCRIPT), "--help"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0 and "exit code" in done.stdout
