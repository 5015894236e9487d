"""The matches of the features, right and wrong ones."""

from __future__ import annotations

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from sample import RIGHT, SOURCE, TARGET, Array, Sample, heading, moved, new_figure

import pyemtr

NEAR = 2.0  # dense leaves: a right match


def draw(sample: Sample) -> Figure:
    problem = pyemtr.Problem(sample.source, sample.target)
    scale, pose = problem.normalization_scale, sample.pose
    source = problem.source_feature_points * scale + problem.center_source
    target = problem.target_feature_points * scale + problem.center_target
    first, second = problem.correspondences.T
    source = moved(source.astype(float), pose)
    apart = np.linalg.norm(source[first] - target[second], axis=1)
    right = apart < NEAR * problem.leaf_dense * scale

    axes = seen_from(sample)
    a, b = source @ axes.T, target @ axes.T
    b[:, 0] += 1.15 * np.ptp(a[:, 0])
    lines = np.stack([a[first], b[second]], axis=1)
    figure, (ax,) = new_figure(9, 4.2)
    ax.scatter(*a.T, s=1.5, color=SOURCE, linewidths=0)
    ax.scatter(*b.T, s=1.5, color=TARGET, linewidths=0)
    ax.add_collection(LineCollection(lines[~right], colors="#999999", linewidths=0.25, alpha=0.55))
    ax.add_collection(LineCollection(lines[right], colors=RIGHT, linewidths=0.5, alpha=0.8))
    ax.set_aspect("equal")
    ax.axis("off")
    heading(
        ax, f"{len(right)} matches: {right.sum()} are right (green), {(~right).sum()} are wrong"
    )
    ax.text(0.0, -0.02, "source", color=SOURCE, transform=ax.transAxes, fontsize=10)
    ax.text(1.0, -0.02, "target", color=TARGET, transform=ax.transAxes, fontsize=10, ha="right")
    return figure


def seen_from(sample: Sample) -> Array:
    """Rows (2, 3): to the right and up, seen from between the two sensors; z is up."""
    center = sample.target.mean(axis=0)
    ways = [moved(sample.source_sensor, sample.pose) - center, sample.target_sensor - center]
    view = sum(way / np.linalg.norm(way) for way in ways)
    right = np.cross([0.0, 0.0, 1.0], view)
    up = np.cross(view, right)
    return np.array([right / np.linalg.norm(right), up / np.linalg.norm(up)])
