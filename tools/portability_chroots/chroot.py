"""A chroot of one suite of Debian, and commands in it."""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from .arguments import REPOSITORY

# What README.md and docs/INSTALL.md name, and what the tests need beyond.
PACKAGES = [
    *("g++", "clang", "libomp-dev", "cmake", "ninja-build", "pkg-config", "libpcl-dev"),
    *("libcli11-dev", "nlohmann-json3-dev", "libgtest-dev", "python3-numpy", "python3-scipy"),
    *("python3-pytest", "ccache", "file", "dpkg-dev"),
]
# For another processor, what builds is of this machine's own: it need not be emulated.
NATIVE = ("cmake", "ninja-build", "ccache")
CROSS = {"arm64": "g++-aarch64-linux-gnu"}
EMULATED = {"arm64": "qemu-aarch64"}  # the names that binfmt_misc has for them
BINFMT = Path("/proc/sys/fs/binfmt_misc")
OF_PYTHON = ("cython3", "python3-dev", "python3-setuptools")
MARK = "made-by-tools-portability"

# Mounts are made in a namespace of their own, so nothing stays mounted whatever happens.
IN_NAMESPACE = """
mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" || exit
mkdir -p "$1/source" && mount --bind "$2" "$1/source" || exit
mount -o remount,bind,ro "$1/source" || exit
if [ -n "$3" ]; then mkdir -p "$1/ccache" && mount --bind "$3" "$1/ccache" || exit; fi
exec chroot "$1" env -i HOME=/root LC_ALL=C.UTF-8 \
  PATH=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin sh -euc "$4"
"""


class ChrootFailure(Exception):
    """A chroot that could not be made; the message says why and names the log."""


@dataclass(frozen=True)
class Chroot:
    """The root of a suite below the folder of all chroots; /source there is the checkout."""

    folder: Path
    suite: str
    architecture: str | None = None  # None for this machine's own

    @property
    def name(self) -> str:
        return f"{self.suite}-{self.architecture}" if self.architecture else self.suite

    @property
    def root(self) -> Path:
        return self.folder / self.name

    def packages(self) -> list[str]:
        if not self.architecture:
            return PACKAGES
        here = subprocess.check_output(["dpkg", "--print-architecture"], text=True).strip()
        away = {"g++", "clang", "libomp-dev", "file", "dpkg-dev", *NATIVE}
        kept = [name for name in PACKAGES if name not in away]
        native = [f"{name}:{here}" for name in (CROSS[self.architecture], *NATIVE)]
        return [*kept, *OF_PYTHON, *native]

    def make(self, mirror: str, reuse: bool) -> None:
        """Makes the chroot with its packages. Raises ChrootFailure."""
        mark = self.root / MARK
        packages = self.packages()
        if reuse and mark.is_file() and mark.read_text().split() == packages:
            return
        self._require_means()
        if self.root.exists():
            if any(self.root.iterdir()) and not (mark.is_file() or reuse):
                raise ChrootFailure(f"{self.root}: made by something else, and not removed")
            if not reuse:
                shutil.rmtree(self.root)
        self.folder.mkdir(parents=True, exist_ok=True)
        log = self.folder / f"{self.name}.log"
        with log.open("w") as out:
            if not (self.root / "etc/debian_version").is_file():
                words = [f"--arch={self.architecture}"] if self.architecture else []
                made = ["debootstrap", "--variant=minbase", *words, self.suite, str(self.root)]
                if subprocess.run([*made, mirror], stdout=out, stderr=out, check=False).returncode:
                    raise ChrootFailure(f"debootstrap {self.name} failed, see {log}")
                policy = self.root / "usr/sbin/policy-rc.d"  # no package starts a service
                policy.write_text("#!/bin/sh\nexit 101\n")
                policy.chmod(0o755)
            foreign = sorted({name.split(":")[1] for name in packages if ":" in name})
            install = (
                "export DEBIAN_FRONTEND=noninteractive\n"
                + "".join(f"dpkg --add-architecture {name}\n" for name in foreign)
                + "apt-get -o Acquire::Check-Valid-Until=no update\n"  # a mirror may lag behind
                f"apt-get install -y --no-install-recommends {' '.join(packages)}; apt-get clean"
            )
            if self.run(install, out) != 0:
                raise ChrootFailure(f"{self.name}: packages could not be installed, see {log}")
        mark.write_text("\n".join(packages))

    def run(self, script: str, out) -> int:
        """Runs a shell script in the chroot, its words into an open file; returns its status."""
        cache = os.environ.get("EMTR_PORTABILITY_CCACHE", "")
        namespace = ["unshare", "--mount", "--pid", "--fork", "--kill-child"]
        places = [str(self.root.resolve()), str(REPOSITORY), cache]
        return subprocess.run(
            [*namespace, "sh", "-c", IN_NAMESPACE, "sh", *places, script],
            stdin=subprocess.DEVNULL,
            stdout=out,
            stderr=subprocess.STDOUT,
            check=False,
        ).returncode

    def _require_means(self) -> None:
        if os.geteuid() != 0:
            raise ChrootFailure("a chroot needs root (--smoke does not)")
        for program in ("debootstrap", "unshare"):
            if shutil.which(program) is None:
                raise ChrootFailure(f"{program} is not installed: apt-get install debootstrap")
        if self.architecture and not (BINFMT / EMULATED[self.architecture]).exists():
            raise ChrootFailure(
                f"this machine does not run programs of {self.architecture}: "
                "apt-get install qemu-user-static binfmt-support"
            )
