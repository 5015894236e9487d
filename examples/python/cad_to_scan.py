"""A scan of a part against its CAD model, which is a mesh of a few large triangles.

A mesh of trimesh or Open3D, or the path of a PLY file, is given in the same way as the mesh here.
"""

from types import SimpleNamespace

import numpy as np
import scenes

import pyemtr
import pyemtr.metrics

# A milled block, in millimeters: columns of different heights over a grid.
CUTS_X, CUTS_Y = [0.0, 18, 30, 60, 80], [0.0, 14, 40, 50]
HEIGHTS = np.array([[10.0, 25, 10], [34, 25, 10], [16, 6, 6], [16, 40, 22]])


def columns() -> np.ndarray:
    """The block as boxes (B, 2, 3), for the scanner."""
    return np.array(
        [
            [[CUTS_X[i], CUTS_Y[j], 0], [CUTS_X[i + 1], CUTS_Y[j + 1], HEIGHTS[i, j]]]
            for i, j in np.ndindex(HEIGHTS.shape)
        ]
    )


def mesh() -> SimpleNamespace:
    """The block's surface as vertices and triangles."""
    rectangles = []
    tall = np.pad(HEIGHTS, 1)
    for i, j in np.ndindex(HEIGHTS.shape):
        (x0, x1), (y0, y1), top = CUTS_X[i : i + 2], CUTS_Y[j : j + 2], HEIGHTS[i, j]
        rectangles += [[(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)] for z in (0.0, top)]
    for i, j in np.ndindex(HEIGHTS.shape[0] + 1, HEIGHTS.shape[1]):  # walls across x
        low, high = sorted((tall[i, j + 1], tall[i + 1, j + 1]))
        x, (y0, y1) = CUTS_X[i], CUTS_Y[j : j + 2]
        rectangles.append([(x, y0, low), (x, y1, low), (x, y1, high), (x, y0, high)])
    for i, j in np.ndindex(HEIGHTS.shape[0], HEIGHTS.shape[1] + 1):  # walls across y
        low, high = sorted((tall[i + 1, j], tall[i + 1, j + 1]))
        (x0, x1), y = CUTS_X[i : i + 2], CUTS_Y[j]
        rectangles.append([(x0, y, low), (x1, y, low), (x1, y, high), (x0, y, high)])
    first = 4 * np.arange(len(rectangles))[:, None]
    faces = np.concatenate([first + [0, 1, 2], first + [0, 2, 3]])
    return SimpleNamespace(vertices=np.reshape(rectangles, (-1, 3)), faces=faces)


sensor = np.array([-60.0, -120, 150])
toward = np.array([40.0, 25, 10]) - sensor
rays = scenes.sphere(1_500_000)
rays = rays[rays @ toward / np.linalg.norm(toward) > 0.955]
seen = scenes.scan(columns(), sensor, rays, noise=0.05, seed=0) + sensor
true = scenes.motion((25, 130, -70), (500, 40, 12))  # of the scanner's frame to the model's
scan = scenes.moved(np.linalg.inv(true), seen)

part = pyemtr.Cloud(mesh(), mesh_points=40_000)  # points over the surface, as many for each area
result = pyemtr.register(scan, part)
print(f"{result.reason_text}, confidence {result.confidence:.1%}; {len(scan)} points of the scan")
print(f"rotation error {pyemtr.metrics.rotation_error(result.transformation, true):.3f} degrees")
print(f"the scan covers {result.overlap_target:.0%}; rmse {result.inlier_rmse_plane:.3f} mm")
