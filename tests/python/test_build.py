"""Messages of setup.py when the machine lacks something."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("setuptools")
pytest.importorskip("Cython")
ROOT = Path(__file__).resolve().parents[2]


def build(tmp_path, **variables):
    environment = {**os.environ, **variables}
    done = subprocess.run(
        [
            sys.executable,
            "setup.py",
            "build_ext",
            "--build-temp",
            str(tmp_path / "temp"),
            "--build-lib",
            str(tmp_path / "lib"),
        ],
        cwd=ROOT,
        env=environment,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    assert not list(tmp_path.rglob("*.so"))
    return done


def test_without_cmake(tmp_path):
    done = build(tmp_path, PATH=str(tmp_path))
    assert done.returncode != 0
    assert "cmake" in done.stdout and "apt-get install" in done.stdout
    assert "Traceback" not in done.stdout


@pytest.mark.skipif(shutil.which("cmake") is None, reason="cmake is not installed")
def test_without_pcl(tmp_path):
    done = build(tmp_path, CMAKE_ARGS="-DCMAKE_DISABLE_FIND_PACKAGE_PCL=ON")
    assert done.returncode != 0
    assert "PCL" in done.stdout and "libpcl-dev" in done.stdout
    assert "Traceback" not in done.stdout


@pytest.mark.skipif(shutil.which("cmake") is None, reason="cmake is not installed")
def test_a_failed_configure_is_not_remembered(tmp_path):
    """What CMake found in the failed try, it would not look for again in the next."""
    done = build(tmp_path, CMAKE_ARGS="-DCMAKE_DISABLE_FIND_PACKAGE_PCL=ON")
    assert "Configuring incomplete" in done.stdout
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []
