"""Two scans of one object from different sides, in poses that have nothing to do with each other.

The simplest case: two arrays, one call, and a look at the verdict.
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


directions = scenes.sphere(24_000)
body = relief(directions)
noise = np.random.default_rng(0).normal(scale=0.05, size=body.shape)
true = scenes.motion((140, -35, 80), (300, -20, 90))

source = (body + noise)[directions[:, 0] > -0.3]  # each scan sees two thirds of the body
target = scenes.moved(true, (body - noise)[directions[:, 0] < 0.3])

result = pyemtr.register(source, target, seed=1)
print(result)
print(f"rotation error {pyemtr.metrics.rotation_error(result.transformation, true):.3f} degrees")

aligned = result.apply(source)  # in the target's frame
distances = result.residuals(source, target)
print(f"{np.mean(distances < 1):.0%} of the source's points have the target within 1 mm")

deviation = np.sqrt(np.diag(result.covariance))
print(f"deviation {np.degrees(deviation[:3]).max():.4f} degrees, {deviation[3:].max():.4f} mm")
