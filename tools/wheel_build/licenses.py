"""Puts the licenses of all that is in a wheel into it."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterable
from pathlib import Path

from .libraries import AUDITWHEEL_MARK
from .run import Failure, run

DOCUMENTS = Path("/usr/share/doc")
COMMON = Path("/usr/share/common-licenses")
# Headers and archives are compiled in. Boost's license asks nothing of compiled code.
COMPILED_IN = ("libpcl-dev", "libflann-dev", "libeigen3-dev")
# A wheel as a whole has emtr, PCL and FLANN; lz4; Eigen; GCC's OpenMP.
EXPRESSION = "BSD-3-Clause AND BSD-2-Clause AND MPL-2.0 AND GPL-3.0-or-later WITH GCC-exception-3.1"


def package_of(library: str) -> str:
    """Returns the Debian package that a bundled library comes from."""
    name = AUDITWHEEL_MARK.sub("", library)
    owners = run("dpkg-query", "--search", f"*/{name}").splitlines()
    if not owners:
        raise Failure(f"{name}: no Debian package has it, so that its license is not known")
    return owners[0].split(":")[0]


def text_of(package: str) -> Path:
    file = DOCUMENTS / package / "copyright"
    if not file.is_file():
        raise Failure(f"{file}: expected the license of the Debian package {package}")
    return file


def add(wheel: Path, programs: Path, out: Path) -> Path:
    """Writes the wheel with the licenses into the folder `out`; returns its path there."""
    folder = wheel.parent / "unpacked"
    shutil.rmtree(folder, ignore_errors=True)
    run(programs / "wheel", "unpack", "--dest", folder, wheel)
    (content,) = folder.iterdir()
    (information,) = content.glob("*.dist-info")
    bundled = [file.name for file in sorted(content.glob("*.libs/*.so*"))]
    write({*map(package_of, bundled), *COMPILED_IN}, information)
    out.mkdir(parents=True, exist_ok=True)
    run(programs / "wheel", "pack", "--dest-dir", out, content)
    return out / wheel.name


def write(packages: Iterable[str], information: Path) -> None:
    """Writes the licenses of the packages into a folder .dist-info and names them in METADATA."""
    names = []
    common: set[str] = set()
    for package in sorted(packages):
        text = text_of(package).read_text(encoding="utf-8")
        names.append(_write(information, f"{package}/copyright", text))
        common |= set(re.findall(rf"{COMMON}/([\w.-]*\w)", text))
    for name in sorted(common):
        text = (COMMON / name).read_text(encoding="utf-8")
        names.append(_write(information, f"common-licenses/{name}", text))
    metadata = information / "METADATA"
    head, blank, rest = metadata.read_text(encoding="utf-8").partition("\n\n")
    head, replaced = re.subn(
        r"(?m)^License-Expression: .*$", f"License-Expression: {EXPRESSION}", head
    )
    if replaced != 1:
        raise Failure(f"{metadata}: expected one License-Expression, found {replaced}")
    head += "".join(f"\nLicense-File: {name}" for name in names)
    metadata.write_text(head + blank + rest, encoding="utf-8")


def _write(information: Path, name: str, text: str) -> str:
    file = information / "licenses" / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")
    return name
