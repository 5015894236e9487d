"""What the report says of the methods: where each is from, and with what settings it runs."""

from __future__ import annotations

import importlib

from evolving_methods.methods import CONTROLS, METHODS

from .cases import ITERATIONS, POPULATION
from .traditional import VOXEL_POINTS


def lines() -> list[str]:
    """A section in Markdown."""
    found = [
        "The evolving methods are in `tools/bench/evolving_methods`, one file each, written from "
        "the papers. Each drives the same batched fitness, and its queries are counted. The "
        f"populations have {POPULATION} individuals a task, as EMTR-SSC's {POPULATION} particles "
        f"for {ITERATIONS} iterations. Other settings are those of each paper.",
        "",
        "| method | drives | source |",
        "|---|---|---|",
    ]
    for method in (*METHODS, *CONTROLS):
        source = importlib.import_module(method.place.partition(":")[0]).__doc__ or ""
        first = " ".join(source.split("\n\n")[0].split())
        text = first.partition(": ")[2] or first
        found.append(f"| {method.name} | {', '.join(method.tasks)} | {text} |")
    found += [
        "",
        f"The traditional methods work on clouds of one voxel, which leaves {VOXEL_POINTS} points "
        "in both together. ICP+, NDT+ and TrICP+ begin with the pose of "
        "`pcl::SampleConsensusPrerejective` on FPFH (normals 2 voxels, features 5, 50 000 "
        "iterations, 3 samples of the 3 nearest features, edge similarity 0.9, inliers within 1.5 "
        "voxels). ICP takes matches within 3 voxels, TrICP the best 70 % of all, NDT cells of 4 "
        "voxels. FGR is Open3D's with its authors' settings: mu is divided by 1.4 every fourth of "
        "64 iterations, down to half a voxel; tuple test of similarity 0.95 and 1000 tuples; "
        "features as above.",
        "",
    ]
    return found
