"""The package and a program that uses it pass mypy --strict; misuse does not."""

import os
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest
from children import environment

import pyemtr

pytest.importorskip("mypy")
HERE = Path(__file__).resolve().parent


def mypy(folder, *arguments, module="mypy"):
    # Run elsewhere, so that neither sources nor configuration of the checkout play a part.
    variables = environment()
    variables.pop("MYPYPATH", None)
    home = Path(pyemtr.__file__).parent.parent
    if home != Path(sysconfig.get_path("purelib")):  # mypy finds installed packages itself
        variables["MYPYPATH"] = str(home)
    return subprocess.run(
        [sys.executable, "-m", module, *arguments],
        env=variables,
        text=True,
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )


def strict(folder, *arguments):
    return mypy(
        folder,
        "--strict",
        "--config-file",
        os.devnull,
        "--cache-dir",
        str(folder / "cache"),
        *arguments,
    )


def test_a_typed_program_passes(tmp_path):
    done = strict(tmp_path, str(HERE / "typed_usage.py"))
    assert done.returncode == 0, done.stdout


def test_the_package_itself_passes(tmp_path):
    modules = [
        f"pyemtr.{name}"
        for name in (
            "alternative",
            "arrays",
            "cloud",
            "cloud_files",
            "columns",
            "distances",
            "inputs",
            "mesh",
            "options",
            "points",
            "problem",
            "progress",
            "views",
            "registration",
            "result",
            "result_html",
            "result_json",
            "setting_types",
            "suggestions",
            "tasks",
            "text_clouds",
            "_emtr",
        )
    ]
    done = strict(tmp_path, "-m", "pyemtr", *[part for name in modules for part in ("-m", name)])
    assert done.returncode == 0, done.stdout


MISUSE = [
    "pyemtr.register(a, a, seed='x')",
    "pyemtr.register(a, a, callback=lambda: True)",
    "pyemtr.register(a, a, population=[1])",
    "pyemtr.register(a)",
    "pyemtr.register(a, a).registred",
    "pyemtr.register(a, a).fitness.upper()",
    "pyemtr.register(a, a).alternatives[0].pose",
    "pyemtr.register(a, a).unconstrained_directions + 1",  # it may be None
    "pyemtr.Problem(a, a).source_dense.bogus",
    "pyemtr.TaskAlpha(a, a, resolution=1)",
    "pyemtr.settings()['seed'].nothing",
    "pyemtr.Cloud(a, 2)",
    "pyemtr.Cloud(a).pints",
    "pyemtr.register(a, a, rmp=0.3)",  # the paper's name
    "pyemtr.register(a, a, iterations='many')",
    "pyemtr.register(a, a, iterations=2.5)",
    "pyemtr.register(a, a, transfer='no')",
    "pyemtr.register(a, a, fallback_search=False)",
    "pyemtr.register(a, a, fallback_search='never')",
    "pyemtr.register(a, a, neighbors='tree')",
    "pyemtr.Problem(a, a, inertia_start='high')",
    "pyemtr.Problem(a, a, callback=print)",
    "pyemtr.TaskAlpha(a, a, populaton=9)",
    "pyemtr.TaskBeta(a, a, mesh_points='many')",
    "pyemtr.register(a, a).covariance[0]",  # it may be None
    "pyemtr.register(a, a).inverse().pose",
    "pyemtr.register(a, a, callback=lambda progress: progress.fractoin)",
]


def test_each_misuse_is_found(tmp_path):
    source = tmp_path / "misuse.py"
    source.write_text(
        "import numpy as np\nimport pyemtr\na = np.zeros((9, 3))\n" + "\n".join(MISUSE) + "\n",
        encoding="utf-8",
    )
    done = strict(tmp_path, str(source))
    found = {int(line.split(":")[1]) for line in done.stdout.splitlines() if ": error:" in line}
    assert found == set(range(4, 4 + len(MISUSE))), done.stdout


def test_the_stub_is_true_to_the_extension(tmp_path):
    allowed = tmp_path / "allowed"
    # What Cython adds, what only the extension itself uses, and the buffer protocol, which has
    # a name in Python from 3.12 on.
    names = [
        "__reduce_cython__",
        "__setstate_cython__",
        "__test__",
        "ARRAYS",
        "FIELD_TYPES",
        "SETTING_TYPES",
        "CloudBuffer",
        "Interrupt",
        "Watch",
        r"ArrayView\.__buffer__",
    ]
    allowed.write_text("\n".join(rf"pyemtr\._emtr\.{name}" for name in names), encoding="utf-8")
    done = mypy(
        tmp_path,
        "pyemtr._emtr",
        "--allowlist",
        str(allowed),
        "--ignore-unused-allowlist",
        module="mypy.stubtest",
    )
    assert done.returncode == 0, done.stdout
