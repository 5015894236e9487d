"""Another optimizer in place of the two swarms: SciPy's differential evolution over both tasks.

Task beta scores rotations on the feature matches, task alpha whole poses on the clouds. Lower is
better. Any optimizer that calls a function of a vector, or of many at once, will do: pymoo, CMA-ES.
"""

from __future__ import annotations

import numpy as np
import scenes
from scipy.optimize import differential_evolution

import pyemtr
import pyemtr.metrics


def evolve(
    task: pyemtr.TaskAlpha | pyemtr.TaskBeta, bounds: np.ndarray, popsize: int
) -> np.ndarray:
    """Returns the best particle that SciPy finds within bounds (genes, 2)."""
    found = differential_evolution(
        lambda x: task.evaluate(x.T),  # SciPy has one particle a column, a task one a row
        bounds,
        popsize=popsize,
        maxiter=60,
        seed=1,
        polish=False,
        vectorized=True,
        updating="deferred",
    )
    print(f"{type(task).__name__}: {found.fun:.1f} after {found.nit} generations")
    return np.asarray(found.x)


directions = scenes.sphere(12_000)
x, y, z = directions.T
height = 40 + 5 * np.sin(4 * x + 1) * np.sin(5 * y) + 4 * np.sin(6 * z + 2 * x) + 6 * x * y
body = directions * height[:, None] * [1.0, 0.8, 0.6]
true = scenes.motion((70, 20, -130), (400, -20, 10))
source, target = body[x > -0.3], scenes.moved(true, body[x < 0.3])

problem = pyemtr.Problem(source, target)  # normalized, downsampled and matched
beta, alpha = pyemtr.TaskBeta(problem), pyemtr.TaskAlpha(problem)

rotation = evolve(beta, beta.bounds, popsize=20)
start = np.concatenate([rotation, problem.complement(rotation)])  # Algorithm 2 of the paper
reach = np.array([0.1, 0.1, 0.1, 0.5, 0.5, 0.5])  # radians; radii of the normalized frame
best = evolve(alpha, np.column_stack([start - reach, start + reach]), popsize=12)

transformation = problem.to_transformation(best)
print(f"rotation error {pyemtr.metrics.rotation_error(transformation, true):.2f} degrees")

# The pose takes the place of the swarms in all that follows: ranking, refinement and the verdict.
(scored,) = problem.score(transformation)
result = problem.solve(poses=transformation)
print(f"score {scored.score:.2f} -> {result.score:.2f}, confidence {result.confidence:.1%}")
print(result.reason_text)
print(f"rotation error {pyemtr.metrics.rotation_error(result.transformation, true):.3f} degrees")
