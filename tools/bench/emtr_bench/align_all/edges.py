"""How large the errors of edges are beside what their information matrices say.

The error of an edge is the small motion from its pose to the true one: a rotation w about the
target's centroid and a translation v. With a matrix I of the motion that is true, m' I m has the
chi-squared distribution of six degrees of freedom, whose median is 5.35. The factor is by how much
the standard deviations of the library's matrix would have to be longer for that median.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterable
from typing import Any

import numpy as np

import pyemtr

from .. import machine
from ..pairs import Array
from ..whole_file import write_whole
from .judge import RIGHT, within_limits
from .scenes import Scene, generated, virtual

_MEDIAN, _NINETY = 5.348, 10.645  # of chi-squared with six degrees of freedom
_SEEDS = range(3)  # of the scenes whose poses are exact
_OVERLAPS = ((0.0, 0.35), (0.35, 0.6), (0.6, 1.0))
HEAD = (
    f"{'scene':<24}{'overlap':<12}{'edges':>6}{'factor':>8}{'90 %':>8}"
    f"{'with 10':>9}{'90 %':>8}{'degrees':>9}{'radii':>9}"
)


def measure_edges(scenes: Iterable[Scene], arguments: argparse.Namespace) -> int:
    """Prints the factors of the edges that are right, of the scenes and of generated ones."""
    print(HEAD, flush=True)
    rows = []
    for name, make in (("generated", _generated), ("virtual", virtual)):
        together = [one for seed in _SEEDS for one in errors_of(make(seed), arguments)]
        for low, high in _OVERLAPS:
            some = [one for one in together if low <= one["overlap"] < high]
            rows.append(row(name, f"{low:.2f}-{high:.2f}", some))
            print(line(rows[-1]), flush=True)
        rows.append(row(name, "all", together))
        print(line(rows[-1]), flush=True)
    for scene in scenes:
        rows.append(row(scene.name, "all", errors_of(scene, arguments)))
        print(line(rows[-1]), flush=True)
    if arguments.json:
        value = {"benchmark": "align_all --edges", "seed": arguments.seed, "rows": rows,
                 "machine": machine.describe(("pyemtr", "numpy", "gtsam"))}  # fmt: skip
        write_whole(arguments.json, json.dumps(value, indent=1) + "\n")
        print(f"wrote {arguments.json}")
    return 0


def _generated(seed: int) -> Scene:
    return generated(seed, {1: 8, 2: 6, 3: 4})


def errors_of(scene: Scene, arguments: argparse.Namespace) -> list[dict[str, Any]]:
    """The errors of the registered edges of a scene that are right and whose pose is known."""
    result = pyemtr.align_all(
        scene.clouds, seed=arguments.seed, threads=arguments.threads or 0, joint_refinement=False
    )
    found = []
    for edge in result.edges:
        pair = result.registration(edge.source, edge.target)
        known = scene.chain[edge.source] == scene.chain[edge.target]
        if not (edge.registered and known and edge.alternative == 0):
            continue
        if not np.isfinite(pair.information).all() or pair.unconstrained_directions:
            continue
        true = np.linalg.inv(scene.truth[edge.target]) @ scene.truth[edge.source]
        motion = motion_between(edge.transformation, true, edge.center_target)
        degrees = float(np.degrees(np.linalg.norm(motion[:3])))
        radii = float(np.linalg.norm(motion[3:]) / result.radius)
        if within_limits((degrees, radii), RIGHT):
            found.append(
                {
                    "overlap": min(pair.overlap_source, pair.overlap_target),
                    "raw": float(motion @ pair.information @ motion),
                    "normalized": float(motion @ edge.information @ motion),
                    "degrees": degrees,
                    "radii": radii,
                }
            )
    return found


def motion_between(found: Array, true: Array, center: Array) -> Array:
    """The rotation vector about the center and the translation (6,) from a pose to the true one."""
    apart = true @ np.linalg.inv(found)
    skew = (apart[:3, :3] - apart[:3, :3].T) / 2
    axis = np.array([skew[2, 1], skew[0, 2], skew[1, 0]])
    size = float(np.linalg.norm(axis))
    angle = np.arctan2(size, (np.trace(apart[:3, :3]) - 1) / 2)
    rotation = axis * (angle / size) if size > 0 else axis
    return np.concatenate([rotation, apart[:3, :3] @ center + apart[:3, 3] - center])


def row(name: str, overlap: str, errors: list[dict[str, Any]]) -> dict[str, Any]:
    """The factors: the root of how far the quantiles are above those of chi-squared."""
    found: dict[str, Any] = {"scene": name, "overlap": overlap, "edges": len(errors)}
    for key, which in (("factor", "raw"), ("with_10", "normalized")):
        values = np.array([one[which] for one in errors] or [np.nan])
        found[key] = float(np.sqrt(np.median(values) / _MEDIAN))
        found[f"{key}_90"] = float(np.sqrt(np.quantile(values, 0.9) / _NINETY))
    for key in ("degrees", "radii"):
        found[key] = float(np.median([one[key] for one in errors] or [np.nan]))
    return found


def line(one: dict[str, Any]) -> str:
    """A row as text."""
    return (
        f"{one['scene']:<24}{one['overlap']:<12}{one['edges']:>6}{one['factor']:>8.1f}"
        f"{one['factor_90']:>8.1f}{one['with_10']:>9.2f}{one['with_10_90']:>8.2f}"
        f"{one['degrees']:>9.3f}{one['radii']:>9.4f}"
    )
