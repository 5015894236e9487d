"""Fast Global Registration by Open3D, as its authors set it.

Open3D's defaults are not the method: they leave out the lowering of mu, which makes the estimate
robust, and its normals point to either side. Here mu falls, as in the authors' program, down to a
distance in the normalized frame, and normals are oriented to the centroid, as for PCL's methods.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import open3d

from .methods import Array, Task
from .open3d_methods import with_features

DISTANCE = 0.5  # the last scale of the robust estimate, in voxels
DIVISION, ITERATIONS = 1.4, 64  # of mu, every fourth iteration
TUPLE_SIMILARITY, TUPLES = 0.95, 1000

_registration = open3d.pipelines.registration


def fast_global_registration(source: Array, target: Array, task: Task) -> Array:
    open3d.utility.random.seed(task.seed)
    (a, a_features), (b, b_features) = (
        with_features(cloud, task, oriented=True) for cloud in (source, target)
    )
    option = _registration.FastGlobalRegistrationOption(
        division_factor=DIVISION,
        use_absolute_scale=False,
        decrease_mu=True,
        maximum_correspondence_distance=DISTANCE * task.voxel / max(_radius(a), _radius(b)),
        iteration_number=ITERATIONS,
        tuple_scale=TUPLE_SIMILARITY,
        maximum_tuple_count=TUPLES,
        tuple_test=True,
    )
    result = _registration.registration_fgr_based_on_feature_matching(
        a, b, a_features, b_features, option
    )
    return np.array(result.transformation)


def _radius(cloud: Any) -> float:
    """What Open3D divides the coordinates by."""
    return float(np.linalg.norm(np.asarray(cloud.points) - cloud.get_center(), axis=1).max())
