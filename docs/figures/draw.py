#!/usr/bin/env python3
"""Draws the figures of docs/HOW_IT_WORKS.md from runs of pyemtr on the sample pair.

Needs pyemtr[plot]; takes a minute or two.
"""

from __future__ import annotations

import argparse
import io
from pathlib import Path

import candidates
import confidence
import matches
import matplotlib
import swarms
from matplotlib.figure import Figure
from PIL import Image
from sample import make_sample
from virtual_scan.files import write_whole

HERE = Path(__file__).resolve().parent
COLORS = 160  # of a picture with pixels
FIGURES = {
    "matches.png": matches.draw,
    "swarms.svg": swarms.draw,
    "candidates.svg": candidates.draw,
    "confidence.svg": confidence.draw,
}


def write(figure: Figure, path: Path) -> None:
    """The same figure gives the same bytes."""
    content = io.BytesIO()
    if path.suffix == ".svg":
        with matplotlib.rc_context({"svg.hashsalt": path.name}):
            figure.savefig(content, format="svg", metadata={"Date": None})
        lines = [line.rstrip() for line in content.getvalue().splitlines()]
        write_whole(path, b"\n".join(lines) + b"\n")
    else:
        figure.savefig(content, format="png", dpi=130)
        drawn = Image.open(content).convert("RGB")
        small = drawn.quantize(COLORS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
        small.save(whole := io.BytesIO(), format="png", optimize=True)
        write_whole(path, whole.getvalue())
    print(f"{path}: {path.stat().st_size // 1000} KB")


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--out", type=Path, default=HERE, metavar="DIR", help="[%(default)s]")
    parser.add_argument("--points", type=int, default=40000, metavar="N", help="of each scan")
    parser.add_argument("names", nargs="*", default=list(FIGURES), help="all if none is named")
    options = parser.parse_args()
    if unknown := sorted(set(options.names) - set(FIGURES)):
        parser.error(f"{', '.join(unknown)}: expected some of {', '.join(FIGURES)}")
    sample = make_sample(options.points)
    for name in options.names:
        write(FIGURES[name](sample), options.out / name)


if __name__ == "__main__":
    main()
