"""KISS-Matcher with its defaults, in the unit that they were made for."""

from __future__ import annotations

import kiss_matcher
import numpy as np

from .methods import Array, Task
from .units import Unit

VOXEL = 0.3  # its own default; its noise bounds are clamped to lengths that go with it


def kiss_matcher_search(source: Array, target: Array, task: Task) -> Array:
    unit = Unit.of(source, target, VOXEL / task.voxel)
    matcher = kiss_matcher.KISSMatcher(kiss_matcher.KISSMatcherConfig(VOXEL))
    found = matcher.estimate(
        unit.source(source).astype(np.float32), unit.target(target).astype(np.float32)
    )
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = found.rotation, np.ravel(found.translation)
    return unit.pose_from(T)
