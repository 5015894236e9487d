"""LAS, LAZ and E57: read where their modules were built, else refused with what is missing."""

from __future__ import annotations

import json
import os
import shutil
import struct
from pathlib import Path

import cloud_files
import numpy as np
import pytest
from conftest import QUICK, ROOT, surface

POINTS = np.round(surface(240, 3), 3) + [500000.0, 5300000.0, 100.0]  # as LAS scales them


def has_module(name: str) -> bool:
    build = Path(os.environ.get("EMTR_BUILD_DIR", ROOT / "build"))
    return (build / "tools" / "pcl_emtr_modules" / f"pcl_emtr_{name}.so").is_file()


needs_las = pytest.mark.skipif(not has_module("las"), reason="built without EMTR_WITH_LASZIP")
needs_e57 = pytest.mark.skipif(not has_module("e57"), reason="built without EMTR_WITH_E57")


def write_las(path: Path, count: int | None = None, color: bool = False) -> Path:
    """LAS 1.2 in point format 1 or 3, coordinates in millimeters from an offset."""
    offset = np.floor(POINTS.min(axis=0))
    layout = [("xyz", "<i4", 3), ("intensity", "<u2"), ("returns", "u1"), ("kind", "u1"),
              ("angle", "i1"), ("user", "u1"), ("source", "<u2"), ("time", "<f8")]  # fmt: skip
    rows = np.zeros(len(POINTS), layout + ([("color", "<u2", 3)] if color else []))
    rows["xyz"] = np.round((POINTS - offset) / 0.001)
    rows["intensity"] = np.arange(len(POINTS))
    rows["kind"] = 2
    rows["time"] = np.arange(len(POINTS)) + 0.5
    head = struct.pack("<4sHHIHH8sBB32s32sHH", b"LASF", 0, 0, 0, 0, 0, b"", 1, 2, b"", b"", 1, 2026)
    declared = len(POINTS) if count is None else count
    point_format = 3 if color else 1
    head += struct.pack("<HIIBHI", 227, 227, 0, point_format, rows.itemsize, declared)
    head += struct.pack("<5I", len(POINTS), 0, 0, 0, 0)
    box = [v for axis in POINTS.T for v in (axis.max(), axis.min())]
    head += struct.pack("<12d", 0.001, 0.001, 0.001, *offset, *box)
    assert len(head) == 227
    path.write_bytes(head + rows.tobytes())
    return path


@pytest.fixture
def reference(run, tmp_path) -> str:
    cloud_files.write_pcd(tmp_path / "reference.pcd", cloud_files.table(POINTS, "f8"))
    return run("reference.pcd", "reference.pcd", *QUICK).stdout


def matrix(text: str) -> np.ndarray:
    return np.array(text.split(), float).reshape(4, 4)


def same_pose(found: str, expected: str) -> bool:
    """The center of the cloud ends in the same place, to a tenth of a millimeter."""
    center = np.append(POINTS.mean(axis=0), 1)
    return np.allclose(matrix(found) @ center, matrix(expected) @ center, rtol=0, atol=1e-4)


@needs_las
@pytest.mark.parametrize("color", [False, True])
def test_las(run, tmp_path, reference, color):
    write_las(tmp_path / "a.las", color=color)
    done = run("a.las", "a.las", *QUICK, "-o", "T.txt", "--aligned", "m.pcd")
    assert done.returncode in (0, 3), done.stderr
    assert " : 240 points]" in done.stderr
    assert same_pose((tmp_path / "T.txt").read_text(), reference)
    rows, _ = cloud_files.read_pcd(tmp_path / "m.pcd")
    colors = ("red", "green", "blue") if color else ()
    fields = ("intensity", "classification", "gps_time", *colors)
    assert rows.dtype.names == ("x", "y", "z", *fields)
    T = np.loadtxt(tmp_path / "T.txt")
    assert np.allclose(cloud_files.xyz(rows), POINTS @ T[:3, :3].T + T[:3, 3], rtol=0, atol=1e-6)
    assert np.array_equal(rows["intensity"], np.arange(240))
    assert (rows["classification"] == 2).all()
    assert np.array_equal(rows["gps_time"], np.arange(240) + 0.5)


@needs_las
def test_las_from_a_stream_and_compressed_by_gzip(run, tmp_path):
    import gzip

    path = write_las(tmp_path / "a.las")
    (tmp_path / "b.las.gz").write_bytes(gzip.compress(path.read_bytes()))
    expected = run("a.las", "a.las", *QUICK).stdout
    with path.open("rb") as file:
        assert run("-", "b.las.gz", *QUICK, stdin=file).stdout == expected
    assert len(expected.splitlines()) == 4


@needs_las
def test_laz(run, tmp_path, reference):
    laspy = pytest.importorskip("laspy")
    pytest.importorskip("lazrs")
    laspy.read(write_las(tmp_path / "a.las")).write(tmp_path / "a.laz")
    plain, packed = (run(f"a.{kind}", f"a.{kind}", *QUICK) for kind in ("las", "laz"))
    assert packed.stdout == plain.stdout and len(packed.stdout.splitlines()) == 4, packed.stderr
    whole = (tmp_path / "a.laz").read_bytes()
    (tmp_path / "cut.laz").write_bytes(whole[: len(whole) // 2])
    done = run("cut.laz", "a.laz", *QUICK)
    assert done.returncode == 2 and "'cut.laz': " in done.stderr


@needs_las
@pytest.mark.parametrize(
    ("make", "pattern"),
    [
        (lambda path: write_las(path, count=10**9), "truncated: its header declares 1000000000"),
        (lambda path: write_las(path, count=0), "holds no points"),
        (lambda path: path.write_bytes(write_las(path).read_bytes()[:150]), "cannot be read"),
        (lambda path: path.write_bytes(b"PDSF" + bytes(500)), "cannot be read"),
    ],
)
def test_bad_las(refused, small, tmp_path, make, pattern):
    make(tmp_path / "a.las")
    message = refused(2, "a.las", "b.pcd", "-o", "T.txt")
    assert "'a.las': " in message and pattern in message


@pytest.mark.parametrize(
    ("name", "kind", "option", "package"),
    [
        ("a.las", "las", "EMTR_WITH_LASZIP", "liblaszip-dev"),
        ("a.laz", "las", "EMTR_WITH_LASZIP", "liblaszip-dev"),
        ("a.e57", "e57", "EMTR_WITH_E57", "libE57Format"),
    ],
)
def test_without_its_module(refused, small, tmp_path, name, kind, option, package):
    if has_module(kind):
        pytest.skip(f"built with {option}")
    (tmp_path / name).write_bytes(b"anything")
    message = refused(2, name, "b.pcd", "-o", "T.txt")
    assert f"'{name}': this pcl_emtr was built without a reader for {name[1:]} files" in message
    assert f"-D{option}=ON" in message and package in message


def test_of_all_modules_a_plain_ply_needs_none(run, command, tmp_path):
    """A copy of the command finds libemtr, but not the modules beside the original."""
    alone = tmp_path / "pcl_emtr"
    shutil.copy(command, alone)
    cloud_files.write_ply(tmp_path / "a.ply", POINTS)
    cloud_files.write_pcd(tmp_path / "a.pcd", POINTS)
    expected = run("a.ply", "a.ply", *QUICK).stdout
    assert run("a.ply", "a.ply", *QUICK, executable=alone).stdout == expected != ""
    done = run("a.pcd", "a.ply", *QUICK, executable=alone)
    assert done.returncode == 2 and done.stdout == ""
    assert "the reader and writer of PCD and PLY files" in done.stderr
    assert "pcl_emtr_pcl.so" in done.stderr and done.stderr.count("\n") == 1


@needs_e57
def test_e57_scans_are_moved_by_their_poses(run, tmp_path, reference):
    pye57 = pytest.importorskip("pye57")
    rotated = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])  # a quarter about z
    quaternion = np.array([np.sqrt(0.5), 0, 0, np.sqrt(0.5)])
    file = pye57.E57(str(tmp_path / "a.e57"), mode="w")
    for part in (POINTS[:100], POINTS[100:]):
        own = (part - [500000, 5300000, 0]) @ rotated  # the inverse, of rows
        data = {f"cartesian{axis}": own[:, i] for i, axis in enumerate("XYZ")}
        data["intensity"] = np.linspace(0, 1, len(part))
        file.write_scan_raw(data, rotation=quaternion, translation=np.array([500000.0, 5300000, 0]))
    file.close()
    done = run("a.e57", "a.e57", *QUICK, "-o", "T.txt", "--aligned", "m.pcd")
    assert done.returncode in (0, 3), done.stderr
    assert "its 2 scans are one cloud" in done.stderr
    T = np.loadtxt(tmp_path / "T.txt")
    rows, _ = cloud_files.read_pcd(tmp_path / "m.pcd")
    assert np.allclose(cloud_files.xyz(rows), POINTS @ T[:3, :3].T + T[:3, 3], rtol=0, atol=1e-5)
    assert np.allclose(rows["intensity"][:100], np.linspace(0, 1, 100))


@needs_e57
@pytest.mark.parametrize("content", [b"ASTM-E57" + bytes(40), b"ASTM-E57" + bytes(4000), b"none"])
def test_bad_e57(refused, small, tmp_path, content):
    (tmp_path / "a.e57").write_bytes(content)
    message = refused(2, "a.e57", "b.pcd", "-o", "T.txt")
    assert "'a.e57': cannot be read: " in message


@needs_las
def test_workers_read_files_at_a_time(run, tmp_path):
    """Each of several threads gets its own file whole."""
    for i in range(8):
        write_las(tmp_path / f"s{i}.las")
    cloud_files.write_pcd(tmp_path / "t.pcd", surface(240, 3))
    rows = "".join(f"s{i}.las,t.pcd\n" for i in range(8))
    (tmp_path / "pairs.csv").write_text("source,target\n" + rows)
    done = run("--batch", "pairs.csv", "--out", "out", "--workers", 8, *QUICK)
    assert done.returncode in (0, 3), done.stderr
    records = [json.loads(line) for line in (tmp_path / "out" / "results.jsonl").open()]
    assert len({str(record["transformation"]) for record in records}) == 1
    assert len(records) == 8 and not any(record["error"] for record in records)
