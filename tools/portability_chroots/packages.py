"""The Debian packages of each kind of chroot."""

from __future__ import annotations

import subprocess

# What README.md and docs/INSTALL.md name, and what the tests need beyond.
OF_EMTR = [
    *("g++", "clang", "libomp-dev", "cmake", "ninja-build", "pkg-config", "libpcl-dev"),
    *("libcli11-dev", "nlohmann-json3-dev", "libgtest-dev", "python3-numpy", "python3-scipy"),
    *("python3-pytest", "ccache", "file", "dpkg-dev"),
]
# The README's commands install all else by themselves.
OF_CLONE = ["git", "ca-certificates"]

# For another processor, what builds is of this machine's own: it need not be emulated.
NATIVE = ("cmake", "ninja-build", "ccache")
CROSS = {"arm64": "g++-aarch64-linux-gnu"}
OF_PYTHON = ("cython3", "python3-dev", "python3-setuptools")
# A Debian has these without being asked; an extracted one has only what is named.
ESSENTIAL = (
    *("base-files", "base-passwd", "bash", "coreutils", "dash", "diffutils", "findutils", "grep"),
    *("gzip", "hostname", "libc-bin", "mawk", "sed", "tar", "util-linux"),
)


def native_architecture() -> str:
    return subprocess.check_output(["dpkg", "--print-architecture"], text=True).strip()


def foreign(architecture: str) -> list[str]:
    """What a chroot of another processor has, with the cross compiler of this machine."""
    away = {"g++", "clang", "libomp-dev", "file", "dpkg-dev", *NATIVE}
    kept = [name for name in OF_EMTR if name not in away]
    here = native_architecture()
    native = [f"{name}:{here}" for name in (CROSS[architecture], *NATIVE)]
    return [*ESSENTIAL, *kept, *OF_PYTHON, *native]
