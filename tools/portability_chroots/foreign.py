"""The root of a Debian for another processor: its packages are extracted, not installed.

The scripts of some 900 packages under emulation take two hours. Programs, headers and libraries
need few of them, and those few lines are here.
"""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from .packages import native_architecture

EMULATED = {"arm64": "qemu-aarch64"}  # the names that binfmt_misc has for them
BINFMT = Path("/proc/sys/fs/binfmt_misc")

# In place of the packages' scripts. BLAS and LAPACK are below folders of their own, where only the
# scripts' links would lead to.
FINISH = """\
set -e
test -e "$1/lib64" || test ! -d "$1/usr/lib64" || ln -s usr/lib64 "$1/lib64"
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


def extract(
    root: Path, suite: str, architecture: str, packages: list[str], mirror: str, out
) -> bool:
    """Makes the root, its log into an open file; returns whether it succeeded."""
    both = f"--architectures={architecture},{native_architecture()}"
    include = f"--include={','.join(packages)}"
    made = ["mmdebstrap", "--variant=extract", "--mode=root", both, include, suite, str(root)]
    return all(
        subprocess.run(words, stdout=out, stderr=out, check=False).returncode == 0
        for words in ([*made, mirror], ["sh", "-c", FINISH, "sh", str(root)])
    )
