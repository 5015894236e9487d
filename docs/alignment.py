#!/usr/bin/env python3
"""Makes docs/alignment.png from the picture that tools/quickstart draws.

Puts three of its four panels (before, after, error map) side by side and saves them with a
palette, which keeps the file small. Run it with build/venv/bin/python, which has Pillow.
"""

from __future__ import annotations

from pathlib import Path

from PIL import Image

DOCS = Path(__file__).resolve().parent
DRAWN = DOCS.parent / "build" / "sample" / "alignment.png"
WRITTEN = DOCS / "alignment.png"

# Left and top edges of the panels, and their size, as shares of the picture.
PANELS = ((0.015, 0.05), (0.51, 0.05), (0.51, 0.525))
WIDTH, HEIGHT = 0.475, 0.465
GAP = 12  # pixels between two panels
PANEL_PIXELS = 600  # width of a panel in the result
COLORS = 200


def panel(picture: Image.Image, left: float, top: float) -> Image.Image:
    box = (left, top, left + WIDTH, top + HEIGHT)
    cropped = picture.crop(tuple(round(v * side) for v, side in zip(box, picture.size * 2)))
    height = round(PANEL_PIXELS * cropped.height / cropped.width)
    return cropped.resize((PANEL_PIXELS, height), Image.Resampling.LANCZOS)


def row_of_panels(picture: Image.Image) -> Image.Image:
    panels = [panel(picture, *corner) for corner in PANELS]
    width = len(panels) * (PANEL_PIXELS + GAP) - GAP
    row = Image.new("RGB", (width, panels[0].height), "white")
    for column, image in enumerate(panels):
        row.paste(image, (column * (PANEL_PIXELS + GAP), 0))
    return row


def save_panels(drawn: Path, written: Path) -> None:
    with Image.open(drawn) as picture:
        row = row_of_panels(picture.convert("RGB"))
    small = row.quantize(COLORS, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    small.save(written, optimize=True)
    print(f"{written}: {row.width} x {row.height}, {written.stat().st_size // 1000} KB")


def main() -> None:
    save_panels(DRAWN, WRITTEN)


if __name__ == "__main__":
    main()
