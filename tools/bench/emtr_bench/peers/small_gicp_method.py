"""small_gicp's GICP with its defaults, in the unit that they were made for."""

from __future__ import annotations

import numpy as np
import small_gicp

from .methods import Array, Task
from .units import Unit

# Its defaults take correspondences up to a length of 1 and downsample the clouds to 0.25: the voxel
# becomes that 1, as for the other refinement.
VOXEL, RESOLUTION = 1.0, 0.25


def gicp(source: Array, target: Array, start: Array, task: Task) -> Array:
    """Downsampling (by its own default, or by task.refine_voxel), kd-trees and covariances are made
    here and count."""
    resolution = RESOLUTION if task.refine_voxel is None else VOXEL * task.refine_voxel / task.voxel
    unit = Unit.of(source, target, VOXEL / task.voxel)
    result = small_gicp.align(
        unit.target(target), unit.source(source), unit.pose_to(start),
        registration_type="GICP", downsampling_resolution=resolution, num_threads=task.threads,
    )  # fmt: skip
    return unit.pose_from(np.array(result.T_target_source))
