"""tools/wheels: what a wheel may load and bundle, its licenses, the Pythons that it serves."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from pyemtr import _emtr

TOOLS = Path(__file__).resolve().parents[2] / "tools"
sys.path.append(str(TOOLS))

from wheel_build import empty_system, interpreters, libraries, licenses, program  # noqa: E402
from wheel_build.interpreters import Interpreter  # noqa: E402
from wheel_build.run import Failure, run  # noqa: E402

needs_readelf = pytest.mark.skipif(shutil.which("readelf") is None, reason="no readelf")


def python(major: int, minor: int) -> Interpreter:
    return Interpreter(Path(f"python{major}.{minor}"), (major, minor))


def test_the_module_loads_no_more_than_it_should() -> None:
    assert libraries.unexpected(libraries.needed(Path(_emtr.__file__))) == []


@needs_readelf
def test_smoke_reads_the_module(capsys) -> None:
    program.smoke(Path(_emtr.__file__))
    assert "libc.so.6" in capsys.readouterr().out


@needs_readelf
def test_smoke_names_what_is_too_much(monkeypatch) -> None:
    monkeypatch.setattr(libraries, "BUNDLED", {"libgomp.so", "liblz4.so"})
    with pytest.raises(program.Defect, match=r"libpcl_common\.so"):
        program.smoke(Path(_emtr.__file__))


def test_names_of_libraries() -> None:
    names = ["libpcl_common-1400c3d6.so.1.13.0", "libpcl_features.so.1.13", "libc.so.6"]
    assert libraries.stem(names[0]) == "libpcl_common.so"
    assert libraries.unexpected(names) == ["libpcl_features.so.1.13"]


def test_one_wheel_serves_all_pythons_with_a_stable_abi() -> None:
    old, first, later = python(3, 10), python(3, 11), python(3, 13)
    alone, stable = interpreters.plans([old, first, later])
    assert (alone.builder, alone.users, alone.stable) == (old, (old,), False)
    assert (stable.builder, stable.users, stable.stable) == (first, (first, later), True)
    assert [plan.stable for plan in interpreters.plans([later])] == [True]


def test_interpreters_that_cannot_run_are_named(tmp_path: Path) -> None:
    with pytest.raises(Failure, match="no-such-python"):
        interpreters.found([str(tmp_path / "no-such-python")])
    found = interpreters.found([sys.executable, sys.executable])
    assert [each.version for each in found] == [sys.version_info[:2]]


def test_no_interpreters(monkeypatch, tmp_path: Path, capsys) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert program.main([]) == 2
    assert "--python" in capsys.readouterr().err


FAKE_CMAKE = """#!/bin/sh
for word; do
  case $word in
    "-U*Python3_*") echo "forgets the last Python" ;;
    -DEMTR_PYTHON_ABI=*) echo "abi [${word#*=}]" ;;
    -DEMTR_PYTHON_DIR=*) mkdir -p "${word#*=}" && : >"${word#*=}/_emtr.abi3.so" ;;
  esac
done
"""


@pytest.mark.parametrize(("option", "status", "abi"), [("cp311", 0, "3.11"), ("", 1, "")])
def test_setup_builds_for_the_abi_of_the_wheel(
    tmp_path: Path, option: str, status: int, abi: str
) -> None:
    """The fake cmake leaves a module of the stable ABI, which is right only if asked for."""
    pytest.importorskip("setuptools", minversion="77")
    cmake = tmp_path / "cmake"
    cmake.write_text(FAKE_CMAKE)
    cmake.chmod(0o755)
    settings = tmp_path / "setup.cfg"
    settings.write_text(f"[bdist_wheel]\npy_limited_api = {option}\n" if option else "")
    environment = {**os.environ, "DIST_EXTRA_CONFIG": str(settings)}
    environment["PATH"] = f"{tmp_path}:{os.environ['PATH']}"
    words = ["build_ext", "--build-temp", tmp_path / "temp", "--build-lib", tmp_path / "lib"]
    done = subprocess.run(
        [sys.executable, "setup.py", *words],
        cwd=TOOLS.parent,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, f"abi [{abi}]" in done.stdout) == (status, True), done.stderr
    assert "forgets the last Python" in done.stdout  # of a build folder that many share


@pytest.mark.skipif(shutil.which("cmake") is None, reason="cmake is not installed")
def test_a_stable_abi_without_buffers_is_refused(tmp_path: Path) -> None:
    words = ["-DEMTR_BUILD_PYTHON=ON", "-DEMTR_BUILD_TOOLS=OFF", "-DEMTR_BUILD_PCL=OFF"]
    words += ["-DEMTR_PYTHON_ABI=3.10", f"-DPython3_EXECUTABLE={sys.executable}"]
    with pytest.raises(Failure, match=r"'3\.10', expected 3\.11 or later"):
        run("cmake", "-S", TOOLS.parent, "-B", tmp_path, *words)


def wheel(folder: Path, *bundled: str) -> Path:
    path = folder / "pyemtr-1.0-cp311-abi3-any.whl"
    with zipfile.ZipFile(path, "w") as archive:
        for name in bundled:
            archive.writestr(f"pyemtr.libs/{name}", b"")
    return path


def test_a_wheel_that_bundles_too_much(tmp_path: Path) -> None:
    program.check(wheel(tmp_path, "liblz4-0f0ce522.so.1.9.4"))
    with pytest.raises(program.Defect, match="libpcl_search"):
        program.check(wheel(tmp_path, "libpcl_search-0b5d2499.so.1.13.0"))


def test_a_wheel_that_is_too_large(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(program, "LARGEST", 10)
    with pytest.raises(program.Defect, match="at most 10"):
        program.check(wheel(tmp_path))


def test_other_bits_are_a_defect() -> None:
    bits: dict[str, object] = {}
    said = {"kernel": "avx2", "bits": ["0x1p+0"]}
    program.compare(bits, "first", json.dumps(said))
    program.compare(bits, "second", json.dumps(said))
    with pytest.raises(program.Defect, match="third"):
        program.compare(bits, "third", json.dumps(said | {"bits": ["0x1.8p+0"]}))


@pytest.fixture
def information(tmp_path: Path, monkeypatch) -> Path:
    """A folder .dist-info, and documents of one package in a folder of this test."""
    for name, text in {
        "doc/libone/copyright": f"On Debian systems see {tmp_path}/common/GPL-9.\n",
        "common/GPL-9": "the license\n",
        "pyemtr-1.0.dist-info/METADATA": "Name: pyemtr\nLicense-Expression: BSD-3-Clause\n"
        "License-File: LICENSE\n\nThe readme\n",
    }.items():
        file = tmp_path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    monkeypatch.setattr(licenses, "DOCUMENTS", tmp_path / "doc")
    monkeypatch.setattr(licenses, "COMMON", tmp_path / "common")
    return tmp_path / "pyemtr-1.0.dist-info"


def test_licenses_are_written_and_named(information: Path) -> None:
    licenses.write(["libone"], information)
    assert (information / "licenses/common-licenses/GPL-9").read_text() == "the license\n"
    head, _, readme = (information / "METADATA").read_text().partition("\n\n")
    assert head.splitlines() == [
        "Name: pyemtr",
        f"License-Expression: {licenses.EXPRESSION}",
        "License-File: LICENSE",
        "License-File: libone/copyright",
        "License-File: common-licenses/GPL-9",
    ]
    assert readme == "The readme\n"


def test_a_license_that_is_missing(information: Path) -> None:
    with pytest.raises(Failure, match="libtwo"):
        licenses.write(["libtwo"], information)


@pytest.mark.skipif(shutil.which("dpkg-query") is None, reason="this is no Debian")
def test_packages_of_libraries() -> None:
    assert licenses.package_of("liblz4-0f0ce522.so.1").startswith("liblz4")
    with pytest.raises(Failure):
        licenses.package_of("libnobody-0f0ce522.so.1")


def test_a_program_that_fails_is_quoted() -> None:
    with pytest.raises(Failure, match=r"status 3\nwhat it said"):
        run(sys.executable, "-c", "import sys; print('what it said'); sys.exit(3)")


def test_an_empty_system_needs_root(monkeypatch, tmp_path: Path) -> None:
    monkeypatch.setattr("os.geteuid", lambda: 1000)
    with pytest.raises(Failure, match="root"):
        empty_system.made(tmp_path)


def test_the_script_registers_its_pair(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    picture = tmp_path / "picture.png"
    # Beside the installed package, not the sources in the working folder.
    said = json.loads(run(sys.executable, program.SCRIPT, picture, folder=tmp_path))
    assert len(said["bits"]) == 36
    assert picture.read_bytes().startswith(empty_system.PNG)
