"""What `import pyemtr` says where a library is missing that it was linked with."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from pyemtr import extension

PACKAGE = Path(__file__).resolve().parents[2] / "pyemtr"


@pytest.mark.parametrize(
    ("library", "package"),
    [
        ("libpcl_features.so.1.13", "libpcl-features1.13"),
        ("libflann_cpp.so.1.9", "libflann1.9"),
        ("libboost_filesystem.so.1.74.0", "libboost-filesystem1.74.0"),
        ("libgomp.so.1", "libgomp1"),
        ("liblz4.so.1", "liblz4-1"),
        ("libstdc++.so.6", "libstdc++6"),
    ],
)
def test_the_package_is_named(library: str, package: str) -> None:
    said = extension._explanation(f"{library}: cannot open shared object file: No such file")
    assert said is not None
    assert library in said and f"apt-get install {package}. " in said


@pytest.mark.parametrize(
    "message", ["cannot import name '_emtr'", "/x/_emtr.so: undefined symbol: emtr_version"]
)
def test_another_failure_is_left_as_it_is(message: str) -> None:
    assert extension._explanation(message) is None


@pytest.mark.skipif(shutil.which("cc") is None, reason="no compiler")
def test_import_without_a_library(tmp_path: Path) -> None:
    package = tmp_path / "pyemtr"
    package.mkdir()
    for file in PACKAGE.glob("*.py"):
        shutil.copy(file, package)
    (tmp_path / "a.c").write_text("int needed(void) { return 1; }\n")
    (tmp_path / "b.c").write_text(
        "int needed(void);\nint PyInit__emtr(void) { return needed(); }\n"
    )
    library = "libpcl_features.so.1.99"
    shared = ["cc", "-shared", "-fPIC"]
    subprocess.run(
        [*shared, f"-Wl,-soname,{library}", "a.c", "-o", library], cwd=tmp_path, check=True
    )
    subprocess.run([*shared, "b.c", library, "-o", "pyemtr/_emtr.so"], cwd=tmp_path, check=True)
    (tmp_path / library).unlink()
    done = subprocess.run(
        [sys.executable, "-c", "import pyemtr"],
        cwd=tmp_path,
        env={"PYTHONPATH": str(tmp_path), "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    last = done.stderr.splitlines()[-1]
    assert done.returncode != 0
    assert last.startswith(f"ImportError: pyemtr needs the library {library}, ")
    assert "apt-get install libpcl-features1.99" in last
