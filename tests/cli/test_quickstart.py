"""The two commands, tools/quickstart and tools/check, piece by piece: a whole run takes minutes."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
TOOLS = ROOT / "tools"
COMMANDS = ("quickstart", "check")

RECORD = """#!/bin/bash
echo "$(basename "$0") $*" >>"{log}"
"""


def bash(script: str, cwd: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    environment = os.environ | variables
    return subprocess.run(
        ["bash", "-c", "set -euo pipefail\n" + script],
        cwd=cwd,
        text=True,
        capture_output=True,
        env=environment,
        timeout=120,
        check=False,
    )


def program(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A repository of its own, with spaces in its path: the commands, and a library of one line."""
    root = tmp_path / "a check out"
    (root / "tools").mkdir(parents=True)
    for name in (*COMMANDS, "setup.sh"):
        shutil.copy(TOOLS / name, root / "tools" / name)
    for name in ("pyproject.toml", "setup.py", "CMakeLists.txt"):
        (root / name).write_text(f"# {name}\n")
    for folder in ("libemtr", "pyemtr"):
        (root / folder).mkdir()
        (root / folder / "code.cpp").write_text("int answer = 42;\n")
    return root


@pytest.fixture
def apt(tmp_path: Path) -> tuple[Path, Path]:
    """A folder with a pretended package system, which has g++ only, and its log."""
    folder, log = tmp_path / "bin", tmp_path / "apt.log"
    program(folder / "dpkg-query", "#!/bin/bash\n[[ ${!#} == g++ ]] && printf installed\n")
    for name in ("apt-get", "sudo"):
        run_it = '[[ $(basename "$0") != sudo || $1 == -v ]] || "$@"\n'
        program(folder / name, RECORD.format(log=log) + run_it)
    log.touch()
    return folder, log


def sourced(checkout: Path, script: str, **variables: str) -> subprocess.CompletedProcess[str]:
    return bash(f'source "{checkout}/tools/setup.sh"\n{script}', checkout.parent, **variables)


@pytest.mark.parametrize("command", COMMANDS)
def test_help_from_anywhere_and_through_a_symlink(
    command: str, checkout: Path, tmp_path: Path
) -> None:
    link = tmp_path / "link"
    link.symlink_to(checkout / "tools" / command)
    for path in (checkout / "tools" / command, link):
        for option in ("-h", "--help"):
            done = subprocess.run(
                [path, option], cwd="/", capture_output=True, text=True, check=False
            )
            assert done.returncode == 0, done.stderr
            assert done.stdout.startswith(f"Usage: tools/{command}")
            assert "--no-packages" in done.stdout and not done.stderr
    assert not (checkout / "build").exists()


@pytest.mark.parametrize("command", COMMANDS)
def test_an_unknown_option_is_refused_before_anything_is_done(command: str, checkout: Path) -> None:
    done = subprocess.run(
        [checkout / "tools" / command, "--quick"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert f"{command}: error: unknown option: --quick" in done.stderr
    assert not (checkout / "build").exists()


@pytest.mark.parametrize("command", COMMANDS)
def test_a_failed_build_ends_the_command(command: str, checkout: Path) -> None:
    (checkout / "CMakeLists.txt").write_text('message(FATAL_ERROR "PCL is too old")\n')
    done = subprocess.run(
        [checkout / "tools" / command, "--no-packages"],
        cwd="/",
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 1
    assert "Configuring the build" in done.stdout and "FAILED" in done.stdout
    assert str(checkout / "build" / f"{command}.log") in done.stderr
    assert "PCL is too old" in done.stderr
    assert "Building" not in done.stdout


def test_ci_runs_the_check() -> None:
    done = subprocess.run(
        ["bash", ".ci/run", "--help"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        env=os.environ | {"CI": "true"},
        check=False,
    )
    assert done.returncode == 0
    assert done.stdout.startswith("Usage: tools/check")


def test_only_missing_packages_are_installed(checkout: Path, apt: tuple[Path, Path]) -> None:
    folder, log = apt
    path = f"{folder}:{os.environ['PATH']}"
    done = sourced(checkout, "install_packages g++", PATH=path)
    assert done.returncode == 0, done.stderr
    assert "all there" in done.stdout and not log.read_text()

    done = sourced(checkout, "install_packages g++ ninja-build libpcl-dev", PATH=path)
    assert done.returncode == 0, done.stderr
    assert "Debian packages to install: ninja-build libpcl-dev\n" in done.stdout
    calls = [line for line in log.read_text().splitlines() if line.startswith("apt-get")]
    assert len(calls) == 2
    assert calls[0].endswith(" update")
    assert calls[1].endswith(" install -y --no-install-recommends ninja-build libpcl-dev")
    assert ("sudo" in log.read_text()) == (os.geteuid() != 0)


def test_another_system_is_told_what_it_needs(checkout: Path, tmp_path: Path) -> None:
    tools = tmp_path / "few"
    tools.mkdir()
    for name in ("dirname", "readlink", "basename", "bash"):
        (tools / name).symlink_to(shutil.which(name) or "")
    done = sourced(checkout, "install_packages g++ ninja-build", PATH=str(tools))
    assert done.returncode == 1
    assert "g++ ninja-build" in done.stderr and "--no-packages" in done.stderr


def test_a_failed_step_shows_its_own_words_only(checkout: Path) -> None:
    script = """
    step "First" echo "words of the first"
    step "Second" bash -c 'echo "words of the second"; exit 7'
    echo "never said"
    """
    done = sourced(checkout, script)
    assert done.returncode == 1
    assert "First ... done" in done.stdout and "Second ... FAILED" in done.stdout
    assert "words" not in done.stdout and "never" not in done.stdout
    assert "words of the second" in done.stderr and "words of the first" not in done.stderr
    assert "status 7" in done.stderr and "whole log" in done.stderr


def test_the_package_is_installed_once_for_each_state_of_its_sources(
    checkout: Path, tmp_path: Path
) -> None:
    log = tmp_path / "pip.log"
    program(checkout / "build" / "venv" / "bin" / "python", RECORD.format(log=log))

    def installs(extra: str) -> int:
        log.unlink(missing_ok=True)
        done = sourced(checkout, f"install_pyemtr {extra}")
        assert done.returncode == 0, done.stderr
        calls = [line for line in log.read_text().splitlines() if "pip install" in line]
        assert all(line.endswith(f"{checkout}[{extra}]") for line in calls)
        return len(calls)

    assert [installs("plot"), installs("plot")] == [1, 0]
    assert [installs("test"), installs("test"), installs("plot")] == [1, 0, 0]
    code = checkout / "libemtr" / "code.cpp"
    code.write_text("int answer = 43;\n")
    assert [installs("plot"), installs("plot"), installs("test")] == [1, 0, 1]
    code.write_text("int answer = 42;\n")  # back again, but this is not what is installed
    assert [installs("test"), installs("plot")] == [1, 1]


def test_a_failed_installation_is_tried_again(checkout: Path, tmp_path: Path) -> None:
    broken = '#!/bin/bash\n[[ $3 == --version ]] || { echo "no network" >&2; exit 1; }\n'
    program(checkout / "build" / "venv" / "bin" / "python", broken)
    for _ in range(2):
        done = sourced(checkout, "install_pyemtr plot")
        assert done.returncode == 1
        assert "Installing pyemtr[plot]" in done.stdout and "no network" in done.stderr


def test_a_missing_interpreter_is_named(checkout: Path) -> None:
    done = sourced(checkout, "install_pyemtr plot", PYTHON="/no/such/python")
    assert done.returncode == 1
    assert "/no/such/python" in done.stderr


@pytest.fixture(scope="module")
def sample(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("sample")
    subprocess.run(
        [sys.executable, TOOLS / "sample_pair.py", "--out", folder, "--points", "4000"],
        check=True,
        timeout=120,
    )
    return folder


def show(folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, TOOLS / "show_alignment.py", folder, "--title", "Test"],
        capture_output=True,
        text=True,
        timeout=120,
        cwd=folder,
        check=False,
    )


def test_a_right_pose_is_shown_beside_the_true_one(sample: Path) -> None:
    pytest.importorskip("matplotlib")
    true = np.loadtxt(sample / "T_true.txt")
    rotation = np.eye(4)
    angle = np.radians(0.5)
    rotation[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    np.savetxt(sample / "T.txt", true @ rotation)
    done = show(sample)
    assert done.returncode == 0, done.stderr
    assert "rotation error     0.5000 degrees" in done.stdout
    assert f"{true[0, 3]:.6f}" in done.stdout and f"{(true @ rotation)[0, 0]:.6f}" in done.stdout
    assert (sample / "alignment.png").read_bytes().startswith(b"\x89PNG")


def test_a_wrong_pose_is_an_error(sample: Path) -> None:
    pytest.importorskip("matplotlib")
    np.savetxt(sample / "T.txt", np.eye(4))
    done = show(sample)
    assert done.returncode == 1
    assert "not the true one" in done.stderr


def test_a_broken_file_is_named(sample: Path) -> None:
    pytest.importorskip("matplotlib")
    (sample / "T.txt").write_text("1 0 0\n0 1 0\n")
    done = show(sample)
    assert done.returncode == 2
    assert "T.txt" in done.stderr and "Traceback" not in done.stderr
