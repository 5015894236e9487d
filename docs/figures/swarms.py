"""The best fitness of both swarms after each iteration, as published and with seeds."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sample import INK, PALE, SOURCE, TARGET, Array, Sample, heading, new_figure

import pyemtr

RUNS = 5
PRESETS = (
    ("paper", SOURCE, "no seeds (preset paper)"),
    ("default", TARGET, "with seeds (default)"),
)


def mean_rho(result: pyemtr.Result) -> tuple[Array, int]:
    """Alpha's fitness for each point, 0 (best) to 1, and the iteration of the switch to dense."""
    switch = round(result.settings["switch_fraction"] * result.iterations)
    points = np.full(result.iterations, result.dense_source + result.dense_target)
    points[:switch] = result.sparse_source
    return result.history["alpha"] / points, switch


def draw(sample: Sample) -> Figure:
    figure, (alpha, beta) = new_figure(9, 3.4, columns=2)
    for preset, color, label in PRESETS:
        for seed in range(RUNS):
            run = pyemtr.register(
                sample.source, sample.target, preset=preset, seed=seed, stall_iterations=0
            )
            share = np.arange(1, run.iterations + 1) / run.iterations
            rho, switch = mean_rho(run)
            line = {"color": color, "alpha": 0.75, "linewidth": 1.2}
            alpha.plot(share[:switch], rho[:switch], **line, label=None if seed else label)
            alpha.plot(share[switch:], rho[switch:], **line)
            beta.plot(share, run.history["beta"] / run.tims, **line)
    mark_switch(alpha, switch / run.iterations)
    heading(alpha, "Swarm alpha: distance between the clouds")
    alpha.set_ylabel("mean $\\rho$ of the best pose")
    alpha.legend(frameon=False, fontsize=9, labelcolor=INK)
    alpha.set_ylim(0.3, 1.05)
    heading(beta, "Swarm beta: disagreement of the matches")
    beta.set_ylabel("mean cost of a TIM, $\\tau$")
    beta.set_ylim(bottom=0)
    for ax in (alpha, beta):
        ax.set_xlabel("share of the iterations")
    return figure


def mark_switch(ax: Axes, share: float) -> None:
    ax.axvline(share, color=PALE, linestyle=":", linewidth=1)
    ax.text(share - 0.01, 0.32, "sparse", ha="right", fontsize=8, color=INK)
    ax.text(share + 0.01, 0.32, "dense", ha="left", fontsize=8, color=INK)
