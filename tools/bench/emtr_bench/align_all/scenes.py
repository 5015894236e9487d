"""Scenes of many scans: from pairs with known poses, and generated ones."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from ..pairs import FILES, Array, Pair, read_ply, read_transformation

FEWEST = 3  # scans of a scene


@dataclass(frozen=True)
class Scene:
    """Scans, each in a frame of its own.

    Attributes:
        name: group and first word of the pairs.
        clouds: (n, 3) each.
        truth: (4, 4) by scan, scan -> frame of its chain.
        chain: which scans have poses to each other that are known.
    """

    name: str
    clouds: list[Array]
    truth: list[Array]
    chain: list[int]


def scenes_of(pairs: Iterable[Pair], seed: int) -> Iterator[Scene]:
    """The scenes that the pairs make, in the order of their names."""
    grouped: dict[str, list[Pair]] = {}
    for pair in pairs:
        if pair.related and pair.tier not in ("clutter", "scale"):
            name = f"{pair.group}/{pair.name.split('_')[0]}"
            grouped.setdefault(name, []).append(pair)
    for name, members in sorted(grouped.items()):
        scene = _scene(name, members, seed)
        if len(scene.clouds) >= FEWEST:
            yield scene


def generated(seed: int, scans: dict[int, int]) -> Scene:
    """Scans of bumpy things from several sides: their number by the seed of the thing."""
    rng = np.random.default_rng(seed)
    clouds, chain = [], []
    for thing, count in scans.items():
        for k in range(count):
            angle = 2 * np.pi * k / max(count, 1)
            view = np.array([np.cos(angle), np.sin(angle), 0.3 * (-1) ** k])
            points = _thing(thing, rng, 10000)
            points = points[points @ view > 0.1 * np.linalg.norm(view)]
            clouds.append(points + rng.normal(scale=0.002, size=points.shape))
            chain.append(thing)
    return _moved("generated", clouds, [np.eye(4)] * len(clouds), chain, rng)


def virtual(seed: int) -> Scene:
    """Virtual scans of the small dragon from eight sides, as docs/many_scans.py has them: parts of
    it hide others, and it has thin wings."""
    from ..virtual_pairs import scenes  # it says where the scanner is

    scanner = scenes.scanner
    rng = np.random.default_rng(seed)
    views = [(45 * k, 18 if k % 2 else 32) for k in range(8)]  # azimuth and elevation, degrees
    clouds = [scanner.scan(scanner.viewpoint(*view), 12000, 0.1, rng).points for view in views]
    return _moved("virtual", clouds, [np.eye(4)] * len(clouds), [0] * len(clouds), rng)


def _thing(seed: int, rng: np.random.Generator, count: int) -> Array:
    fixed = np.random.default_rng(1000 + seed)
    bumps = _directions(fixed, 50)
    heights = fixed.uniform(0.1, 0.28, 50) * fixed.choice([-1, 1], 50)
    at = _directions(rng, count)
    relief = np.exp(20 * (at @ bumps.T - 1)) @ heights
    return at * (1 + relief)[:, None] * [1.0, 0.82, 0.68]


def _directions(rng: np.random.Generator, count: int) -> Array:
    vectors = rng.normal(size=(count, 3))
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def random_rotation(rng: np.random.Generator) -> Array:
    """A rotation (3, 3), all alike likely."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def _scene(name: str, pairs: list[Pair], seed: int) -> Scene:
    number: dict[str, int] = {}
    clouds: list[Array] = []
    edges: list[tuple[int, int, Array]] = []
    for pair in pairs:
        ends = []
        for file in FILES[:2]:
            path = pair.folder / file
            key = hashlib.sha256(path.read_bytes()).hexdigest()
            if key not in number:
                number[key] = len(clouds)
                clouds.append(read_ply(path))
            ends.append(number[key])
        edges.append((ends[0], ends[1], read_transformation(pair.folder / FILES[2])))
    truth, chain = _chained(len(clouds), edges)
    rng = np.random.default_rng([seed, len(clouds)])
    return _moved(name, clouds, truth, chain, rng)


def _chained(count: int, edges: list[tuple[int, int, Array]]) -> tuple[list[Array], list[int]]:
    poses: dict[int, Array] = {}
    chain = [0] * count
    for first in range(count):
        if first in poses:
            continue
        poses[first], waiting = np.eye(4), [first]
        while waiting:
            scan = waiting.pop(0)
            chain[scan] = first
            for source, target, T in edges:
                if target == scan and source not in poses:
                    poses[source] = poses[scan] @ T
                    waiting.append(source)
                elif source == scan and target not in poses:
                    poses[target] = poses[scan] @ np.linalg.inv(T)
                    waiting.append(target)
    return [poses[scan] for scan in range(count)], chain


def _moved(
    name: str, clouds: list[Array], truth: list[Array], chain: list[int], rng: np.random.Generator
) -> Scene:
    """The same scene with each scan moved at random."""
    moved, poses = [], []
    for cloud, pose in zip(clouds, truth):
        motion = np.eye(4)
        motion[:3, :3] = random_rotation(rng)
        motion[:3, 3] = rng.uniform(-1, 1, 3) * np.ptp(cloud, axis=0).max()
        moved.append(cloud @ motion[:3, :3].T + motion[:3, 3])
        poses.append(pose @ np.linalg.inv(motion))
    return Scene(name, moved, poses, chain)
