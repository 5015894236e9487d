"""The templates, filled with the version of an archive, its hashes, and where it is to be found."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

from .archive import Archive

TEMPLATES = Path(__file__).with_name("templates")


def render(archive: Archive, url: str, folder: Path) -> list[Path]:
    """Writes docker/, conda/ and vcpkg/ into the folder; returns the files written."""
    words = {
        "ARCHIVE": archive.path.name,
        "SHA256": archive.digest("sha256"),
        "SHA512": archive.digest("sha512"),
        "URL": url,
        "VERSION": archive.version,
    }
    written = []
    for template in sorted(path for path in TEMPLATES.rglob("*") if path.is_file()):
        path = folder / template.relative_to(TEMPLATES)
        path.parent.mkdir(parents=True, exist_ok=True)
        text = template.read_text(encoding="utf-8")
        path.write_text(re.sub(r"@([A-Z0-9]+)@", lambda m: words[m[1]], text), encoding="utf-8")
        written.append(path)
    shutil.copy(archive.path, folder / "docker")  # an image is built from one folder
    return written
