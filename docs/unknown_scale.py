#!/usr/bin/env python3
"""Makes docs/unknown_scale.png: the sample pair with a source half as large.

Registers it with an unknown scale and puts three panels of plot_alignment() side by side. Run it
after tools/quickstart, with build/venv/bin/python, which has Pillow.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from alignment import DOCS, DRAWN, save_panels

import pyemtr
from pyemtr.plot import plot_alignment


def main() -> None:
    source, target = (
        pyemtr.Cloud(DRAWN.with_name(name)).points for name in ("source.pcd", "target.pcd")
    )
    source = source / 2
    result = pyemtr.register(source, target, scale="free")
    print(result, result.scale)
    with tempfile.TemporaryDirectory() as folder:
        drawn = Path(folder) / "drawn.png"
        plot_alignment(source, target, result.transformation, drawn, unit="mm")
        save_panels(drawn, DOCS / "unknown_scale.png")


if __name__ == "__main__":
    main()
