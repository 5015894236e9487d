"""The Debian packages of each kind of chroot."""

from __future__ import annotations

# What README.md and docs/INSTALL.md name, and what the tests need beyond.
OF_EMTR = [
    *("g++", "clang", "libomp-dev", "cmake", "ninja-build", "pkg-config", "libpcl-dev"),
    *("libcli11-dev", "nlohmann-json3-dev", "libgtest-dev", "python3-numpy", "python3-scipy"),
    *("python3-pytest", "ccache", "file", "dpkg-dev"),
]
# The README's commands install all else by themselves.
OF_CLONE = ["git", "ca-certificates"]

# For another processor there are its own packages, and over them those of this machine: the
# compiler that makes its programs, and the shell, need not be emulated.
CROSS = {"arm64": "g++-aarch64-linux-gnu"}
TO_BUILD = ("cmake", "ninja-build", "ccache")
OF_SHELL = ("bash", "coreutils", "dash", "diffutils", "findutils", "grep", "gzip", "sed", "tar")
OF_PYTHON = ("cython3", "python3-dev", "python3-setuptools")
# A Debian has these without being asked; an extracted one has only what is named.
ESSENTIAL = ("base-files", "base-passwd", "hostname", "libc-bin", "mawk", "util-linux")


def native(architecture: str) -> list[str]:
    """This machine's own packages in a chroot of another processor."""
    return [*OF_SHELL, *TO_BUILD, CROSS[architecture]]


def foreign() -> list[str]:
    """The packages of the other processor in its chroot."""
    away = {"g++", "clang", "libomp-dev", "file", "dpkg-dev", *TO_BUILD}
    return [*ESSENTIAL, *(name for name in OF_EMTR if name not in away), *OF_PYTHON]
