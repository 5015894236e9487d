"""Which shared libraries the extension module may need, and which it needs."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from .run import run

# Every Linux with this C library has them.
OF_THE_SYSTEM = {"libc.so", "libgcc_s.so", "libm.so", "libstdc++.so", "ld-linux-x86-64.so",
                 "ld-linux-aarch64.so"}  # fmt: skip
# They go into the wheel. All else of PCL and FLANN that is used is compiled in.
BUNDLED = {"libgomp.so", "liblz4.so", "libpcl_common.so"}

NEEDED = re.compile(r"\(NEEDED\).*\[(.+)\]")
AUDITWHEEL_MARK = re.compile(r"-[0-9a-f]{8}(?=\.so)")


def needed(module: Path) -> list[str]:
    """Returns the libraries that the file itself asks the dynamic linker for."""
    return NEEDED.findall(run("readelf", "--dynamic", "--wide", module))


def stem(library: str) -> str:
    """Returns the name without its version and without the mark that auditwheel puts into it."""
    return re.sub(r"\.so.*", ".so", AUDITWHEEL_MARK.sub("", library))


def unexpected(libraries: Iterable[str]) -> list[str]:
    return sorted(name for name in libraries if stem(name) not in OF_THE_SYSTEM | BUNDLED)
