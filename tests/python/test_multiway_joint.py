"""The joint refinement brings poses that are a little wrong to where they belong."""

from __future__ import annotations

import numpy as np
from many_scans import scene
from shapes import directions

from pyemtr.multiway.joint import refine_jointly
from pyemtr.multiway.rigid import angle, exponential, inverse
from pyemtr.multiway.surface import make_surface


def test_all_scans_come_to_lie_on_each_other() -> None:
    made = scene({1: 4}, seed=4, count=4000, half_angle=85.0)
    surfaces = {i: make_surface(cloud, 1.0) for i, cloud in enumerate(made.clouds)}
    rng = np.random.default_rng(2)
    start = {}
    for i, pose in enumerate(made.truth):
        off = np.concatenate(
            [np.radians(1.0) * directions(rng, 1)[0], 0.01 * directions(rng, 1)[0]]
        )
        start[i] = inverse(made.truth[0]) @ exponential(off * (i > 0)) @ pose
    pairs = {(j, i): 1.0 for j in range(4) for i in range(j)}
    poses = refine_jointly(start, surfaces, 1.0, 0, 2, pairs)
    for i, pose in enumerate(made.truth):
        wanted = inverse(made.truth[0]) @ pose
        apart = inverse(wanted) @ poses[i]
        assert angle(apart[:3, :3]) < 0.1
        center = inverse(pose)[:3, 3]
        assert np.linalg.norm(apart[:3, :3] @ center + apart[:3, 3] - center) < 0.002
    again = refine_jointly(start, surfaces, 1.0, 0, 1, pairs)
    assert all(np.array_equal(again[i], poses[i]) for i in poses)
