"""The package as it is installed: version, symbols, imports."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from children import environment

import pyemtr
from pyemtr import _emtr

ROOT = Path(__file__).resolve().parents[2]


def test_all_public_names_are_there_and_documented():
    for name in pyemtr.__all__:
        thing = getattr(pyemtr, name)
        assert name == "__version__" or thing.__doc__
    for thing in (pyemtr.Cloud, pyemtr.Problem, pyemtr.Result, pyemtr.TaskAlpha, pyemtr.TaskBeta):
        for name, member in vars(thing).items():
            if not name.startswith("_") and (callable(member) or isinstance(member, property)):
                assert member.__doc__, f"{thing.__name__}.{name}"


@pytest.mark.skipif(shutil.which("nm") is None, reason="nm is not installed")
def test_the_module_shows_nothing_but_its_initializer():
    """So that it works beside Open3D, PCL and libemtr in one process, in any order."""
    out = subprocess.run(
        ["nm", "-D", "--defined-only", _emtr.__file__],
        check=True,
        text=True,
        stdout=subprocess.PIPE,
    ).stdout
    assert [line.split()[-1] for line in out.splitlines()] == ["PyInit__emtr"]


def test_import_needs_numpy_only(tmp_path):
    code = (
        "import numpy, sys; before = set(sys.modules); import pyemtr; "
        "print(*sorted({name.split('.')[0] for name in set(sys.modules) - before}))"
    )
    out = subprocess.run(
        [sys.executable, "-c", code],
        check=True,
        text=True,
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        env=environment(),
    ).stdout
    # Cython leaves modules of its run time behind.
    loaded = {name for name in out.split() if not name.startswith(("_cython", "cython_runtime"))}
    assert "pyemtr" in loaded and loaded <= {"pyemtr", "numpy"} | set(sys.stdlib_module_names)
