"""Builds pyemtr's extension module with CMake, the one build of the library's sources."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


def project_version() -> str:
    """The version of emtr.h, the only place where it is written."""
    text = (ROOT / "libemtr/include/emtr/emtr.h").read_text(encoding="utf-8")
    parts = re.findall(r"^#define EMTR_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", text, re.MULTILINE)
    if len(parts) != 3:
        raise SystemExit("setup.py: emtr.h has no EMTR_VERSION_MAJOR, _MINOR and _PATCH")
    return ".".join(parts)


class CMakeBuild(build_ext):
    """build_ext by CMake; more arguments for the configure step by the variable CMAKE_ARGS.

    bdist_wheel's option py_limited_api, as cp311, makes a module of the stable ABI.
    """

    def finalize_options(self) -> None:
        tag = self.distribution.get_command_obj("bdist_wheel").py_limited_api
        self.stable_abi = f"{tag[2]}.{tag[3:]}" if tag else ""
        for ext in self.distribution.ext_modules:
            ext.py_limited_api = bool(tag)
        super().finalize_options()

    _NOT_CONFIGURED = (
        "cmake could not configure the build. It needs a C++17 compiler, "
        "ninja or make, and PCL 1.12 or later with its headers (Debian: apt-get "
        "install ninja-build g++ libpcl-dev); its own words are above"
    )

    def build_extension(self, ext: Extension) -> None:
        cmake = shutil.which("cmake")
        if cmake is None:
            raise SystemExit(
                "pyemtr: cmake (3.18 or later) is needed to build the extension "
                "and was not found. On Debian: apt-get install cmake ninja-build "
                "g++ libpcl-dev"
            )
        module = Path(self.get_ext_fullpath(ext.name)).resolve()
        build = Path(self.build_temp).resolve() / "cmake"
        configure = [
            cmake,
            "-S",
            str(ROOT),
            "-B",
            str(build),
            "-U*Python3_*",  # what an earlier build there found of another Python
            "-DCMAKE_BUILD_TYPE=Release",
            "-DEMTR_BUILD_PYTHON=ON",
            "-DEMTR_BUILD_PCL=OFF",
            "-DEMTR_BUILD_TOOLS=OFF",
            "-DEMTR_BUILD_TESTS=OFF",
            f"-DEMTR_PYTHON_DIR={module.parent}",
            f"-DEMTR_PYTHON_ABI={self.stable_abi}",
            f"-DPython3_EXECUTABLE={sys.executable}",
        ]
        if shutil.which("ninja") and "CMAKE_GENERATOR" not in os.environ:
            configure += ["-G", "Ninja"]
        configure += shlex.split(os.environ.get("CMAKE_ARGS", ""))
        try:
            self._run(configure, self._NOT_CONFIGURED)
        except SystemExit:
            shutil.rmtree(build, ignore_errors=True)  # the next try is to remember nothing of it
            raise
        jobs = str(self.parallel or os.cpu_count() or 1)
        self._run(
            [cmake, "--build", str(build), "--target", "_emtr", "--parallel", jobs],
            "the extension module could not be compiled; the compiler's words are above",
        )
        if not module.is_file():
            raise SystemExit(f"pyemtr: the build has left no {module}")

    @staticmethod
    def _run(command: list, failure: str) -> None:
        if subprocess.run(command, check=False).returncode != 0:
            raise SystemExit(f"pyemtr: {failure}")


setup(
    version=project_version(),
    ext_modules=[Extension("pyemtr._emtr", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
