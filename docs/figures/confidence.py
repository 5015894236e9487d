"""The confidence while the overlap of the pair becomes smaller."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from sample import INK, PALE, RIGHT, WRONG, Array, Sample, heading, moved, new_figure
from virtual_scan.overlap import overlap

import pyemtr
from pyemtr.metrics import MAX_ROTATION_ERROR, rotation_error

CUTS = np.concatenate([np.linspace(0, 0.18, 7), np.linspace(0.2, 0.32, 7)])
NEAR = 0.8  # mm, twice the resolution of the scans


def across(sample: Sample) -> Array:
    """The direction (3,) from what only the source's sensor sees to what only the target's sees."""
    center = sample.target.mean(axis=0)
    ways = [moved(sample.source_sensor, sample.pose) - center, sample.target_sensor - center]
    first, second = (way / np.linalg.norm(way) for way in ways)
    return np.asarray(second - first)


def draw(sample: Sample, cuts: Array = CUTS) -> Figure:
    source, direction = sample.moved, across(sample)
    x, y = source @ direction, sample.target @ direction
    shares, confidences, errors = [], [], []
    for cut in cuts:  # what both see is cut off from both sides
        first, second = x < np.quantile(x, 1 - cut), y > np.quantile(y, cut)
        result = pyemtr.register(sample.source[first], sample.target[second])
        shares.append(100 * overlap(source[first], sample.target[second], NEAR))
        confidences.append(result.confidence)
        errors.append(rotation_error(result.transformation, sample.pose))

    right = np.array(errors) < MAX_ROTATION_ERROR
    shares, confidences = np.array(shares), np.array(confidences)
    figure, (ax,) = new_figure(9, 3.2)
    ax.axhline(0.5, color=PALE, linestyle=":", linewidth=1)
    ax.text(69, 0.52, "registered above", fontsize=8.5, color=INK)
    ax.scatter(shares[right], confidences[right], s=44, color=RIGHT, label="the pose is right")
    ax.scatter(
        shares[~right], confidences[~right], s=44, color=WRONG, marker="X", label="it is wrong"
    )
    ax.set(xlim=(70, -2), ylim=(-0.05, 1.08), xlabel="overlap, % of the source's points")
    ax.set_ylabel("confidence")
    ax.legend(frameon=False, fontsize=9, labelcolor=INK, loc="center left", bbox_to_anchor=(0, 0.3))
    heading(ax, "The sample pair, cut so that less and less of it overlaps")
    return figure
