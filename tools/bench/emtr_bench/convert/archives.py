"""Unpacks archives: the files that may matter, and nothing outside the folder."""

from __future__ import annotations

import shutil
import tarfile
import zipfile
import zlib
from pathlib import Path, PurePosixPath
from typing import IO

from ..pairs import DataError

#: Endings of files that a set is read from.
WANTED = {".ply", ".conf", ".log", ".xf", ".txt", ".off"}
_TAR = (".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tar.xz")


def unpack_all(folder: Path, scratch: Path) -> list[Path]:
    """The folders to look into: `folder` itself, and one below `scratch` for each archive in it.
    Raises DataError, which names it, for an archive that cannot be read."""
    found = [folder]
    for number, archive in enumerate(sorted(p for p in folder.rglob("*") if is_archive(p))):
        own = scratch / f"{number}"
        print(f"unpacking {archive}", flush=True)
        try:
            unpack(archive, own)
        except (OSError, EOFError, tarfile.TarError, zipfile.BadZipFile, zlib.error) as error:
            raise DataError(f"{archive}: not a whole archive: {error}") from error
        found.append(own)
    return found


def is_archive(path: Path) -> bool:
    name = path.name.casefold()
    return path.is_file() and (name.endswith(".zip") or name.endswith(_TAR))


def unpack(archive: Path, folder: Path) -> None:
    """Its files with a wanted ending, at their paths below the folder, which is made."""
    folder.mkdir(parents=True)
    if archive.name.casefold().endswith(".zip"):
        with zipfile.ZipFile(archive) as opened:
            for entry in opened.infolist():
                if not entry.is_dir() and _is_wanted(entry.filename):
                    with opened.open(entry) as content:
                        _write(content, folder / entry.filename)
        return
    with tarfile.open(archive) as packed:
        for member in packed:
            content = packed.extractfile(member) if member.isfile() else None
            if content is not None and _is_wanted(member.name):
                _write(content, folder / member.name)


def _is_wanted(name: str) -> bool:
    path = PurePosixPath(name)
    inside = not path.is_absolute() and ".." not in path.parts
    hidden = any(part.startswith((".", "__MACOSX")) and part != "." for part in path.parts)
    return inside and not hidden and path.suffix.casefold() in WANTED


def _write(content: IO[bytes], path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("wb") as file:
        shutil.copyfileobj(content, file)
