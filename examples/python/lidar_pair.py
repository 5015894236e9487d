"""Two sweeps of a spinning LiDAR in a street, some meters apart; many sweeps against one map.

Each cloud is preprocessed once, and taken by worker threads.
"""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import scenes

import pyemtr
import pyemtr.metrics

rng = np.random.default_rng(4)
ground = [[[-80.0, -80, -1], [80, 80, 0]]]
houses = [
    [[x, side * 9.0 + min(0, side) * depth, 0], [x + wide, side * 9.0 + max(0, side) * depth, tall]]
    for side in (-1, 1)
    for x, wide, depth, tall in zip(
        np.arange(-70, 70, 17.0),
        rng.uniform(8, 15, 9),
        rng.uniform(5, 12, 9),
        rng.uniform(4, 12, 9),
    )
]
cars = [
    [[x, y, 0], [x + 4.2, y + 1.8, 1.5]]
    for x, y in zip(rng.uniform(-50, 50, 12), rng.choice([-6.5, 4.5], 12))
]
WORLD = np.array(ground + houses + cars)

elevation, azimuth = np.meshgrid(
    np.radians(np.linspace(-24, 8, 32)), np.arange(0, 2 * np.pi, 0.008)
)
SWEEP = np.column_stack(
    [
        (np.cos(elevation) * np.cos(azimuth)).ravel(),
        (np.cos(elevation) * np.sin(azimuth)).ravel(),
        np.sin(elevation).ravel(),
    ]
)


def sweep(x: float, y: float, heading: float, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Returns the points of a sweep in the car's frame, and the car's true pose (4, 4)."""
    place = np.array([x, y, 1.8])
    points = scenes.scan(WORLD, place, SWEEP, noise=0.02, seed=seed)
    points = points[np.linalg.norm(points, axis=1) < 60]
    pose = scenes.motion((0, 0, heading), (x, y, 1.8))
    return points @ pose[:3, :3], pose


target, target_pose = sweep(0, 0, 0, seed=0)
model = pyemtr.Cloud(target)  # read and measured once
starts = [(4.0, 0.5, 10), (8.0, -0.5, 170)]
sweeps = [sweep(*start, seed=i + 1) for i, start in enumerate(starts)]

with ThreadPoolExecutor(2) as workers:  # the library releases the GIL
    results = list(
        workers.map(lambda one: pyemtr.register(one[0], model, axis=(0, 0, 1), axis_tilt=3), sweeps)
    )

for (_, pose), result in zip(sweeps, results):
    true = np.linalg.inv(target_pose) @ pose
    degrees = pyemtr.metrics.rotation_error(result.transformation, true)
    meters = np.linalg.norm((result.transformation - true)[:3, 3])
    print(
        f"{result.reason}, confidence {result.confidence:.1%}:"
        f" rotation error {degrees:.3f} degrees, {meters:.3f} m"
    )
