"""--align-all becomes pyemtr-align, which is found where it is installed."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import rotation

TELLS = '#!/bin/sh\nfor word in "$@"; do printf "%s\\n" "$word"; done\nexit 3\n'


def program(path: Path, text: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


def lumps(count: int, seed: int) -> np.ndarray:
    """Points on a lumpy egg."""
    rng = np.random.default_rng(seed)
    at = rng.normal(size=(count, 3))
    at /= np.linalg.norm(at, axis=1, keepdims=True)
    x, y, z = at.T
    height = 1 + 0.12 * np.sin(4 * x + 1) * np.sin(5 * y) + 0.1 * np.sin(6 * z + 2 * x)
    return at * height[:, None] * [1.0, 0.8, 0.6]


@pytest.fixture
def bare(tmp_path) -> dict[str, str]:
    """An environment in whose PATH nothing is but a shell."""
    (tmp_path / "bin").mkdir()
    return {"PATH": str(tmp_path / "bin")}


def test_the_program_in_path_gets_what_the_user_gave(run, tmp_path, bare):
    program(tmp_path / "bin" / "pyemtr-align", TELLS)
    done = run("--align-all", "my scans", "--out", "out", "--preset", "fast", "--seed", 7, "-q",
               "--html", "pages", env=bare)  # fmt: skip
    assert done.returncode == 3 and not done.stderr
    words = done.stdout.splitlines()
    assert words[-2:] == ["--", "my scans"] and words.count("--quiet") == 1
    for option, value in (("--out", "out"), ("--preset", "fast"), ("--seed", "7"),
                          ("--html", "pages")):  # fmt: skip
        assert words[words.index(option) + 1] == value
    assert len(words) == 11


def test_the_one_beside_the_command_comes_first(command, tmp_path, bare):
    here = tmp_path / "installed"
    here.mkdir()
    (here / "pcl_emtr").write_bytes(command.read_bytes())
    (here / "pcl_emtr").chmod(0o755)
    program(here / "pyemtr-align", "#!/bin/sh\necho beside\n")
    program(tmp_path / "bin" / "pyemtr-align", "#!/bin/sh\necho path\n")
    done = subprocess.run(
        [here / "pcl_emtr", "--align-all", "scans", "--out", "o"],
        env=bare, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (0, "beside\n", "")


def test_the_module_of_python_is_the_last_resort(run, tmp_path, bare):
    told = program(
        tmp_path / "bin" / "python3",
        '#!/bin/sh\n[ "$1" = -c ] && exit 0\n' + TELLS.removeprefix("#!/bin/sh\n"),
    )
    done = run("--align-all", "scans", "--out", "o", env=bare)
    assert done.stdout.splitlines() == ["-m", "pyemtr.multiway", "--out", "o", "--", "scans"]
    assert done.returncode == 3
    told.write_text("#!/bin/sh\nexit 1\n")
    assert "pip install 'pyemtr[align]'" in run("--align-all", "s", "--out", "o", env=bare).stderr


def test_it_says_what_to_install(refused, bare):
    told = refused(2, "--align-all", "scans", "--out", "out", env=bare)
    assert "pyemtr-align, which is neither beside this program nor in PATH" in told
    assert "pip install 'pyemtr[align]'" in told


def test_a_program_that_cannot_be_run_is_named(refused, tmp_path, bare):
    (tmp_path / "bin" / "pyemtr-align").write_text("no program")
    assert "cannot be run: Permission denied" in refused(
        2, "--align-all", "s", "--out", "o", env=bare
    )


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--align-all", "scans"], "--align-all: expected --out"),
        (["--align-all", "", "--out", "o"], "--align-all: expected a folder"),
        (["a.pcd", "--align-all", "scans", "--out", "o"], "source and --align-all contradict"),
        (["--align-all", "s", "--out", "o", "--report", "r.json"], "--report and --align-all"),
        (["--align-all", "s", "--out", "o", "--iterations", "5"], "--iterations and --align-all"),
        (["--align-all", "s", "--out", "o", "--batch", "p.csv"], "--batch and --align-all"),
        (["--align-all", "s", "--out", "o", "--html", "-"], "--html: expected a folder"),
    ],
)
def test_wrong_usage(refused, arguments, message):
    assert message in refused(1, *arguments)


def test_real_scans_are_aligned(run, tmp_path):
    """With the package of the Python that runs the tests."""
    pyemtr = pytest.importorskip("pyemtr", reason="pyemtr is not installed")
    for package in ("gtsam", "scipy", "plyfile"):
        pytest.importorskip(package, reason=f"{package} is not installed")
    path = tmp_path / "bin"
    place = Path(pyemtr.__file__).parent.parent
    program(
        path / "python3", f'#!/bin/sh\nPYTHONPATH="{place}" exec "{sys.executable}" "$@"\n'
    )  # a python3 that is certain to have the package
    (tmp_path / "scans").mkdir()
    body = lumps(9000, 1)
    for i, side in enumerate([(1, 0, 0), (-0.6, 0.8, 0), (0, 1, 0.3)]):
        seen = body[body @ np.array(side) > -0.25]
        moved = seen @ rotation([i, 1, 2], 1.0 + i).T
        np.savetxt(tmp_path / "scans" / f"s{i}.xyz", moved)
    variables = {**os.environ, "PATH": f"{path}:/usr/bin:/bin"}
    words = ("--align-all", "scans", "--out", "out", "--preset", "fast", "--html", "pages")
    done = run(*words, env=variables)
    assert done.returncode == 0, done.stderr
    assert "3 of 3 scans placed in 1 model" in done.stdout
    assert (tmp_path / "out" / "poses" / "s0.xyz.txt").is_file()
    assert (tmp_path / "pages" / "index.html").is_file()
    assert len(list((tmp_path / "pages" / "pairs").iterdir())) == 3
    missing = run("--align-all", "none", "--out", "other", env=variables)
    assert missing.returncode == 2 and "pyemtr-align: " in missing.stderr
