"""Six scans of one object and one of something else, in no order: who belongs where?

Nothing is told of the poses. The result has a pose for each scan that is sure, and a reason for
each one that was left out. Needs ``pip install 'pyemtr[align]'``.
"""

import numpy as np
import scenes

import pyemtr
import pyemtr.metrics


def relief(at: np.ndarray) -> np.ndarray:
    """Returns points of a lumpy body, in millimeters, in unit directions (N, 3)."""
    x, y, z = at.T
    height = 40 + 5 * np.sin(4 * x + 1) * np.sin(5 * y) + 4 * np.sin(6 * z + 2 * x) + 6 * x * y
    return at * height[:, None] * [1.0, 0.8, 0.6]


rng = np.random.default_rng(2)
directions = scenes.sphere(12_000)
clouds, poses = [], []  # poses: body -> scan
for k in range(6):
    side = np.array([np.cos(k * np.pi / 3), np.sin(k * np.pi / 3), 0.4 * (-1) ** k])
    body = relief(directions[directions @ side > -0.05])  # what one scan sees
    pose = scenes.motion(tuple(rng.uniform(-180, 180, 3)), tuple(rng.uniform(-99, 99, 3)))
    clouds.append(scenes.moved(pose, body + rng.normal(scale=0.05, size=body.shape)))
    poses.append(pose)
stone = directions * (30 + 8 * np.sin(3 * directions[:, 1:2]) * np.cos(7 * directions[:, :1]))
clouds.insert(2, stone + rng.normal(scale=0.05, size=stone.shape))
poses.insert(2, np.eye(4))

result = pyemtr.align_all(clouds, names=["a", "b", "stone", "c", "d", "e", "f"])
print(result)

for scan in result.placed:
    true = poses[0] @ np.linalg.inv(poses[scan])  # scan -> first scan, which is the model's frame
    error = pyemtr.metrics.rotation_error(result.scans[scan].pose, true)
    print(f"{result.scans[scan].name}: rotation error {error:.3f} degrees")

fused = result.fuse(voxel=1.0)
print(f"registered {len(result.placed)} scans, {len(fused.points)} points in the fused cloud")
