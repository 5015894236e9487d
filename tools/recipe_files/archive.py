"""The archive of a release: what git has of one commit, in a folder named by the version."""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass
from pathlib import Path

from wheel_build.run import Failure, run

REPOSITORY = Path(__file__).resolve().parents[2]
HEADER = "libemtr/include/emtr/emtr.h"  # the only place where the version is written


@dataclass(frozen=True)
class Archive:
    path: Path
    version: str

    def digest(self, algorithm: str) -> str:
        return hashlib.new(algorithm, self.path.read_bytes()).hexdigest()


def made(folder: Path, commit: str) -> Archive:
    """Writes emtr-VERSION.tar.gz into the folder. The same commit gives the same bytes."""
    version = version_of(run("git", "-C", REPOSITORY, "show", f"{commit}:{HEADER}"))
    path = folder / f"emtr-{version}.tar.gz"
    whole = path.with_name(path.name + ".part")
    words = ["--format=tar.gz", f"--prefix=emtr-{version}/", "-o", whole.resolve()]
    run("git", "-C", REPOSITORY, "archive", *words, commit)
    whole.replace(path)
    return Archive(path, version)


def version_of(header: str) -> str:
    parts = re.findall(r"^#define EMTR_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", header, re.MULTILINE)
    if len(parts) != 3:
        raise Failure(f"{HEADER}: expected EMTR_VERSION_MAJOR, _MINOR and _PATCH")
    return ".".join(parts)
