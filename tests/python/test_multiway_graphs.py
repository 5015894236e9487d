"""Pose graphs: their files read back, by GTSAM too, and information from frame to frame."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from shapes import random_transformation

from pyemtr.multiway import Graph, GraphEdge, read_g2o, read_open3d, write_g2o, write_open3d
from pyemtr.multiway.information import about_origin, at_source
from pyemtr.multiway.rigid import adjoint, angle, exponential, inverse


def made_graph(vertices: tuple[int, ...] = (0, 1, 2), seed: int = 3) -> Graph:
    rng = np.random.default_rng(seed)
    poses = {vertex: random_transformation(rng) for vertex in vertices}
    edges = []
    for target, source in zip(vertices, vertices[1:]):
        root = rng.normal(size=(6, 6))
        measured = inverse(poses[target]) @ poses[source]
        edges.append(GraphEdge(target, source, measured, root @ root.T))
    return Graph(poses, edges)


def assert_same(read: Graph, wanted: Graph) -> None:
    assert sorted(read.poses) == sorted(wanted.poses) and len(read.edges) == len(wanted.edges)
    for vertex, pose in wanted.poses.items():
        np.testing.assert_allclose(read.poses[vertex], pose, atol=1e-12)
    for one, other in zip(read.edges, wanted.edges):
        assert (one.target, one.source) == (other.target, other.source)
        np.testing.assert_allclose(one.transformation, other.transformation, atol=1e-12)
        np.testing.assert_allclose(one.information, other.information, atol=1e-9)


def test_g2o_reads_back(tmp_path: Path) -> None:
    graph = made_graph((0, 4, 7))
    write_g2o(tmp_path / "graph.g2o", graph)
    assert_same(read_g2o(tmp_path / "graph.g2o"), graph)


def test_gtsam_reads_the_same_graph(tmp_path: Path) -> None:
    gtsam = pytest.importorskip("gtsam", reason="gtsam is not installed")
    graph = made_graph()
    write_g2o(tmp_path / "graph.g2o", graph)
    factors, values = gtsam.readG2o(str(tmp_path / "graph.g2o"), True)
    for vertex, pose in graph.poses.items():
        np.testing.assert_allclose(values.atPose3(vertex).matrix(), pose, atol=1e-9)
    assert factors.size() == len(graph.edges)
    assert factors.error(values) < 1e-12  # so an edge is what is between its poses
    # Moved a little, the error is that of the information as this project understands it.
    motion = 1e-4 * np.array([1.0, -2.0, 0.5, 3.0, 1.0, -1.0])
    last = graph.poses[2] @ exponential(motion)
    values.update(2, gtsam.Pose3(last))
    wanted = 0.5 * motion @ graph.edges[1].information @ motion
    assert factors.error(values) == pytest.approx(wanted, rel=1e-3)


def test_open3d_reads_back(tmp_path: Path) -> None:
    graph = made_graph()
    write_open3d(tmp_path / "graph.json", graph)
    assert_same(read_open3d(tmp_path / "graph.json"), graph)


def test_open3d_has_matrices_by_columns_and_information_about_the_origin(tmp_path: Path) -> None:
    graph = made_graph((0, 1))
    write_open3d(tmp_path / "graph.json", graph)
    value = json.loads((tmp_path / "graph.json").read_text(encoding="utf-8"))
    assert value["class_name"] == "PoseGraph" and value["nodes"][1]["pose"][12:15] == list(
        graph.poses[1][:3, 3]
    )
    edge = value["edges"][0]
    assert (edge["source_node_id"], edge["target_node_id"]) == (1, 0)
    # exp(n) T = T exp(m): what n costs there is what m costs here
    n = 1e-5 * np.arange(1.0, 7.0)
    pose = graph.edges[0].transformation
    m = np.linalg.solve(adjoint(pose), n)
    np.testing.assert_allclose(exponential(n) @ pose, pose @ exponential(m), atol=1e-8)
    there = np.array(edge["information"]).reshape(6, 6)
    assert n @ there @ n == pytest.approx(m @ graph.edges[0].information @ m)


def test_open3d_itself_reads_it(tmp_path: Path) -> None:
    open3d = pytest.importorskip("open3d", reason="Open3D is not installed")
    graph = made_graph()
    write_open3d(tmp_path / "graph.json", graph)
    read = open3d.io.read_pose_graph(str(tmp_path / "graph.json"))
    for vertex, pose in graph.poses.items():
        np.testing.assert_allclose(read.nodes[vertex].pose, pose, atol=1e-9)
    np.testing.assert_allclose(read.edges[0].transformation, graph.edges[0].transformation)


def test_a_gap_among_the_nodes_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"from 0 on without a gap, got \[0, 2, 3\]"):
        write_open3d(tmp_path / "graph.json", made_graph((0, 2, 3)))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("line", ["VERTEX_SE3:QUAT 0 1 2", "EDGE_SE3:QUAT 0 1 0 0 0 0 0 0 1 5"])
def test_a_short_line_is_named(tmp_path: Path, line: str) -> None:
    path = tmp_path / "bad.g2o"
    path.write_text(f"# a comment\n{line}\n", encoding="utf-8")
    with pytest.raises(ValueError, match=r"bad\.g2o:2: .*: expected (8|30) numbers"):
        read_g2o(path)


def test_another_json_is_no_pose_graph(tmp_path: Path) -> None:
    (tmp_path / "x.json").write_text("[1]", encoding="utf-8")
    with pytest.raises(ValueError, match=r"x\.json: expected a PoseGraph"):
        read_open3d(tmp_path / "x.json")


def test_information_keeps_what_a_motion_costs() -> None:
    """The same small motion of the points, described in the three ways, costs the same."""
    rng = np.random.default_rng(8)
    pose, center = random_transformation(rng), rng.normal(size=3)
    root = rng.normal(size=(6, 6))
    information = root @ root.T
    m = 1e-5 * rng.normal(size=6)
    moved = pose @ exponential(m)
    n = adjoint(pose) @ m  # about the origin, in the target's axes
    w, v = n[:3], n[3:] + np.cross(n[:3], center)  # about the center
    points = rng.normal(size=(20, 3))
    before = points @ pose[:3, :3].T + pose[:3, 3]
    after = before + np.cross(w, before - center) + v
    np.testing.assert_allclose(after, points @ moved[:3, :3].T + moved[:3, 3], atol=1e-8)
    cost = np.concatenate([w, v]) @ information @ np.concatenate([w, v])
    carried = at_source(about_origin(information, center), pose)
    assert m @ carried @ m == pytest.approx(cost, rel=1e-9)


@pytest.mark.parametrize("degrees", [0.0, 1e-6, 0.5, 90.0, 179.9999, 180.0])
def test_the_angle_of_a_rotation(degrees: float) -> None:
    axis = np.array([1.0, 2.0, -2.0]) / 3
    rotation = exponential(np.concatenate([np.radians(degrees) * axis, np.zeros(3)]))[:3, :3]
    assert float(angle(rotation)) == pytest.approx(degrees, abs=1e-9)
