"""Pose graphs as Open3D's JSON, which open3d.io.read_pose_graph() reads."""

from __future__ import annotations

import json
import os
from typing import Any

import numpy as np

from ..arrays import Floats
from ..whole_file import write_whole
from .g2o import Graph, GraphEdge
from .rigid import adjoint, inverse

_VERSION = {"version_major": 1, "version_minor": 0}


def write_open3d(path: str | os.PathLike[str], graph: Graph) -> None:
    """Writes a graph whose vertices are 0, 1, 2 and so on; whole or not at all.

    Open3D has the information of a motion of the target's points about the origin of their frame,
    rotation first, and writes matrices by columns.

    Raises ValueError when a vertex is missing.
    """
    if sorted(graph.poses) != list(range(len(graph.poses))):
        raise ValueError(f"expected vertices from 0 on without a gap, got {sorted(graph.poses)}")
    nodes = [
        {"class_name": "PoseGraphNode", "pose": _columns(graph.poses[vertex]), **_VERSION}
        for vertex in sorted(graph.poses)
    ]
    edges = []
    for edge in graph.edges:
        carried = adjoint(inverse(edge.transformation))
        edges.append(
            {
                "class_name": "PoseGraphEdge",
                "confidence": 1.0,
                "information": _columns(carried.T @ edge.information @ carried),
                "source_node_id": edge.source,
                "target_node_id": edge.target,
                "transformation": _columns(edge.transformation),
                "uncertain": False,
                **_VERSION,
            }
        )
    value = {"class_name": "PoseGraph", "edges": edges, "nodes": nodes, **_VERSION}
    write_whole(path, json.dumps(value, indent=1) + "\n")


def read_open3d(path: str | os.PathLike[str]) -> Graph:
    """Reads a pose graph of Open3D.

    Raises:
        ValueError: not JSON, or not a pose graph.
        OSError: the file cannot be read.
    """
    with open(path, encoding="utf-8") as file:
        value = json.load(file)
    if not isinstance(value, dict) or value.get("class_name") != "PoseGraph":
        raise ValueError(f"{os.fspath(path)}: expected a PoseGraph of Open3D")
    poses = {i: _matrix(node["pose"], 4) for i, node in enumerate(value["nodes"])}
    edges = []
    for edge in value["edges"]:
        transformation = _matrix(edge["transformation"], 4)
        carried = adjoint(transformation)
        information = carried.T @ _matrix(edge["information"], 6) @ carried
        edges.append(
            GraphEdge(edge["target_node_id"], edge["source_node_id"], transformation, information)
        )
    return Graph(poses, edges)


def _columns(matrix: Floats) -> list[float]:
    return [float(value) for value in matrix.T.ravel()]


def _matrix(values: Any, size: int) -> Floats:
    return np.array(values, dtype=np.float64).reshape(size, size).T
