"""A chroot of one suite of Debian, and commands in it."""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from . import foreign, packages
from .arguments import REPOSITORY

MARK = "made-by-tools-portability"

# Mounts are made in a namespace of their own, so nothing stays mounted whatever happens.
IN_NAMESPACE = """
mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" || exit
mkdir -p "$1/source" && mount --bind "$2" "$1/source" || exit
mount -o remount,bind,ro "$1/source" || exit
if [ -n "$3" ]; then mkdir -p "$1/ccache" && mount --bind "$3" "$1/ccache" || exit; fi
if [ -n "$PIP_CERT" ]; then
  mkdir -p "$1/ca" && touch "$1/ca/bundle" && mount --bind "$PIP_CERT" "$1/ca/bundle" || exit
fi
exec chroot "$1" env -i HOME=/root LC_ALL=C.UTF-8 ${PIP_CERT:+PIP_CERT=/ca/bundle} \
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
    bare: bool = False  # with nothing in it but what a clone needs

    @property
    def name(self) -> str:
        kind = "readme" if self.bare else self.architecture
        return f"{self.suite}-{kind}" if kind else self.suite

    @property
    def root(self) -> Path:
        return self.folder / self.name

    def packages(self) -> list[str]:
        if self.bare:
            return packages.OF_CLONE
        if self.architecture:
            return [*packages.foreign(), *packages.native(self.architecture)]
        return packages.OF_EMTR

    def make(self, mirror: str, reuse: bool) -> None:
        """Makes the chroot with its packages. Raises ChrootFailure."""
        mark = self.root / MARK
        begun = self.folder / f"{self.name}.begun"  # left by a run that was stopped on the way
        wanted = self.packages()
        if reuse and mark.is_file() and mark.read_text().split() == wanted:
            return
        self._require_means()
        if self.root.exists():
            kept = reuse and not self.architecture
            if any(self.root.iterdir()) and not (mark.is_file() or begun.is_file() or kept):
                raise ChrootFailure(f"{self.root}: made by something else, and not removed")
            if not kept:
                shutil.rmtree(self.root)
        self.folder.mkdir(parents=True, exist_ok=True)
        begun.touch()
        log = self.folder / f"{self.name}.log"
        with log.open("w") as out:
            if self.architecture:
                if not foreign.extract(self.root, self.suite, self.architecture, mirror, out):
                    raise ChrootFailure(f"{self.name}: could not be made, see {log}")
            else:
                self._install(wanted, mirror, out)
        mark.write_text("\n".join(wanted))
        begun.unlink()

    def _install(self, wanted: list[str], mirror: str, out) -> None:
        if not (self.root / "etc/debian_version").is_file():
            made = ["debootstrap", "--variant=minbase", self.suite, str(self.root), mirror]
            if subprocess.run(made, stdout=out, stderr=out, check=False).returncode:
                raise ChrootFailure(f"debootstrap {self.name} failed, see {out.name}")
            policy = self.root / "usr/sbin/policy-rc.d"  # no package starts a service
            policy.write_text("#!/bin/sh\nexit 101\n")
            policy.chmod(0o755)
        install = (
            "export DEBIAN_FRONTEND=noninteractive\n"
            "apt-get -o Acquire::Check-Valid-Until=no update\n"  # a mirror may lag behind
            f"apt-get install -y --no-install-recommends {' '.join(wanted)}; apt-get clean"
        )
        if self.run(install, out) != 0:
            raise ChrootFailure(f"{self.name}: packages could not be installed, see {out.name}")

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
        if self.architecture:
            lack = foreign.missing(self.architecture)
        elif shutil.which("debootstrap") is None:
            lack = "debootstrap is not installed: apt-get install debootstrap"
        else:
            lack = None
        if lack:
            raise ChrootFailure(lack)
