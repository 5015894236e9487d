"""E57 files: all scans are one cloud, each moved by its pose."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pyemtr
from pyemtr.e57_files import read_e57
from pyemtr.points import as_points

pye57 = pytest.importorskip("pye57", reason="pip install 'pyemtr[e57]'")

POINTS = np.random.default_rng(3).normal(size=(120, 3)) + [500000.0, 5300000.0, 100.0]
QUARTER = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])  # about z
QUATERNION = np.array([np.sqrt(0.5), 0, 0, np.sqrt(0.5)])
ORIGIN = np.array([500000.0, 5300000.0, 0.0])


def write(path: Path, parts: list[dict[str, Any]]) -> str:
    """Writes scans that stand at ORIGIN, rotated by a quarter."""
    file = pye57.E57(str(path), mode="w")
    for part in parts:
        file.write_scan_raw(part, rotation=QUATERNION, translation=ORIGIN)
    file.close()
    return str(path)


def own(points: np.ndarray) -> dict[str, np.ndarray]:
    """Points in the frame of a scan."""
    rotated = (points - ORIGIN) @ QUARTER
    return {f"cartesian{axis}": rotated[:, i].copy() for i, axis in enumerate("XYZ")}


def test_scans_are_moved_by_their_poses(tmp_path: Path) -> None:
    path = write(tmp_path / "a.e57", [own(POINTS[:50]), own(POINTS[50:])])
    np.testing.assert_allclose(
        as_points(path, "source"), POINTS, rtol=0, atol=1e-5
    )  # single precision
    cloud = read_e57(path)
    assert cloud.colors is None and cloud.intensity is None


def test_colors_and_intensities_come_along_if_all_scans_have_them(tmp_path: Path) -> None:
    colors = {f"color{name}": np.arange(120, dtype=np.uint8) for name in ("Red", "Green", "Blue")}
    more = {"intensity": np.linspace(0, 1, 120)}
    whole = own(POINTS) | colors | more
    cloud = read_e57(write(tmp_path / "a.e57", [whole, whole]))
    assert cloud.colors.dtype == np.uint8 and cloud.colors.shape == (240, 3)
    assert np.array_equal(cloud.colors[120:, 2], np.arange(120))
    np.testing.assert_allclose(cloud.intensity[:120], np.linspace(0, 1, 120), atol=1e-6)
    cloud = read_e57(write(tmp_path / "b.e57", [whole, own(POINTS) | more]))
    assert cloud.colors is None and len(cloud.intensity) == 240


def test_invalid_points_are_dropped_and_counted(tmp_path: Path) -> None:
    invalid = np.zeros(120, np.int8)
    invalid[[3, 70, 71]] = 2
    path = write(tmp_path / "a.e57", [own(POINTS) | {"cartesianInvalidState": invalid}])
    cloud = pyemtr.Cloud(path)
    assert cloud.dropped == 3 and len(cloud) == 117


def test_spherical_coordinates_and_no_pose(tmp_path: Path) -> None:
    x, y, z = (POINTS - ORIGIN).T
    distance = np.sqrt(x * x + y * y + z * z)
    values = {
        "sphericalRange": distance,
        "sphericalAzimuth": np.arctan2(y, x),
        "sphericalElevation": np.arcsin(z / distance),
    }
    file = pye57.E57(str(tmp_path / "a.e57"), mode="w")
    image, e57 = file.image_file, pye57.libe57
    fields = e57.StructureNode(image)
    for name in values:
        fields.set(name, e57.FloatNode(image, 0.0, e57.E57_DOUBLE, -1e3, 1e3))
    points = e57.CompressedVectorNode(image, fields, e57.VectorNode(image, True))
    scan = e57.StructureNode(image)
    scan.set("points", points)
    file.data3d.append(scan)
    buffers = e57.VectorSourceDestBuffer()
    for name, numbers in values.items():
        buffers.append(e57.SourceDestBuffer(image, name, numbers, 120, True, True))
    writer = points.writer(buffers)
    writer.write(120)
    writer.close()
    file.close()
    found = as_points(tmp_path / "a.e57", "source")
    np.testing.assert_allclose(found, POINTS - ORIGIN, rtol=0, atol=1e-10)


@pytest.mark.parametrize("content", [b"ASTM-E57" + bytes(40), b"ASTM-E57" + bytes(4000), b"none"])
def test_bad_files_are_refused_in_one_line(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "a.e57").write_bytes(content)
    with pytest.raises(ValueError, match=r"^source: .*a\.e57: [^\n]+$"):
        as_points(tmp_path / "a.e57", "source")
    assert (tmp_path / "a.e57").read_bytes() == content


def test_a_file_without_scans(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="expected scans with points, got none"):
        read_e57(write(tmp_path / "a.e57", []))
