"""Tests the installed package from outside: tiny programs find it by CMake and by pkg-config.

The prefix has been moved since the installation; see conftest.py.
"""

from __future__ import annotations

import gzip
import os
import platform
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from installed import run

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


@pytest.fixture(scope="module")
def libdir(prefix) -> Path:
    (config,) = prefix.rglob("emtrConfig.cmake")
    return config.parents[2]


def is_static(libdir: Path) -> bool:
    return (libdir / "libemtr.a").is_file()


def needs_class(prefix: Path) -> None:
    if not (prefix / "include/pcl/registration/emtr_ssc.h").is_file():
        pytest.skip("built without the PCL class (EMTR_BUILD_PCL=OFF)")


def pkg_config(libdir: Path, *words: str) -> list[str]:
    if shutil.which("pkg-config") is None:
        pytest.skip("no pkg-config")
    env = dict(os.environ, PKG_CONFIG_PATH=str(libdir / "pkgconfig"))
    return run("pkg-config", *words, env=env).split()


def by_cmake(project: str, prefix: Path, build: Path, *options: str) -> Path:
    header = (prefix / "include/emtr/emtr.h").read_text()
    major, minor = re.findall(r"EMTR_VERSION_(?:MAJOR|MINOR) (\d+)", header)
    wanted = (f"-DCMAKE_PREFIX_PATH={prefix}", f"-DWANTED_VERSION={major}.{minor}")
    run("cmake", "-S", HERE / project, "-B", build, *wanted, *options)
    run("cmake", "--build", build)
    return build / "consumer"


def by_pkg_config(project: str, libdir: Path, build: Path, *compiler: str) -> Path:
    package, source = ("emtr", "main.c") if project == "c" else ("pcl_emtr", "main.cpp")
    program = build / "consumer"
    static = ["--static"] if is_static(libdir) else []
    flags = pkg_config(libdir, "--cflags", "--libs", *static, package)
    include = f"-I{ROOT / 'tests/cpp/support'}"
    rpath = f"-Wl,-rpath,{libdir}"
    run(*compiler, HERE / project / source, include, "-o", program, *flags, rpath, "-lm")
    return program


def check(program: Path) -> dict[str, int]:
    """Runs a consumer and checks the pose that it prints; returns the numbers that follow it."""
    lines = run(program, env=dict(os.environ, OMP_NUM_THREADS="2")).splitlines()
    true, found = (np.array(line.split(), float).reshape(4, 4) for line in lines[:2])
    chord = np.linalg.norm(true[:3, :3] - found[:3, :3]) / (2 * np.sqrt(2))
    assert np.degrees(2 * np.arcsin(chord)) < 5
    assert np.linalg.norm(true[:3, 3] - found[:3, 3]) < 0.2  # at the origin, 2 radii away
    assert np.allclose(found[:3, :3] @ found[:3, :3].T, np.eye(3), atol=1e-12)
    words = lines[2].split() if len(lines) > 2 else []
    return dict(zip(words[::2], map(int, words[1::2])))


def test_what_shells_and_man_read_is_installed(prefix):
    if not (prefix / "bin/pcl_emtr").is_file():
        pytest.skip("built without the command (EMTR_BUILD_TOOLS=OFF)")
    share = prefix / "share"
    assert "complete " in (share / "bash-completion/completions/pcl_emtr").read_text()
    assert (share / "zsh/site-functions/_pcl_emtr").read_text().startswith("#compdef pcl_emtr")
    page = gzip.decompress((share / "man/man1/pcl_emtr.1.gz").read_bytes()).decode()
    assert ".TH PCL_EMTR 1" in page


def test_c_by_cmake(prefix, libdir, tmp_path):
    if is_static(libdir):
        pytest.skip("an archive of C++ code needs a C++ linker and PCL")
    check(by_cmake("c", prefix, tmp_path, "-DCMAKE_DISABLE_FIND_PACKAGE_PCL=ON"))


def test_c_by_pkg_config(libdir, tmp_path):
    strict = ("-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror")
    check(by_pkg_config("c", libdir, tmp_path, os.environ.get("CC", "cc"), *strict))


def test_class_by_cmake_in_cpp14(prefix, tmp_path):
    needs_class(prefix)
    found = check(by_cmake("class", prefix, tmp_path, "-DCMAKE_CXX_STANDARD=14"))
    # The library is C++17, which allocates the class in another way; newer PCL asks for it itself.
    assert found["compiled"] == (found["standard"] >= 201703)


def test_class_by_cmake_and_optimized(prefix, tmp_path):
    needs_class(prefix)
    options = ("-DCMAKE_CXX_STANDARD=17", "-DCMAKE_BUILD_TYPE=Release")
    assert check(by_cmake("class", prefix, tmp_path, *options))["compiled"] == 1


def test_class_by_pkg_config(prefix, libdir, tmp_path):
    needs_class(prefix)
    compiler = (os.environ.get("CXX", "c++"), "-std=c++17")
    assert check(by_pkg_config("class", libdir, tmp_path, *compiler))["compiled"] == 1


def test_class_without_precompiled_code(prefix, libdir, tmp_path):
    needs_class(prefix)
    compiler = (os.environ.get("CXX", "c++"), "-O1", "-DPCL_NO_PRECOMPILE")
    found = check(by_pkg_config("class", libdir, tmp_path, *compiler))
    assert found["compiled"] == 0


def test_class_under_avx2(prefix, tmp_path):
    """Eigen then aligns to 32 bytes, so the class has another layout than in the library."""
    needs_class(prefix)
    if platform.machine() not in ("x86_64", "AMD64"):
        pytest.skip(f"{platform.machine()} has no AVX2")
    program = by_cmake("class", prefix, tmp_path, "-DCMAKE_CXX_FLAGS=-O3 -mavx2")
    if not re.search(r"\bavx2\b", Path("/proc/cpuinfo").read_text()):
        pytest.skip("built, but this processor has no AVX2 to run it")
    found = check(program)
    assert (found["compiled"], found["align"]) == (0, 32)


def configure(prefix: Path, folder: Path, languages: str, *lines: str, options: tuple = ()):
    """Configures a project of these languages and lines; returns its status and its words."""
    text = "\n".join(
        ["cmake_minimum_required(VERSION 3.18)", f"project(x LANGUAGES {languages})", *lines, ""]
    )
    (folder / "CMakeLists.txt").write_text(text)
    done = subprocess.run(
        ["cmake", "-S", folder, "-B", folder / "b", f"-DCMAKE_PREFIX_PATH={prefix}", *options],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    return done.returncode, done.stdout


TELL = (
    "foreach(part emtr pcl)",
    "if(TARGET emtr::${part})",
    "message(STATUS there=${part})",
    "endif()",
    "endforeach()",
    "message(STATUS found=${emtr_c_FOUND},${emtr_pcl_FOUND})",
)
NO_PCL = ("-DCMAKE_DISABLE_FIND_PACKAGE_PCL=ON",)


def test_without_components_all_that_is_there_is_defined(prefix, tmp_path):
    needs_class(prefix)
    status, said = configure(prefix, tmp_path, "C CXX", "find_package(emtr CONFIG REQUIRED)", *TELL)
    assert status == 0, said
    assert "there=emtr" in said and "there=pcl" in said and "found=TRUE,TRUE" in said


def test_without_components_and_without_pcl_the_c_library_is_defined(prefix, libdir, tmp_path):
    needs_class(prefix)
    if is_static(libdir):
        pytest.skip("an archive needs PCL")
    lines = ("find_package(emtr CONFIG REQUIRED)", *TELL)
    status, said = configure(prefix, tmp_path, "C CXX", *lines, options=NO_PCL)
    assert status == 0, said
    assert "there=emtr" in said and "there=pcl" not in said and "found=TRUE,FALSE" in said
    assert re.search(r"PCL 1\.\d+ was not found, so there is no emtr::pcl", said)


def test_a_component_that_is_not_there_is_refused(prefix, tmp_path):
    line = "find_package(emtr CONFIG REQUIRED COMPONENTS pcl2)"
    status, said = configure(prefix, tmp_path, "C CXX", line)
    assert status != 0
    assert "c and pcl, but none named pcl2" in " ".join(said.split())


def test_the_class_without_pcl_is_refused(prefix, tmp_path):
    needs_class(prefix)
    (tmp_path / "PCLConfig.cmake").write_text("set(PCL_FOUND FALSE)\n")
    (tmp_path / "PCLConfigVersion.cmake").write_text("set(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
    line = "find_package(emtr CONFIG REQUIRED COMPONENTS pcl)"
    status, said = configure(prefix, tmp_path, "C CXX", line, options=(f"-DPCL_DIR={tmp_path}",))
    assert status != 0
    assert 'package "PCL" is considered to be NOT FOUND' in " ".join(said.split())


def test_the_license_is_installed(prefix):
    (license_,) = prefix.glob("share/doc/*/LICENSE")
    assert license_.read_text() == (ROOT / "LICENSE").read_text()


def test_no_flag_leaks_to_consumers(prefix, libdir):
    flags = pkg_config(libdir, "--cflags", "emtr")
    assert Path(flags[0][2:]).resolve() == prefix / "include"
    assert all(flag.startswith("-I") for flag in flags)
    assert len(flags) == 1 or is_static(libdir)
    for file in (libdir / "cmake/emtr").iterdir():
        assert "INTERFACE_COMPILE_OPTIONS" not in file.read_text(), file
        assert "INTERFACE_COMPILE_DEFINITIONS" not in file.read_text(), file


def test_no_path_of_the_build_is_installed(prefix, libdir):
    first = str(prefix.parent / "first")
    for folder in (libdir / "cmake", libdir / "pkgconfig", prefix / "include"):
        for file in (path for path in folder.rglob("*") if path.is_file()):
            text = file.read_text()
            assert first not in text and str(ROOT) not in text, file


def exported(library: Path) -> list[str]:
    """Returns the functions and tables that a shared library exports, without the standard
    library's templates and the names of types, which are the same from any library."""
    lines = run("nm", "-DC", "--defined-only", library).splitlines()
    names = (re.sub(r"^\S+ \w ", "", line) for line in lines)
    harmless = r"(^|[ *&])(std::|__gnu_cxx::)|^typeinfo "
    return [name for name in names if not re.search(harmless, name.split("(")[0])]


def test_the_c_library_exports_its_own_names_only(libdir):
    if is_static(libdir):
        pytest.skip("built as an archive")
    names = exported(libdir / "libemtr.so")
    assert "emtr_register" in names
    assert [name for name in names if not name.startswith("emtr_")] == []


def test_the_class_library_exports_its_own_names_only(prefix, libdir):
    needs_class(prefix)
    if is_static(libdir):
        pytest.skip("built as an archive")
    names = exported(libdir / "libpcl_emtr.so")
    for point in ("PointXYZ", "PointXYZI", "PointXYZRGB", "PointXYZRGBA", "PointXYZRGBNormal",
                  "PointNormal", "PointXYZINormal"):  # fmt: skip
        for scalar in ("float", "double"):
            assert any(f"<pcl::{point}, pcl::{point}, {scalar}>::align(" in n for n in names)
    assert [name for name in names if "pcl::EMTRSSCRegistration<" not in name] == []
