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
    *("libcli11-dev", "nlohmann-json3-dev", "libgtest-dev", "python3-numpy", "python3-pytest"),
    *("ccache", "file", "dpkg-dev"),
]
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

    @property
    def root(self) -> Path:
        return self.folder / self.suite

    def make(self, mirror: str, reuse: bool) -> None:
        """Makes the chroot with its packages. Raises ChrootFailure."""
        mark = self.root / MARK
        if reuse and mark.is_file() and mark.read_text().split() == PACKAGES:
            return
        self._require_means()
        if self.root.exists():
            if any(self.root.iterdir()) and not (mark.is_file() or reuse):
                raise ChrootFailure(f"{self.root}: made by something else, and not removed")
            if not reuse:
                shutil.rmtree(self.root)
        self.folder.mkdir(parents=True, exist_ok=True)
        log = self.folder / f"{self.suite}.log"
        with log.open("w") as out:
            if not (self.root / "etc/debian_version").is_file():
                made = ["debootstrap", "--variant=minbase", self.suite, str(self.root), mirror]
                if subprocess.run(made, stdout=out, stderr=out, check=False).returncode != 0:
                    raise ChrootFailure(f"debootstrap {self.suite} failed, see {log}")
                policy = self.root / "usr/sbin/policy-rc.d"  # no package starts a service
                policy.write_text("#!/bin/sh\nexit 101\n")
                policy.chmod(0o755)
            install = (
                "export DEBIAN_FRONTEND=noninteractive\n"
                "apt-get -o Acquire::Check-Valid-Until=no update\n"  # a mirror may lag behind
                f"apt-get install -y --no-install-recommends {' '.join(PACKAGES)}; apt-get clean"
            )
            if self.run(install, out) != 0:
                raise ChrootFailure(f"{self.suite}: packages could not be installed, see {log}")
        mark.write_text("\n".join(PACKAGES))

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
