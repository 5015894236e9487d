"""The answer's score beside the scores of the other poses."""

from __future__ import annotations

from matplotlib.figure import Figure
from sample import INK, RIGHT, SOURCE, Sample, heading, new_figure

import pyemtr
from pyemtr.metrics import rotation_error


def draw(sample: Sample) -> Figure:
    result = pyemtr.register(sample.source, sample.target)
    poses = [(result.score, result.surface_fit, result.violation, 0.0)] + [
        (a.score, a.surface_fit, a.violation,
         rotation_error(a.transformation, result.transformation))
        for a in result.alternatives
    ]  # fmt: skip
    rows = range(len(poses))
    figure, (ax,) = new_figure(9, 3.4)
    ax.barh(rows, [p[1] for p in poses], 0.62, color=RIGHT, label="surface fit")
    ax.barh(rows, [-p[2] for p in poses], 0.62, color=SOURCE, label="violation of free space")
    ax.plot([p[0] for p in poses], rows, "D", color=INK, markersize=4.5, label="score")
    ax.axvline(0, color=INK, linewidth=0.8)
    names = ["the answer"] + [f"{angle:.0f}° from it" for *_, angle in poses[1:]]
    ax.set_yticks(list(rows), names)
    ax.invert_yaxis()
    ax.legend(frameon=False, fontsize=9, labelcolor=INK, loc="lower right")
    heading(
        ax, f"{result.candidates} candidates were ranked; the answer and the best of the others"
    )
    return figure
