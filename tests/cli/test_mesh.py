"""A mesh is a surface: points sample it evenly, and --aligned writes its own vertices and faces."""

from __future__ import annotations

import json

import cloud_files
import mesh_files
import numpy as np
import pytest
from conftest import QUICK, rotation

RELIEF = mesh_files.relief()


def moved(T: np.ndarray, points: np.ndarray) -> np.ndarray:
    return points @ T[:3, :3].T + T[:3, 3]


@pytest.fixture
def samples(run, tmp_path):
    """The points that sample a mesh, as a PCD file gets them when the mesh is moved nowhere."""

    def call(name: str, *options) -> np.ndarray:
        done = run(name, name, *QUICK, *options, "-o", "T.txt", "--aligned", "samples.pcd")
        assert done.returncode in (0, 3), done.stderr
        T = np.loadtxt(tmp_path / "T.txt")
        found = cloud_files.xyz(cloud_files.read_pcd(tmp_path / "samples.pcd")[0])
        return moved(np.linalg.inv(T), found)

    return call


def test_samples_are_even_and_lie_on_the_faces(samples, tmp_path):
    mesh_files.write_off(tmp_path / "square.off", mesh_files.square())
    points = samples("square.off", "--mesh-points", "5000")
    assert points.shape == (5000, 3)
    assert np.abs(points[:, 2]).max() < 1e-9
    assert points.min() > -1e-9 and points[:, :2].max() < 1 + 1e-9
    counts = np.histogram2d(points[:, 0], points[:, 1], bins=10, range=[[0, 1], [0, 1]])[0]
    assert counts.sum() == 5000
    assert counts.std() < np.sqrt(50) * 0.75  # 50 in each cell; chance would make it 7.1


def test_default_count_and_that_it_is_told(run, tmp_path):
    mesh_files.write_stl(tmp_path / "a.stl", RELIEF)
    done = run("a.stl", "a.stl", *QUICK, "-o", "T.txt", "--report", "r.json")
    faces, vertices = len(RELIEF[1]), len(RELIEF[0])
    assert f" : 100000 points sample the surface of its {faces} faces]" in done.stderr
    report = json.loads((tmp_path / "r.json").read_text())
    told = {"vertices": vertices, "faces": faces, "sampled_points": 100000}
    assert report["meshes"] == {"source": told, "target": told}
    assert report["counts"]["read_source"] == 100000


def test_no_points_means_the_vertices(run, tmp_path):
    mesh_files.write_stl(tmp_path / "a.stl", RELIEF)
    cloud_files.write_pcd(tmp_path / "a.pcd", RELIEF[0])
    done = run("a.stl", "a.pcd", *QUICK, "--mesh-points", "0", "--report", "r.json")
    assert f" : {len(RELIEF[0])} points]" in done.stderr
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["meshes"]["source"]["sampled_points"] == 0 and report["meshes"]["target"] is None


@pytest.mark.parametrize(
    ("name", "write"),
    [
        ("a.ply", lambda path: mesh_files.write_ply(path, RELIEF, "ascii")),
        ("a.ply", lambda path: mesh_files.write_ply(path, RELIEF, "binary")),
        ("a.ply", lambda path: mesh_files.write_ply(path, RELIEF, "big")),
        ("a.obj", lambda path: mesh_files.write_obj(path, RELIEF)),
        ("a.obj", lambda path: mesh_files.write_obj(path, RELIEF, from_last=True)),
        ("a.off", lambda path: mesh_files.write_off(path, RELIEF)),
        ("a.stl", lambda path: mesh_files.write_stl(path, RELIEF, "ascii")),
        ("a.stl", lambda path: mesh_files.write_stl(path, RELIEF, "binary")),
    ],
)
def test_one_mesh_in_every_format(run, tmp_path, name, write):
    """The same faces in the same order give the same samples, so the same bits."""
    mesh_files.write_ply(tmp_path / "reference.ply", RELIEF)
    few = [*QUICK, "--mesh-points", "300"]
    reference = run("reference.ply", "reference.ply", *few)
    write(tmp_path / name)
    done = run(name, name, *few)
    assert done.returncode in (0, 3), done.stderr
    assert done.stdout == reference.stdout
    assert done.stderr.count(f"300 points sample the surface of its {len(RELIEF[1])} faces") == 2


def test_polygons_are_fans(run, tmp_path):
    vertices, _ = mesh_files.square()
    mesh_files.write_off(tmp_path / "a.off", (vertices[:4] * [1, 1, 1], np.array([[0, 1, 2, 3]])))
    done = run("a.off", "a.off", *QUICK, "--mesh-points", "500")
    assert "500 points sample the surface of its 1 faces" in done.stderr


@pytest.fixture
def far(tmp_path) -> np.ndarray:
    """A scan of the relief elsewhere, as b.pcd; the pose of the relief in it."""
    T = np.eye(4)
    T[:3, :3] = rotation([1, 2, -1], 2.0)
    T[:3, 3] = [3, -2, 5]
    rng = np.random.default_rng(5)
    vertices, faces = RELIEF
    corners = vertices[faces]
    area = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    face = rng.choice(len(faces), 6000, p=area / area.sum())
    weight = rng.dirichlet([1, 1, 1], 6000)
    points = np.einsum("ij,ijk->ik", weight, corners[face])
    cloud_files.write_pcd(tmp_path / "b.pcd", moved(T, points))
    return T


@pytest.mark.parametrize("source", [".ply", ".obj", ".off", ".stl"])
@pytest.mark.parametrize("aligned", [".ply", ".obj"])
def test_aligned_has_the_own_vertices_and_faces(run, tmp_path, far, source, aligned):
    getattr(mesh_files, "write_" + source[1:])(tmp_path / f"a{source}", RELIEF)
    name = f"m{aligned}"
    done = run(f"a{source}", "b.pcd", "--threads", "2", "-o", "T.txt", "--aligned", name)
    assert done.returncode == 0, done.stderr
    T = np.loadtxt(tmp_path / "T.txt")
    assert np.abs(T - far).max() < 0.05
    assert (
        f"Saving {name} [done : {len(RELIEF[0])} vertices, {len(RELIEF[1])} faces]" in done.stderr
    )
    vertices, faces = getattr(mesh_files, "read_" + aligned[1:])(tmp_path / name)
    if aligned == ".ply":
        vertices = cloud_files.xyz(vertices)
    expected = moved(T, RELIEF[0])
    assert len(vertices) == len(RELIEF[0])
    # STL has its vertices in the order of its faces.
    assert np.allclose(vertices[faces], expected[RELIEF[1]], rtol=0, atol=2e-6)


def test_obj_keeps_its_other_lines(run, tmp_path, far):
    path = mesh_files.write_obj(tmp_path / "a.obj", RELIEF)
    run("a.obj", "b.pcd", "-o", "T.txt", "--aligned", "m.obj")
    before, after = path.read_text().splitlines(), (tmp_path / "m.obj").read_text().splitlines()
    assert len(before) == len(after)
    for old, new in zip(before, after, strict=True):
        assert old == new or old[:2] in ("v ", "vn")
    normal = next(line.split()[1:] for line in after if line.startswith("vn"))
    T = np.loadtxt(tmp_path / "T.txt")
    assert np.allclose([float(word) for word in normal], T[:3, 2], atol=1e-12)


def test_residuals_are_of_the_vertices_in_the_mesh_and_of_the_samples_in_the_report(
    run, tmp_path, far
):
    scipy = pytest.importorskip("scipy.spatial")
    mesh_files.write_stl(tmp_path / "a.stl", RELIEF)
    words = ("-o", "T.txt", "--aligned", "m.ply", "--report", "r.json", "--residuals")
    done = run("a.stl", "b.pcd", *words)
    assert done.returncode == 0, done.stderr
    vertices, _ = mesh_files.read_ply(tmp_path / "m.ply")
    target = cloud_files.xyz(cloud_files.read_pcd(tmp_path / "b.pcd")[0])
    distances = scipy.cKDTree(target).query(cloud_files.xyz(vertices))[0]
    assert np.allclose(vertices["residual"], distances, atol=5e-6)
    assert json.loads((tmp_path / "r.json").read_text())["residuals"]["count"] == 100000


def test_correspondences_are_of_vertices(run, refused, tmp_path):
    mesh_files.write_ply(tmp_path / "a.ply", RELIEF)
    rows = "".join(f"{i} {i}\n" for i in range(0, len(RELIEF[0]), 7))
    (tmp_path / "c.txt").write_text(rows)
    done = run("a.ply", "a.ply", "--correspondences", "c.txt")
    assert f" : {len(RELIEF[0])} points]" in done.stderr
    assert np.allclose(np.array(done.stdout.split(), float).reshape(4, 4), np.eye(4), atol=1e-6)
    message = refused(1, "a.ply", "a.ply", "--correspondences", "c.txt", "--mesh-points", "9")
    assert "--mesh-points 9 and --correspondences contradict each other" in message


def test_a_cloud_with_few_faces_is_a_cloud(run, tmp_path):
    cloud_files.write_ply(tmp_path / "a.ply", RELIEF[0], faces=True)
    done = run("a.ply", "a.ply", *QUICK)
    assert f" : {len(RELIEF[0])} points]" in done.stderr
    assert "its 1 faces are left out, most of its vertices are in none" in done.stderr


def test_faces_without_area_are_no_surface(run, tmp_path):
    vertices, faces = RELIEF
    mesh_files.write_ply(tmp_path / "a.ply", (vertices, faces[:, [0, 1, 1]]))
    done = run("a.ply", "a.ply", *QUICK)
    assert f"its {len(faces)} faces are left out, they have no area" in done.stderr


@pytest.mark.parametrize("data", ["ascii", "binary", "big"])
@pytest.mark.parametrize("corner", [-1, 1600, 2**31 - 1])
def test_ply_face_of_a_vertex_that_is_not_there(refused, tmp_path, data, corner):
    faces = RELIEF[1].copy()
    faces[3, 1] = corner
    mesh_files.write_ply(tmp_path / "a.ply", (RELIEF[0], faces), data)
    assert "'a.ply': face 4 has vertex " in refused(2, "a.ply", "a.ply", "-o", "T.txt")


@pytest.mark.parametrize("value", ["-1", "1e3", "100000001", "many"])
def test_count_that_is_none(refused, small, value):
    assert f"--mesh-points: '{value}' is not a whole number" in refused(
        1, *small, "--mesh-points", value
    )
