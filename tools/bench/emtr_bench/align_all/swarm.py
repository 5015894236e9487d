"""An experiment: does a swarm over all poses at once, with transfer between pairs, refine better?

The joint refinement of :func:`pyemtr.align_all` goes downhill from the poses of the graph. Here
three ways begin at the same poses, near the true ones, and each ends with that refinement:

* ``descent``: the refinement alone.
* ``swarm``: a particle swarm over all poses of the model. Its fitness is the mean truncated
  distance of each scan's points to the scans that it overlaps. Then the refinement of its best.
* ``transfer``: the same, and with a chance of a half a particle takes the pose of one scan from the
  particle that is best for one of that scan's pairs, as evolutionary multitasking transfers what
  one task has learned to another.

All swarms evaluate the fitness as often.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from time import process_time
from typing import Any

import numpy as np

from pyemtr.multiway.joint import refine_jointly
from pyemtr.multiway.rigid import exponential, inverse, moved
from pyemtr.multiway.surface import Surface, make_surface
from pyemtr.neighborhood import neighbor_tree

from ..pairs import Array
from .scenes import Scene, generated, virtual

_PARTICLES, _ITERATIONS = 16, 25
_POINTS = 150  # of a scan whose distances are measured
_REACH = 0.06  # radii at which a distance is truncated
_SPREADS = ((1.0, 0.02), (4.0, 0.08), (10.0, 0.2))  # of the start: degrees and radii
_OVERLAP = 0.2  # from which two scans are a pair
_INERTIA, _OWN, _COMMON = 0.7, 1.5, 1.5
_TRANSFER = 0.5

Poses = list[Array]
HEAD = (
    f"{'scene':<12}{'start':>16}{'way':>10}{'degrees':>10}{'largest':>10}{'radii':>9}"
    f"{'largest':>9}{'cpu':>7}"
)


class Model:
    """The scans of one thing, in radii, and the pairs that overlap under the true poses."""

    def __init__(self, scene: Scene, members: list[int]) -> None:
        clouds = [scene.clouds[i] for i in members]
        self.radius = float(np.median([np.linalg.norm(c - c.mean(axis=0), axis=1).max()
                                       for c in clouds]))  # fmt: skip
        self.truth = [inverse(scene.truth[members[0]]) @ scene.truth[i] for i in members]
        self.surfaces: list[Surface] = [make_surface(cloud, self.radius) for cloud in clouds]
        self.trees = [neighbor_tree(surface.points) for surface in self.surfaces]
        self.samples = [s.points[:: max(1, len(s.points) // _POINTS)] for s in self.surfaces]
        self.centers = [surface.points.mean(axis=0) for surface in self.surfaces]
        count = len(members)
        self.pairs = [(j, i) for j in range(count) for i in range(j)
                      if self.overlap(j, i) > _OVERLAP]  # fmt: skip

    def overlap(self, source: int, target: int) -> float:
        between = inverse(self.truth[target]) @ self.truth[source]
        found = self.trees[target].query(moved(between, self.samples[source]))[0]
        return float(np.mean(found < 0.03 * self.radius))

    def distance(self, poses: Poses, pair: tuple[int, int]) -> float:
        """The mean truncated distance of a pair, both ways, in units of the truncation."""
        total = 0.0
        for a, b in (pair, pair[::-1]):
            between = inverse(poses[b]) @ poses[a]
            found = self.trees[b].query(moved(between, self.samples[a]))[0]
            total += float(np.minimum(found / (_REACH * self.radius), 1).mean())
        return total / 2

    def errors(self, poses: Poses) -> Array:
        """Degrees and radii of the centroid (N - 1, 2), against the first scan."""
        found = []
        for pose, true, center in list(zip(poses, self.truth, self.centers))[1:]:
            apart = inverse(true) @ pose
            cosine = np.clip((np.trace(apart[:3, :3]) - 1) / 2, -1, 1)
            away = np.linalg.norm(moved(apart, center[None])[0] - center) / self.radius
            found.append((float(np.degrees(np.arccos(cosine))), float(away)))
        return np.array(found)

    def refined(self, poses: Poses) -> Poses:
        weights = dict.fromkeys(self.pairs, 1.0)
        found = refine_jointly(
            dict(enumerate(poses)), dict(enumerate(self.surfaces)), self.radius, 0, 1, weights
        )
        return [found[i] for i in range(len(poses))]


def posed(model: Model, start: Poses, particle: Array) -> Poses:
    """The poses of a particle: a small motion (w, v in radii) of each scan about its centroid."""
    poses = [start[0]]
    for i, motion in enumerate(particle.reshape(-1, 6), 1):
        center = moved(start[i], model.centers[i][None])[0]
        step = exponential(np.concatenate([motion[:3], model.radius * motion[3:]]))
        step[:3, 3] += center - step[:3, :3] @ center
        poses.append(step @ start[i])
    return poses


def searched(
    model: Model, start: Poses, spread: tuple[float, float], transfer: bool, seed: int
) -> Poses:
    """The best poses of a swarm around the start."""
    rng = np.random.default_rng(seed)
    size = 6 * (len(start) - 1)
    scale = np.tile([np.radians(spread[0])] * 3 + [spread[1]] * 3, len(start) - 1)
    place = rng.normal(size=(_PARTICLES, size)) * scale
    place[0] = 0
    speed = np.zeros_like(place)

    def tasks(particle: Array) -> Array:
        poses = posed(model, start, particle)
        return np.array([model.distance(poses, pair) for pair in model.pairs])

    own, own_tasks = place.copy(), np.array([tasks(one) for one in place])
    for _ in range(_ITERATIONS):
        best = own[own_tasks.mean(axis=1).argmin()]
        a, b = rng.uniform(size=(2, *place.shape))
        speed = _INERTIA * speed + _OWN * a * (own - place) + _COMMON * b * (best - place)
        place = place + speed
        if transfer:
            for particle in place:
                if rng.uniform() < _TRANSFER:
                    task = int(rng.integers(len(model.pairs)))
                    giver = own[own_tasks[:, task].argmin()]
                    scan = int(rng.choice(model.pairs[task]))
                    if scan:
                        particle[6 * scan - 6 : 6 * scan] = giver[6 * scan - 6 : 6 * scan]
        for k, particle in enumerate(place):
            found = tasks(particle)
            if found.mean() < own_tasks[k].mean():
                own[k], own_tasks[k] = particle, found
    return posed(model, start, own[own_tasks.mean(axis=1).argmin()])


def compare(arguments: argparse.Namespace) -> int:
    """Prints the errors that each way leaves."""
    print(HEAD, flush=True)
    scenes: Mapping[str, Scene] = {
        "generated": generated(arguments.seed, {1: 6}),
        "virtual": virtual(arguments.seed),
    }
    for name, scene in scenes.items():
        model = Model(scene, list(range(len(scene.clouds))))
        for spread in _SPREADS:
            for way, found, cpu in ways(model, spread, arguments.seed):
                errors = model.errors(found)
                middle, most = np.median(errors, axis=0), errors.max(axis=0)
                print(
                    f"{name:<12}{f'{spread[0]:g} deg {spread[1]:g} r':>16}{way:>10}"
                    f"{middle[0]:>10.3f}{most[0]:>10.3f}{middle[1]:>9.4f}{most[1]:>9.4f}{cpu:>7.1f}",
                    flush=True,
                )
    return 0


def ways(model: Model, spread: tuple[float, float], seed: int) -> list[tuple[str, Poses, float]]:
    rng = np.random.default_rng(seed + 1)
    scale = np.array([np.radians(spread[0])] * 3 + [spread[1]] * 3)
    particle = (rng.normal(size=(len(model.truth) - 1, 6)) * scale).ravel()
    start = posed(model, model.truth, particle)
    found: list[tuple[str, Poses, float]] = [("start", start, 0.0)]
    begin: Any = process_time()
    found.append(("descent", model.refined(start), process_time() - begin))
    for way, transfer in (("swarm", False), ("transfer", True)):
        begin = process_time()
        poses = searched(model, start, spread, transfer, seed)
        found.append((way, model.refined(poses), process_time() - begin))
    return found
