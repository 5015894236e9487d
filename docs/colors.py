#!/usr/bin/env python3
"""Makes docs/colors.png: a wall laid on itself by shape alone, and by shape and colors.

Run it with an interpreter that has pyemtr and matplotlib, as build/venv/bin/python.
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
from matplotlib import pyplot as plt
from PIL import Image

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS.parent / "tools" / "bench"))

from emtr_bench.colors.scenes import wall  # noqa: E402

import pyemtr  # noqa: E402

SEED = 0


def main() -> None:
    case = wall(SEED)
    shape = pyemtr.register(case.source, case.target)
    colors = pyemtr.register(
        case.source,
        case.target,
        source_colors=case.source_colors,
        target_colors=case.target_colors,
    )
    figure, axes = plt.subplots(1, 2, figsize=(11, 3.6), layout="constrained")
    center = case.target.mean(axis=0)
    across = np.linalg.svd(case.target - center, full_matrices=False)[2][:2].T
    for panel, result, title in zip(axes, (shape, colors), ("shape alone", "shape and colors")):
        for points, shown in (
            (case.target, case.target_colors),
            (result.apply(case.source), case.source_colors),
        ):
            flat = (points - center) @ across
            panel.scatter(flat[:, 0], flat[:, 1], s=1.2, c=shown, linewidths=0, alpha=0.6)
        panel.set_title(f"{title}: {result.reason}", fontsize=11)
        panel.set_aspect("equal")
        panel.set_axis_off()
    figure.savefig(DOCS / "colors.png", dpi=82)
    with Image.open(DOCS / "colors.png") as drawn:
        small = drawn.convert("RGB").quantize(200, method=Image.Quantize.FASTOCTREE)
    small.save(DOCS / "colors.png", optimize=True)  # a palette keeps the file small
    print(f"{DOCS / 'colors.png'}: {(DOCS / 'colors.png').stat().st_size // 1000} KB")


if __name__ == "__main__":
    main()
