"""The Debian packages that cpack makes of a build: what is in each, and what each depends on."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

import pytest
from installed import run

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """The packages by their names without a version."""
    build = Path(os.environ.get("EMTR_BUILD_DIR", ROOT / "build"))
    if not (build / "CPackConfig.cmake").is_file():
        pytest.skip(f"no build of shared libraries at {build} (set EMTR_BUILD_DIR)")
    for program in ("cpack", "dpkg-shlibdeps", "dpkg-deb"):
        if shutil.which(program) is None:
            pytest.skip(f"no {program}")
    folder = tmp_path_factory.mktemp("packages")
    run("cpack", "--config", build / "CPackConfig.cmake", "-B", folder, cwd=folder)
    return {re.split(r"[\d_]", path.name)[0]: path for path in folder.glob("*.deb")}


def field(package: Path, name: str) -> str:
    return run("dpkg-deb", "-f", package, name).strip()


def files(package: Path) -> list[str]:
    lines = run("dpkg-deb", "-c", package).splitlines()
    return [line.split()[5][1:] for line in lines if not line.split()[5].endswith("/")]


def test_each_file_is_in_one_package(packages) -> None:
    assert set(packages) == {"libemtr", "libemtr-dev", "pcl-emtr"}
    everything = [name for package in packages.values() for name in files(package)]
    assert len(everything) == len(set(everything))
    assert all(re.search(r"\.so\.[\d.]+$|/share/doc/", n) for n in files(packages["libemtr"]))
    assert all(re.search(r"\.(h|hpp|cmake|pc|so)$|/share/doc/", n)
               for n in files(packages["libemtr-dev"]))  # fmt: skip
    assert "/usr/bin/pcl_emtr" in files(packages["pcl-emtr"])


def test_no_installed_file_is_forgotten(packages, prefix) -> None:
    """But for the license, which each package has as its copyright."""
    packed = {Path(name).name for package in packages.values() for name in files(package)}
    installed = {path.name for path in prefix.rglob("*") if not path.is_dir()}
    assert installed - packed == {"LICENSE"}


def test_what_they_depend_on(packages) -> None:
    library = field(packages["libemtr"], "Package")
    this = f"{library} (= {field(packages['libemtr'], 'Version')})"
    assert re.fullmatch(r"libemtr\d+\.\d+", library)
    assert "libpcl-common" in field(packages["libemtr"], "Depends")
    assert field(packages["libemtr-dev"], "Depends") == this
    assert this in field(packages["pcl-emtr"], "Depends")
    assert "libpcl-io" in field(packages["pcl-emtr"], "Depends")


def test_the_license_is_in_each(packages, tmp_path) -> None:
    for package in packages.values():
        name = field(package, "Package")
        run("dpkg-deb", "-x", package, tmp_path)
        text = (tmp_path / f"usr/share/doc/{name}/copyright").read_text()
        assert (ROOT / "LICENSE").read_text() in text
        assert (tmp_path / f"usr/share/doc/{name}/changelog.gz").is_file()


def test_the_linker_is_told_of_the_libraries(packages, tmp_path) -> None:
    run("dpkg-deb", "-e", packages["libemtr"], tmp_path)
    assert (tmp_path / "triggers").read_text() == "activate-noawait ldconfig\n"
    for line in (tmp_path / "shlibs").read_text().splitlines():
        assert re.match(r"lib(pcl_)?emtr (\d+\.\d+) libemtr\2 ", line)
