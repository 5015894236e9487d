"""The root of a Debian for another processor: its packages are extracted, not installed.

The scripts of some 900 packages under emulation take two hours. Programs, headers and libraries
need few of them, and those few lines are here.
"""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from . import packages

EMULATED = {"arm64": "qemu-aarch64"}  # the names that binfmt_misc has for them
BINFMT = Path("/proc/sys/fs/binfmt_misc")

# mmdebstrap extracts into an empty folder alone; so the second part comes as an archive.
EXTRACT = """\
set -e
root=$1 suite=$2 mirror=$3 there=$4 packages_there=$5 packages_here=$6
extract() {
  mmdebstrap --variant=extract --mode=root --architectures="$1" --include="$2" \
    "$suite" "$3" "$mirror"
}
extract "$there" "$packages_there" "$root"
extract "$(dpkg --print-architecture)" "$packages_here" "$root/native.tar"
tar -C "$root" --keep-directory-symlink -xf "$root/native.tar"
rm "$root/native.tar"
"""
# In place of the packages' scripts. BLAS and LAPACK are below folders of their own, where only the
# scripts' links would lead to.
FINISH = """\
cp "$1/usr/share/base-passwd/passwd.master" "$1/etc/passwd"
cp "$1/usr/share/base-passwd/group.master" "$1/etc/group"
ln -sf mawk "$1/usr/bin/awk"
for folder in "$1"/usr/lib/*/blas "$1"/usr/lib/*/lapack; do
  test ! -d "$folder" || echo "/${folder#"$1/"}"
done > "$1/etc/ld.so.conf.d/extracted.conf"
chroot "$1" /sbin/ldconfig
"""


def missing(architecture: str) -> str | None:
    """Says what this machine lacks to make and run such a root, or None."""
    if shutil.which("mmdebstrap") is None:
        return "mmdebstrap is not installed: apt-get install mmdebstrap"
    if not (BINFMT / EMULATED[architecture]).exists():
        return (
            f"this machine does not run programs of {architecture}: "
            "apt-get install qemu-user-static binfmt-support"
        )
    return None


def extract(root: Path, suite: str, architecture: str, mirror: str, out) -> bool:
    """Makes the root, its log into an open file; returns whether it succeeded."""
    lists = (",".join(packages.foreign()), ",".join(packages.native(architecture)))
    words = [str(root), suite, mirror, architecture, *lists]
    made = ["sh", "-c", EXTRACT + FINISH, "sh", *words]
    return subprocess.run(made, stdout=out, stderr=out, check=False).returncode == 0
