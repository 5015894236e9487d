"""Where the sensors stood: given in each cloud's own frame and unit, kept, and made use of."""

import numpy as np
import pytest
import shapes
from shapes import bits

import pyemtr

ALWAYS = {"threads": 2, "fallback_search": "always", "fallback_points": 8000}


@pytest.fixture(scope="module")
def scans():
    """Each sees the side of the egg that faces it; the sensors, in each scan's own frame."""
    rng = np.random.default_rng(5)
    at = [np.array([4.0, 3.0, 2.0]), np.array([4.5, -1.0, 2.5])]
    clouds = []
    for sensor in at:
        points = shapes.lump(rng, 16000)
        clouds.append(points[points @ sensor > 0.35 * np.linalg.norm(sensor)])
    truth = shapes.random_transformation(rng)
    return (clouds[0], shapes.apply(truth, clouds[1])), (at[0], shapes.apply(truth, at[1])), truth


def run(clouds, sensors, **settings):
    return pyemtr.register(
        *clouds, source_viewpoint=sensors[0], target_viewpoint=sensors[1], **{**ALWAYS, **settings}
    )


def test_they_are_kept_among_the_settings(scans):
    clouds, sensors, _ = scans
    found = run(clouds, sensors)
    assert found.settings["source_viewpoint"] == sensors[0].tolist()
    assert found.settings["target_viewpoint"] == sensors[1].tolist()
    assert bits(pyemtr.register(*clouds, **found.settings)) == bits(found)
    problem = pyemtr.Problem(
        *clouds, source_viewpoint=sensors[0], target_viewpoint=sensors[1], **ALWAYS
    )
    assert bits(problem.solve()) == bits(found)
    assert problem.settings == found.settings
    one = pyemtr.register(*clouds, target_viewpoint=sensors[1], **ALWAYS).settings
    assert one["source_viewpoint"] is None and one["target_viewpoint"] == sensors[1].tolist()


def test_the_form_they_come_in_changes_no_bit(scans):
    clouds, _, _ = scans
    wanted = bits(run(clouds, ([4, 3, 2], [1, 2, 3])))
    for form in (tuple, np.array, np.float32, lambda v: np.array(v, ">i2")[::-1].copy()[::-1]):
        assert bits(run(clouds, (form([4, 3, 2]), form([1, 2, 3])))) == wanted


def test_they_are_in_each_cloud_s_own_frame_and_unit(scans):
    clouds, sensors, truth = scans
    found = run(clouds, sensors)
    assert found.confidence > 0.5 and shapes.rotation_error(found.transformation, truth) < 0.5
    other = run([cloud * 1024 for cloud in clouds], [sensor * 1024 for sensor in sensors])
    assert (other.violation, other.score) == (found.violation, found.score)
    moved = run((clouds[0] + 512, clouds[1]), (sensors[0] + 512, sensors[1]))
    assert moved.violation == pytest.approx(found.violation, abs=0.01)


def test_no_surface_is_in_front_of_what_a_sensor_saw(scans):
    """The right places find nothing amiss; from behind, the scans are in each other's way."""
    clouds, sensors, truth = scans
    right = run(clouds, sensors)
    behind = [2 * cloud.mean(axis=0) - sensor for cloud, sensor in zip(clouds, sensors)]
    wrong = run(clouds, behind, guess=truth)
    assert right.violation < 0.005 and wrong.violation > 0.03
