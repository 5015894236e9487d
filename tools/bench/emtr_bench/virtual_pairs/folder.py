"""The generated pairs on disk, made once."""

from __future__ import annotations

import hashlib
import shutil
import tempfile
from pathlib import Path

from ..layout import COLUMNS, MANIFEST, write_manifest, write_pair
from ..locations import REPOSITORY, TOOLS
from ..pairs import DataError

FOLDER = REPOSITORY / "build" / "virtual_pairs"
#: What the pairs are made by: another state of it has a folder of its own.
_SOURCES = (
    *sorted((TOOLS / "virtual_scan").glob("*.py")),
    *sorted(Path(__file__).parent.glob("*.py")),
    Path(__file__).parents[1] / "bumpy_ball.py",
)


def virtual_pairs() -> Path:
    """The folder of the pairs, in the layout of docs/BENCHMARKING.md; makes it where it is not
    there yet. Raises DataError where it cannot be written."""
    own = FOLDER / _fingerprint()
    if (own / MANIFEST).is_file():
        return own
    print(f"making the generated pairs in {own}, once ...", flush=True)
    try:
        FOLDER.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=FOLDER, prefix=".part-") as scratch:
            made = Path(scratch) / "made"
            _write(made)
            _rename(made, own)
    except OSError as error:
        raise DataError(f"no generated pairs: {error}; name others by --data") from error
    return own


def _write(folder: Path) -> None:
    from .scenes import all_pairs

    rows = []
    for made in all_pairs():
        place = folder / "pairs" / made.group / made.name
        write_pair(place, made.source, made.target, made.T_gt, made.sensors)
        figures = (made.group, made.name, made.tier, len(made.source), len(made.target), "", "")
        rows.append(dict(zip(COLUMNS, map(str, figures))))
    write_manifest(folder, rows)


def _rename(made: Path, own: Path) -> None:
    """Another process may have been the faster one: its pairs are the same."""
    try:
        made.rename(own)
    except OSError:
        if not (own / MANIFEST).is_file():
            raise
        shutil.rmtree(made)


def _fingerprint() -> str:
    digest = hashlib.sha256()
    for file in _SOURCES:
        digest.update(f"{file.name}\0".encode() + file.read_bytes())
    return digest.hexdigest()[:12]
