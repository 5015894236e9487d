"""Builds by the recipes where their own tools are not: against the libraries of this machine."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

from wheel_build.run import Failure, run

from .archive import Archive

HELPERS = Path(__file__).with_name("vcpkg_stand_ins.cmake")
SAMPLE_PAIR = Path(__file__).parents[1] / "sample_pair.py"
CONSUMER = "tests/consumers/class"


def conda(archive: Archive, folder: Path) -> None:
    """Runs conda's build script as conda would, with the variables that it sets."""
    place = folder / "try" / "conda"
    source, prefix = unpacked(archive, place), place / "prefix"
    set_by_conda = {
        "PREFIX": str(prefix),
        "SRC_DIR": str(source),
        "CPU_COUNT": str(os.cpu_count() or 1),
        "CMAKE_ARGS": f"-DCMAKE_INSTALL_PREFIX={prefix} -DCMAKE_INSTALL_LIBDIR=lib",
    }
    script = folder / "conda" / "build.sh"
    run("bash", "-e", script, environment=os.environ | set_by_conda, folder=source)
    use("conda", archive, source, prefix, prefix / "bin" / "pcl_emtr")


def vcpkg(archive: Archive, folder: Path) -> None:
    """Runs vcpkg's port file with stand-ins for the functions that vcpkg defines."""
    place = folder / "try" / "vcpkg"
    source, prefix = unpacked(archive, place), place / "packages"
    port = folder / "vcpkg" / "emtr"
    run("cmake", f"-DCURRENT_PORT_DIR={port}", f"-DCURRENT_PACKAGES_DIR={prefix}",
        f"-DARCHIVE={archive.path}", f"-DSHA512={archive.digest('sha512')}",
        f"-DCURRENT_BUILDTREES_DIR={place / 'build'}", "-P", HELPERS)  # fmt: skip
    use("vcpkg", archive, source, prefix, prefix / "tools" / "emtr" / "pcl_emtr")


def unpacked(archive: Archive, folder: Path) -> Path:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    run("tar", "-xf", archive.path, "-C", folder)
    return folder / f"emtr-{archive.version}"


def use(name: str, archive: Archive, source: Path, prefix: Path, command: Path) -> None:
    """Registers by the command, and builds and runs a program that finds the library there."""
    said = run(command, "--version")
    if archive.version not in said:
        raise Failure(f"{command} --version: expected {archive.version}, got {said.strip()!r}")
    pair = prefix.parent / "pair"
    run(sys.executable, SAMPLE_PAIR, "--out", pair)
    run(command, pair / "source.pcd", pair / "target.pcd", "-o", pair / "T.txt")
    build = prefix.parent / "consumer"
    run("cmake", "-S", source / CONSUMER, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", build)
    run(build / "consumer")
    print(f"{name}: built from {archive.path.name}, {said.splitlines()[0]}; a program found it")
