"""A room, scanned from two places by a scanner that is level: both clouds have the same vertical.

What is known of the pose goes in as a prior, and the sensors' places as viewpoints.
"""

import numpy as np
import scenes

import pyemtr
import pyemtr.metrics

BOXES = np.array(
    [
        [[0, 0, 0], [6.0, 4.5, 2.6]],  # the room itself
        [[0.0, 0.0, 0.0], [0.6, 2.2, 2.1]],  # a wardrobe
        [[2.4, 1.5, 0.65], [4.2, 2.4, 0.72]],  # a table
        [[2.5, 1.6, 0.0], [2.6, 1.7, 0.65]],
        [[4.0, 2.2, 0.0], [4.1, 2.3, 0.65]],
        [[4.6, 3.6, 0.0], [6.0, 4.5, 0.9]],  # a sideboard, with a lamp on it
        [[5.2, 3.9, 0.9], [5.4, 4.1, 1.4]],
        [[1.2, 4.1, 0.9], [2.7, 4.5, 2.2]],  # a window's frame
    ]
)

directions = scenes.sphere(40_000)
places = np.array([1.5, 3.2, 1.4]), np.array([4.9, 1.0, 1.5])
source, target = (
    scenes.scan(BOXES, place, directions, noise=0.004, seed=i) for i, place in enumerate(places)
)
# The first scanner faces another way. Both clouds begin at their own sensor.
facing = scenes.motion((0, 0, 115), (0, 0, 0))
source = scenes.moved(facing, source)
true = scenes.motion((0, 0, -115), tuple(places[0] - places[1]))

told: set[str] = set()


def tell(progress: pyemtr.Progress) -> None:
    """Prints each stage once; a progress bar would show the fraction."""
    if progress.stage not in told:
        told.add(progress.stage)
        print(f"{progress.fraction:4.0%} {progress.stage}")


result = pyemtr.register(
    source,
    target,
    axis=(0, 0, 1),  # up, in both
    axis_tilt=2.0,  # degrees that a level may be wrong
    source_viewpoint=(0, 0, 0),
    target_viewpoint=(0, 0, 0),
    callback=tell,
)
print(
    f"{result.reason_text}, confidence {result.confidence:.1%}, overlap {result.overlap_source:.0%}"
)
print(f"rotation error {pyemtr.metrics.rotation_error(result.transformation, true):.3f} degrees")
print(f"distance between the scanners {np.linalg.norm(result.transformation[:3, 3]):.3f} m")
