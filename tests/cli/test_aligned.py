"""The moved cloud keeps every field; directions rotate with it."""

from __future__ import annotations

import cloud_files
import numpy as np
import pytest
from cloud_files import read_pcd, read_ply, table, xyz
from conftest import QUICK, rotation, surface

COUNT = 240
POINTS = surface(COUNT, 3)
RNG = np.random.default_rng(8)
NORMALS = RNG.normal(size=(COUNT, 3))
NORMALS = (NORMALS / np.linalg.norm(NORMALS, axis=1)[:, None]).astype("f4")
CURVATURE = RNG.normal(size=(COUNT, 3)).astype("f4")


def fields(**others) -> dict[str, np.ndarray]:
    return {
        "normal_x": NORMALS[:, 0],
        "normal_y": NORMALS[:, 1],
        "normal_z": NORMALS[:, 2],
        "rgb": RNG.integers(0, 2**24, COUNT, dtype="u4"),
        "intensity": RNG.uniform(size=COUNT).astype("f4"),
        "ring": RNG.integers(0, 64, COUNT, dtype="u2"),
        "label": RNG.integers(-9, 9, COUNT, dtype="i4"),
        "time": 1.6e9 + RNG.uniform(size=COUNT),
    } | others


@pytest.fixture
def aligned(run, tmp_path):
    """Registers a cloud to a fixed target; the moved cloud's path and T."""
    rotated = surface(COUNT, 4) @ rotation([1, 2, -1], 2.0).T
    cloud_files.write_pcd(tmp_path / "b.pcd", rotated + [1, 2, 3])

    def call(source, extension: str):
        done = run(source, "b.pcd", *QUICK, "-o", "T.txt", "--aligned", f"moved{extension}")
        assert done.returncode in (0, 3), done.stderr
        assert f"Saving moved{extension} [done : {COUNT} points]" in done.stderr
        return tmp_path / f"moved{extension}", np.loadtxt(tmp_path / "T.txt")

    return call


def moved(T: np.ndarray, points: np.ndarray) -> np.ndarray:
    return points @ T[:3, :3].T + T[:3, 3]


BYTE = RNG.integers(0, 255, COUNT, dtype="u1")
COLOR = {"red": BYTE, "green": BYTE[::-1], "blue": BYTE // 2}


@pytest.mark.parametrize(
    "others",
    [
        {},
        {"nx": NORMALS[:, 0], "ny": NORMALS[:, 1], "nz": NORMALS[:, 2].astype("f8")},
        COLOR | {"label": RNG.integers(-9, 9, COUNT, dtype="i4")},
        {"quality": BYTE} | COLOR | {"alpha": BYTE[::-1]},
        {"red": CURVATURE[:, 0], "green": CURVATURE[:, 1], "blue": CURVATURE[:, 2]},
        {f"diffuse_{name}": values for name, values in COLOR.items()},
        {"intensity": BYTE},
        {f"of_{kind}": BYTE.astype(kind) for kind in ("i1", "u1", "i2", "u2", "i4", "u4", "f8")},
    ],
    ids=lambda others: " ".join(others) or "coordinates",
)
@pytest.mark.parametrize("dtype", ["f4", "f8"])
def test_binary_ply_of_either_byte_order(aligned, tmp_path, others, dtype):
    """PCL reads the one of big-endian numbers, the other is copied: same fields, same bytes."""
    rows = table(POINTS, dtype, **others)
    moved_clouds = []
    for data in ("binary", "big"):
        cloud_files.write_ply(tmp_path / "a.ply", rows, data=data)
        path, _ = aligned("a.ply", ".pcd")
        moved_clouds.append(path.read_bytes())
    assert moved_clouds[0] == moved_clouds[1]


@pytest.mark.parametrize("data", ["ascii", "binary", "binary_compressed"])
@pytest.mark.parametrize("dtype", ["f4", "f8"])
def test_pcd_to_pcd(aligned, tmp_path, data, dtype):
    rows = table(
        POINTS,
        dtype,
        **fields(
            principal_curvature_x=CURVATURE[:, 0],
            principal_curvature_y=CURVATURE[:, 1],
            principal_curvature_z=CURVATURE[:, 2],
            vp_x=CURVATURE[:, 0],
            vp_y=CURVATURE[:, 1],
            vp_z=CURVATURE[:, 2],
            fpfh=RNG.uniform(size=(COUNT, 33)).astype("f4"),
        ),
    )
    cloud_files.write_pcd(tmp_path / "a.pcd", rows, data=data)
    path, T = aligned("a.pcd", ".pcd")
    found, _ = read_pcd(path)
    assert found.dtype == rows.dtype
    tolerance = 2e-6 if dtype == "f4" else 1e-14
    assert np.allclose(xyz(found), moved(T, xyz(rows)), rtol=0, atol=tolerance * 10)
    for names, expected in [
        ("normal_x normal_y normal_z", NORMALS @ T[:3, :3].T),
        (
            "principal_curvature_x principal_curvature_y principal_curvature_z",
            CURVATURE @ T[:3, :3].T,
        ),
        ("vp_x vp_y vp_z", moved(T, CURVATURE)),
    ]:
        assert np.allclose(xyz(found, names), expected, atol=1e-5)
        assert not np.allclose(xyz(found, names), xyz(rows, names), atol=1e-2)
    for name in ("rgb", "intensity", "ring", "label", "time", "fpfh"):
        assert np.array_equal(found[name], rows[name]), name


def test_pcd_to_ply(aligned, tmp_path):
    rows = table(POINTS, **fields())
    cloud_files.write_pcd(tmp_path / "a.pcd", rows)
    path, T = aligned("a.pcd", ".ply")
    found, _ = read_ply(path)
    assert np.allclose(xyz(found), moved(T, xyz(rows)), atol=1e-5)
    assert np.allclose(xyz(found, "nx ny nz"), NORMALS @ T[:3, :3].T, atol=1e-5)
    for bit, name in ((16, "red"), (8, "green"), (0, "blue")):
        assert np.array_equal(found[name], rows["rgb"] >> bit & 255)
    for name in ("intensity", "ring", "label", "time"):
        assert found[name].dtype == rows[name].dtype
        assert np.array_equal(found[name], rows[name]), name


@pytest.mark.parametrize("extension", [".ply", ".pcd"])
@pytest.mark.parametrize("alpha", [False, True])
@pytest.mark.parametrize("data", ["ascii", "binary", "big"])
def test_ply_source(aligned, tmp_path, extension, alpha, data):
    color = {
        name: RNG.integers(0, 256, COUNT, dtype="u1")
        for name in ("red", "green", "blue", "alpha")[: 4 if alpha else 3]
    }
    rows = table(
        POINTS,
        "f8",
        nx=NORMALS[:, 0],
        ny=NORMALS[:, 1],
        nz=NORMALS[:, 2],
        **color,
        quality=CURVATURE[:, 0],
        ring=RNG.integers(0, 64, COUNT, dtype="u2"),
    )
    cloud_files.write_ply(tmp_path / "a.ply", rows, data=data, faces=True)
    path, T = aligned("a.ply", extension)
    if extension == ".ply":
        found, _ = read_ply(path)
        normals = "nx ny nz"
        for name in color:
            assert np.array_equal(found[name], rows[name]), name
    else:
        found, _ = read_pcd(path)
        normals = "normal_x normal_y normal_z"
        packed = found["rgba" if alpha else "rgb"].copy().view("u4")
        for bit, name in zip((16, 8, 0, 24), color, strict=False):
            assert np.array_equal(packed >> bit & 255, rows[name]), name
    assert found["x"].dtype == np.float64
    assert np.allclose(xyz(found), moved(T, xyz(rows)), rtol=0, atol=1e-13)
    assert np.allclose(xyz(found, normals), NORMALS @ T[:3, :3].T, atol=1e-5)
    assert np.array_equal(found["quality"], rows["quality"])
    assert np.array_equal(found["ring"], rows["ring"])


def test_obj_source(aligned, tmp_path):
    cloud_files.write_obj(tmp_path / "a.obj", POINTS, NORMALS)
    found, T = aligned("a.obj", ".pcd")
    rows, _ = read_pcd(found)
    assert np.allclose(xyz(rows), moved(T, POINTS), atol=1e-5)
    assert np.allclose(xyz(rows, "normal_x normal_y normal_z"), NORMALS @ T[:3, :3].T, atol=1e-5)


def test_obj_normals_that_are_not_one_for_each_vertex(run, tmp_path):
    cloud_files.write_obj(tmp_path / "a.obj", POINTS, NORMALS[:5])
    done = run("a.obj", "a.obj", *QUICK, "--aligned", "m.pcd")
    assert "warning: 'a.obj': its 5 normals are left out" in done.stderr
    rows, _ = read_pcd(tmp_path / "m.pcd")
    assert rows.dtype.names[:3] == ("x", "y", "z") and "normal_x" not in rows.dtype.names


def test_normals_by_their_short_name_in_pcd(aligned, tmp_path):
    cloud_files.write_pcd(
        tmp_path / "a.pcd", table(POINTS, nx=NORMALS[:, 0], ny=NORMALS[:, 1], nz=NORMALS[:, 2])
    )
    path, T = aligned("a.pcd", ".pcd")
    rows, _ = read_pcd(path)
    assert np.allclose(xyz(rows, "nx ny nz"), NORMALS @ T[:3, :3].T, atol=1e-5)


def test_points_without_a_place_stay_where_they_are_in_the_list(aligned, tmp_path):
    holes = POINTS.copy()
    holes[[0, 30]] = np.nan
    cloud_files.write_pcd(
        tmp_path / "a.pcd", table(holes, tag=np.arange(COUNT, dtype="u4")), width=20, height=12
    )
    path, T = aligned("a.pcd", ".pcd")
    rows, header = read_pcd(path)
    assert np.isnan(xyz(rows)[[0, 30]]).all()
    assert np.allclose(xyz(rows), moved(T, holes), atol=1e-5, equal_nan=True)
    assert np.array_equal(rows["tag"], np.arange(COUNT))
    assert (header["WIDTH"], header["HEIGHT"]) == (["20"], ["12"])
    path, _ = aligned("a.pcd", ".ply")
    vertices, _ = read_ply(path)
    assert np.array_equal(vertices["tag"], np.arange(COUNT))


def quaternion(R: np.ndarray) -> np.ndarray:
    w = np.sqrt(1 + np.trace(R)) / 2
    return np.array(
        [w, (R[2, 1] - R[1, 2]) / 4 / w, (R[0, 2] - R[2, 0]) / 4 / w, (R[1, 0] - R[0, 1]) / 4 / w]
    )


def test_sensor_pose_moves_along(aligned, tmp_path):
    """From PCD to PLY and from there to PCD; in map coordinates, where six digits are too few."""
    R = rotation([1, -1, 2], 0.7)
    origin = np.array([500123.25, 2.5, -3.0])
    words = " ".join(f"{value:.9g}" for value in [*origin, *quaternion(R)])
    cloud_files.write_pcd(tmp_path / "a.pcd", table(POINTS + origin, "f8"), viewpoint=words)
    path, T = aligned("a.pcd", ".pcd")
    _, header = read_pcd(path)
    found = np.array(header["VIEWPOINT"], float)
    expected = moved(T, origin)
    assert np.allclose(found[:3], expected, rtol=2e-7, atol=0.05)
    q = quaternion(T[:3, :3] @ R)
    assert np.allclose(found[3:] * np.sign(found[3:] @ q), q, atol=1e-5)

    path, T = aligned("a.pcd", ".ply")
    _, camera = read_ply(path)
    assert np.allclose(xyz(camera, "view_px view_py view_pz")[0], expected, rtol=2e-7, atol=0.05)
    rotated = np.array([[camera[f"{i}_axis{j}"][0] for j in "xyz"] for i in "xyz"])
    assert np.allclose(rotated, T[:3, :3] @ R, atol=1e-5)

    path.rename(tmp_path / "again.ply")
    path, second = aligned("again.ply", ".pcd")
    _, header = read_pcd(path)
    assert np.allclose(
        np.array(header["VIEWPOINT"][:3], float), moved(second, expected), rtol=4e-7, atol=0.1
    )


@pytest.mark.parametrize("viewpoint", [None, "0 0 0"])
def test_sensor_whose_pose_is_unknown(run, tmp_path, viewpoint):
    """Moved, PCL's default would look like a pose; at the origin it is one only when given."""
    cloud_files.write_pcd(tmp_path / "a.pcd", POINTS)
    cloud_files.write_pcd(tmp_path / "b.pcd", surface(COUNT, 4) + [1, 2, 3])
    given = ["--viewpoint-source", *viewpoint.split()] if viewpoint else []
    done = run("a.pcd", "b.pcd", *QUICK, "-o", "T.txt", "--aligned", "m.pcd", *given)
    assert done.returncode in (0, 3), done.stderr
    found = np.array(read_pcd(tmp_path / "m.pcd")[1]["VIEWPOINT"], float)
    if viewpoint:
        assert np.allclose(found[:3], np.loadtxt(tmp_path / "T.txt")[:3, 3], rtol=1e-6)
    else:
        assert found.tolist() == [0, 0, 0, 1, 0, 0, 0]


def test_padding_of_pcd(aligned, tmp_path):
    """PCL's own files have fields "_", which PLY cannot tell from data."""
    rows = table(POINTS, pad=np.zeros((COUNT, 4), "u1"), intensity=CURVATURE[:, 0])
    path = cloud_files.write_pcd(tmp_path / "a.pcd", rows)
    path.write_bytes(path.read_bytes().replace(b"z pad", b"z _"))
    for extension, read in ((".pcd", read_pcd), (".ply", read_ply)):
        moved_path, T = aligned("a.pcd", extension)
        found, _ = read(moved_path)
        assert np.allclose(xyz(found), moved(T, POINTS), atol=1e-5)
        assert np.array_equal(found["intensity"], CURVATURE[:, 0])


def test_ply_has_no_room_for_some_fields(refused, tmp_path):
    cloud_files.write_pcd(tmp_path / "b.pcd", POINTS)
    for name, values in (
        ("stamp", np.arange(COUNT, dtype="u8")),
        ("fpfh", np.zeros((COUNT, 33), "f4")),
    ):
        cloud_files.write_pcd(tmp_path / "a.pcd", table(POINTS, **{name: values}))
        message = refused(2, "a.pcd", "b.pcd", "--aligned", "m.ply")
        assert f"field '{name}'" in message and "write a .pcd" in message


@pytest.mark.parametrize("names", ["normal_x normal_y normal_z", "nx ny nz"])
def test_ply_normals_of_doubles(aligned, tmp_path, names):
    normals = dict(zip(names.split(), NORMALS.T.astype("f8")))
    cloud_files.write_pcd(tmp_path / "a.pcd", table(POINTS, **normals))
    path, T = aligned("a.pcd", ".ply")
    found, _ = read_ply(path)
    assert found["nx"].dtype == np.float64
    assert np.allclose(xyz(found), moved(T, POINTS), atol=1e-5)
    assert np.allclose(xyz(found, "nx ny nz"), NORMALS @ T[:3, :3].T, atol=1e-6)


def test_ply_curvature_of_doubles(refused, tmp_path):
    rows = table(POINTS, curvature=np.zeros(COUNT))
    cloud_files.write_pcd(tmp_path / "a.pcd", rows)
    message = refused(2, "a.pcd", "a.pcd", "--aligned", "m.ply")
    assert "field 'curvature' of 'a.pcd', which PCL takes for a float, write a .pcd" in message


def test_ply_holds_no_normal_by_both_its_names(refused, tmp_path):
    normals = {name: NORMALS[:, 0].astype("f4") for name in ("normal_x", "nx")}
    cloud_files.write_pcd(tmp_path / "a.pcd", table(POINTS, **normals))
    message = refused(2, "a.pcd", "a.pcd", "--aligned", "m.ply")
    assert "'m.ply': PLY cannot hold field 'nx' of 'a.pcd', which it has twice" in message


def test_ply_holds_no_field_twice(refused, tmp_path):
    path = cloud_files.write_pcd(tmp_path / "a.pcd", table(POINTS, w=np.zeros(COUNT, "f4")))
    path.write_bytes(path.read_bytes().replace(b"x y z w", b"x y z x"))
    message = refused(2, "a.pcd", "a.pcd", "--aligned", "m.ply")
    assert "'m.ply': PLY cannot hold field 'x' of 'a.pcd', which it has twice" in message


@pytest.mark.parametrize(
    ("name", "kind"), [("rgb_weight", "f4"), ("my_rgba", "f4"), ("rgba2", "u4")]
)
def test_ply_field_that_pcl_would_write_as_a_color(refused, tmp_path, name, kind):
    cloud_files.write_ply(tmp_path / "a.ply", table(POINTS, **{name: np.arange(COUNT, dtype=kind)}))
    message = refused(2, "a.ply", "a.ply", "--aligned", "m.ply")
    assert f"'m.ply': PLY cannot hold field '{name}' of 'a.ply'" in message
    assert "a color by its name, write a .pcd" in message


def test_ply_field_that_pcl_would_write_as_a_color_and_whose_name_is_no_text(refused, tmp_path):
    path = cloud_files.write_ply(tmp_path / "a.ply", table(POINTS, Xrgba=CURVATURE[:, 0]))
    path.write_bytes(path.read_bytes().replace(b"Xrgba", b"\xffrgba"))
    message = refused(2, "a.ply", "a.ply", "--aligned", "m.ply")
    assert "field '?rgba' of 'a.ply'" in message and "a color by its name" in message


@pytest.mark.parametrize("kind", ["f8", "i4", "u2", "i1"])
def test_ply_field_of_another_type_with_the_letters_of_a_color(aligned, tmp_path, kind):
    rows = table(POINTS, my_rgba=np.arange(-100, COUNT - 100).astype(kind))
    cloud_files.write_ply(tmp_path / "a.ply", rows)
    found, _ = read_ply(aligned("a.ply", ".ply")[0])
    assert np.array_equal(found["my_rgba"], rows["my_rgba"])


def test_ply_whole_numbers_called_rgb_keep_their_bytes(aligned, tmp_path):
    rows = table(POINTS, rgb_count=np.arange(COUNT, dtype="u4") * 99991)
    cloud_files.write_ply(tmp_path / "a.ply", rows)
    found, _ = read_ply(aligned("a.ply", ".ply")[0])
    assert np.array_equal(found["rgb_count"], rows["rgb_count"])
