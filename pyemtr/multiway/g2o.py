"""Pose graphs as g2o's text: VERTEX_SE3:QUAT and EDGE_SE3:QUAT."""

from __future__ import annotations

import os
from typing import NamedTuple

import numpy as np

from ..arrays import Floats
from ..whole_file import write_whole

# g2o has the translation before the rotation.
_ORDER = [3, 4, 5, 0, 1, 2]


class GraphEdge(NamedTuple):
    """A measurement between two poses.

    Attributes:
        target, source: the vertices, i and j in the file.
        transformation: float64 (4, 4), source into target: inverse(pose i) pose j.
        information: float64 (6, 6), of m = (w, v) in transformation exp(m), rotation first.
    """

    target: int
    source: int
    transformation: Floats
    information: Floats


class Graph(NamedTuple):
    """Poses (4, 4) by vertex, vertex -> frame of the graph, and the edges between them."""

    poses: dict[int, Floats]
    edges: list[GraphEdge]


def write_g2o(path: str | os.PathLike[str], graph: Graph) -> None:
    """Writes a graph; the file is written whole or not at all.

    The information is that of the translation and then of the rotation vector, in the frame of the
    source, as GTSAM reads it.
    """
    lines = [
        f"VERTEX_SE3:QUAT {vertex} {_numbers(_pose_numbers(pose))}"
        for vertex, pose in sorted(graph.poses.items())
    ]
    for edge in graph.edges:
        upper = edge.information[np.ix_(_ORDER, _ORDER)][np.triu_indices(6)]
        numbers = _numbers([*_pose_numbers(edge.transformation), *upper])
        lines.append(f"EDGE_SE3:QUAT {edge.target} {edge.source} {numbers}")
    write_whole(path, "\n".join(lines) + "\n")


def read_g2o(path: str | os.PathLike[str]) -> Graph:
    """Reads what :func:`write_g2o` wrote; lines of other tags are left out.

    Raises:
        ValueError: a line has not as many numbers as its tag asks for.
        OSError: the file cannot be read.
    """
    graph = Graph({}, [])
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            words = line.split()
            if not words or words[0] not in ("VERTEX_SE3:QUAT", "EDGE_SE3:QUAT"):
                continue
            vertex = words[0].startswith("VERTEX")
            wanted = 9 if vertex else 31
            if len(words) != wanted:
                raise ValueError(
                    f"{os.fspath(path)}:{number}: {words[0]}: expected {wanted - 1} numbers, got"
                    f" {len(words) - 1}"
                )
            if vertex:
                graph.poses[int(words[1])] = _pose([float(word) for word in words[2:]])
                continue
            values = [float(word) for word in words[3:]]
            upper = np.zeros((6, 6))
            upper[np.triu_indices(6)] = values[7:]
            information = upper + upper.T - np.diag(np.diag(upper))
            information = information[np.ix_(_ORDER, _ORDER)]
            graph.edges.append(
                GraphEdge(int(words[1]), int(words[2]), _pose(values[:7]), information)
            )
    return graph


def _numbers(values: list[float]) -> str:
    return " ".join(f"{value:.17g}" for value in values)


def _pose_numbers(pose: Floats) -> list[float]:
    return [*pose[:3, 3].tolist(), *quaternion(pose[:3, :3]).tolist()]


def quaternion(rotation: Floats) -> Floats:
    """Returns the unit quaternion (x, y, z, w) of a rotation (3, 3), w >= 0."""
    r = rotation
    # The eigenvector of the largest eigenvalue is exact for every angle.
    k = np.array([
        [r[0, 0] - r[1, 1] - r[2, 2], r[1, 0] + r[0, 1], r[2, 0] + r[0, 2], r[2, 1] - r[1, 2]],
        [r[1, 0] + r[0, 1], r[1, 1] - r[0, 0] - r[2, 2], r[2, 1] + r[1, 2], r[0, 2] - r[2, 0]],
        [r[2, 0] + r[0, 2], r[2, 1] + r[1, 2], r[2, 2] - r[0, 0] - r[1, 1], r[1, 0] - r[0, 1]],
        [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], r[0, 0] + r[1, 1] + r[2, 2]],
    ])  # fmt: skip
    vector = np.linalg.eigh(k)[1][:, -1]
    return np.asarray(-vector if vector[3] < 0 else vector)


def _pose(numbers: list[float]) -> Floats:
    q = np.array(numbers[3:7])
    x, y, z, w = q / np.linalg.norm(q)
    pose = np.eye(4)
    pose[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    pose[:3, 3] = numbers[:3]
    return pose
