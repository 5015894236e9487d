"""A car that knows its street: sweep after sweep of a LiDAR is found in a map, and how fast.

The map is made of sweeps from known places, as a mapping run leaves it. Then the car drives two
laps, is carried away twice in each, and sees another street once. Each sweep is looked for near the
last pose, and in the whole map where that does not convince. ``python localize.py 10`` drives ten.

With real sweeps, frames of one place that are pairs with a ``T_gt.txt``:
``EMTR_DATA=folder python localize.py`` takes ``pairs/lidar/*`` of it: each target is a map.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from time import process_time

import numpy as np
import scenes

import pyemtr
import pyemtr.metrics

Array = scenes.Array


def street(seed: int) -> Array:
    """Returns boxes (B, 2, 3): the ground, houses on both sides, and cars."""
    rng = np.random.default_rng(seed)
    boxes = [[[-130.0, -60, -1], [130, 60, 0]]]
    for side in (-1, 1):
        x = -110.0
        while x < 110:
            wide, depth, tall = rng.uniform([6, 5, 4], [16, 12, 12])
            wall = side * rng.uniform(8, 11)
            low, high = sorted((wall, wall + side * depth))
            boxes.append([[x, low, 0], [x + wide, high, tall]])
            x += wide + rng.uniform(1, 8)
    for _ in range(24):
        x, y = rng.uniform(-100, 100), rng.choice([-6.5, 4.5])
        boxes.append([[x, y, 0], [x + 4.2, y + 1.8, 1.5]])
    return np.array(boxes)


elevation, azimuth = np.meshgrid(
    np.radians(np.linspace(-24, 12, 32)), np.arange(0, 2 * np.pi, 0.01)
)
RAYS = np.column_stack(
    [
        (np.cos(elevation) * np.cos(azimuth)).ravel(),
        (np.cos(elevation) * np.sin(azimuth)).ravel(),
        np.sin(elevation).ravel(),
    ]
)


def sweep(world: Array, x: float, y: float, heading: float, seed: int) -> tuple[Array, Array]:
    """Returns the points of a sweep in the car's frame, and the car's true pose (4, 4)."""
    pose = scenes.motion((0, 0, heading), (x, y, 1.8))
    points = scenes.scan(world, pose[:3, 3], RAYS, noise=0.02, seed=seed)
    points = points[np.linalg.norm(points, axis=1) < 50]
    return points @ pose[:3, :3], pose


def report(name: str, location: pyemtr.Location, true: Array | None) -> str:
    """Returns a line on where a sweep was found."""
    text = f"{name}: {location.result.reason} by {location.by}, {1000 * location.seconds:.0f} ms"
    if true is None or not location.registered:
        return text
    degrees = pyemtr.metrics.rotation_error(location.pose, true)
    meters = np.linalg.norm((location.pose - true)[:3, 3])
    return f"{text}, {meters:.3f} m off, rotation error {degrees:.3f} degrees"


class Latency:
    """How long sweeps took, by the clock and of the processors, apart by how they were found."""

    def __init__(self) -> None:
        self._times: dict[str, list[tuple[float, float]]] = {}
        self._begin = process_time()

    def begin(self) -> None:
        self._begin = process_time()

    def end(self, location: pyemtr.Location) -> None:
        cpu = process_time() - self._begin
        self._times.setdefault(location.by, []).append((location.seconds, cpu))

    def __str__(self) -> str:
        lines = []
        for by, times in self._times.items():
            for what, seconds in zip(("wall", "CPU"), np.transpose(times)):
                median, most, longest = 1000 * np.percentile(seconds, [50, 90, 100])
                lines.append(
                    f"{len(times)} sweeps by {by}, {what}: median {median:.0f} ms,"
                    f" 90 % {most:.0f} ms, max {longest:.0f} ms"
                )
        return "\n".join(lines)


def made(laps: int) -> None:
    """Drives through a made street."""
    world = street(1)
    sweeps = [sweep(world, x, 0, 0, seed=100 + i) for i, x in enumerate(range(-90, 91, 10))]
    street_map = np.concatenate([scenes.moved(pose, points) for points, pose in sweeps])
    localizer = pyemtr.Localizer(street_map, axis=(0, 0, 1), axis_tilt=2, radius=5, degrees=20)
    print(f"map of {len(street_map)} points")
    latency, wrong = Latency(), 0
    for i in range(14 * laps):
        # 2.5 m a sweep; in the middle of a lap, and back to its begin, the car is carried
        x = -70 + 2.5 * (i % 14) if i % 14 < 7 else 20 + 2.5 * (i % 14 - 7)
        points, true = sweep(world, x, np.sin(i / 3), 6 * np.cos(i / 3), seed=i)
        latency.begin()
        location = localizer.localize(points)
        latency.end(location)
        wrong += location.registered and bool(np.abs(location.pose - true)[:3, 3].max() > 0.5)
        print(report(f"sweep {i}", location, true))
    elsewhere, _ = sweep(street(2), 0, 0, 0, seed=99)
    lost = localizer.localize(elsewhere)
    print(f"another street: {lost.result.reason_text}")
    print(f"{wrong + lost.registered} wrong poses were called registered")
    print(latency)


def real(folder: Path) -> None:
    """Finds each source in the map that its target is: without a guess, and with one."""
    latency = Latency()
    for pair in sorted(path for path in folder.iterdir() if (path / "T_gt.txt").is_file()):
        true = np.loadtxt(pair / "T_gt.txt")
        localizer = pyemtr.Localizer(pair / "target.ply")
        scan = pyemtr.Cloud(pair / "source.ply")
        for name, guess in (("no guess", None), ("guess", scenes.motion((1, 2, 5), (1, -1, 0)))):
            localizer.forget()
            latency.begin()
            location = localizer.localize(scan, None if guess is None else true @ guess)
            latency.end(location)
            print(report(f"{pair.name}, {name}", location, true))
    print(latency)


if __name__ == "__main__":
    data = os.environ.get("EMTR_DATA")
    lidar = Path(data) / "pairs" / "lidar" if data else None
    if lidar is not None and lidar.is_dir():
        real(lidar)
    made(int(sys.argv[1]) if sys.argv[1:] else 2)
