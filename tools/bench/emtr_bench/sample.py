"""The sample pair of the quickstart, of any size: tools/sample_pair.py."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from .locations import TOOLS
from .pairs import Array, DataError


def sample_clouds(folder: Path, points: int = 40000) -> tuple[Array, Array]:
    """Makes the pair, of about so many points a cloud, in `folder`: (n, 3) and (m, 3)."""
    command = [sys.executable, str(TOOLS / "sample_pair.py"), "--out", str(folder)]
    command += ["--points", str(points)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise DataError(f"no sample pair: {' '.join(command)} failed:\n{done.stderr.strip()}")
    sys.path.insert(0, str(TOOLS))  # where sample_pair.py itself finds its modules
    from virtual_scan.files import read_pcd

    source, target = (read_pcd(folder / f"{name}.pcd")[0] for name in ("source", "target"))
    return source, target
