"""What :func:`pyemtr.align_all` returns."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..arrays import Floats
from ..result import Result
from ..result_json import to_json
from .colors import Rows
from .edges import Edge
from .fuse import FusedCloud, fuse
from .g2o import Graph, GraphEdge, write_g2o
from .information import about_origin, at_source
from .open3d_graph import write_open3d
from .output import save
from .pages import Which, write_pages
from .rigid import moved
from .scans import Scans
from .verdicts import ScanVerdict


@dataclass(frozen=True, eq=False, repr=False)
class MultiwayResult:
    """The poses of many scans, and how far to trust them.

    Attributes:
        scans: list of :class:`pyemtr.multiway.ScanVerdict`, one for each scan, in the order they
            were given: its pose, scan -> frame of its model, the covariance of the pose, and why
            it was left out if it was.
        edges: list of :class:`pyemtr.multiway.Edge`, one for each pair that was registered.
        models: indices of the scans of each model, ascending; the model of the lowest scan first.
            The frame of a model is that of its first scan.
        radius: the median radius of the scans, in their unit.
        seconds: wall time.
    """

    scans: list[ScanVerdict]
    edges: list[Edge]
    models: list[list[int]]
    radius: float
    seconds: float
    _source: Scans = field(compare=False)
    _results: Mapping[tuple[int, int], Result] = field(compare=False)

    @property
    def poses(self) -> Floats:
        """float64 (N, 4, 4), scan -> frame of its model, q = R p + t; NaN where left out."""
        return np.array([scan.pose for scan in self.scans])

    @property
    def placed(self) -> list[int]:
        """Indices of the scans that are part of a model."""
        return [i for i, scan in enumerate(self.scans) if scan.placed]

    @property
    def left_out(self) -> list[int]:
        """Indices of the scans that are not."""
        return [i for i, scan in enumerate(self.scans) if not scan.placed]

    def fuse(self, model: int = 0, voxel: float | None = None) -> FusedCloud:
        """Returns the average of all points of a model in each voxel.

        Scans that were given by path are read again, one at a time.

        Args:
            model: its index.
            voxel: edge of the voxels, in the scans' unit. None: 0.005 radii.

        Raises:
            IndexError: no such model.
            ValueError: a voxel that is not above 0, or too small for the extent of the points.
            OSError: a file that cannot be read again.
        """
        size = 0.005 * self.radius if voxel is None else float(voxel)
        if not (0 < size < np.inf):
            raise ValueError(f"voxel: expected a length above 0, got {voxel}")
        return fuse(self._moved(self.models[model]), size)

    def graph(self, model: int = 0) -> Graph:
        """Returns the pose graph of a model: its scans by their indices, and the edges that were
        taken, as :func:`pyemtr.multiway.write_g2o` takes it. Raises IndexError for no such model.
        """
        members = self.models[model]
        edges = [
            GraphEdge(
                edge.target,
                edge.source,
                edge.transformation,
                at_source(about_origin(edge.information, edge.center_target), edge.transformation),
            )
            for edge in self.edges
            if edge.taken and edge.source in members
        ]
        return Graph({scan: self.scans[scan].pose for scan in members}, edges)

    def write_g2o(self, path: str | os.PathLike[str], model: int = 0) -> None:
        """Writes the pose graph of a model as g2o's text, whole or not at all; the vertices are the
        indices of the scans. Raises IndexError for no such model, and OSError."""
        write_g2o(path, self.graph(model))

    def write_open3d(self, path: str | os.PathLike[str], model: int = 0) -> None:
        """Writes the pose graph of a model as Open3D's JSON, whole or not at all; node i is the
        i-th scan of the model. Raises IndexError for no such model, and OSError."""
        graph = self.graph(model)
        place = {scan: i for i, scan in enumerate(sorted(graph.poses))}
        poses = {place[scan]: pose for scan, pose in graph.poses.items()}
        edges = [
            edge._replace(source=place[edge.source], target=place[edge.target])
            for edge in graph.edges
        ]
        write_open3d(path, Graph(poses, edges))

    def save(self, folder: str | os.PathLike[str], voxel: float | None = None) -> list[str]:
        """Writes poses, graphs, fused clouds, the report and, where matplotlib is installed, a
        picture of each model into a folder, which is made. docs/MANY_SCANS.md lists them.

        Args:
            folder: where to.
            voxel: of the fused clouds, as in :meth:`fuse`.

        Returns:
            The names of the files.

        Raises:
            ImportError: plyfile is not installed: ``pip install 'pyemtr[align]'``.
            ValueError: as :meth:`fuse`.
            OSError: a file that cannot be written, or read again.
        """
        return save(self, folder, voxel)

    def to_html(
        self,
        folder: str | os.PathLike[str],
        *,
        title: str = "Many scans",
        unit: str = "",
        up: Sequence[float] = (0.0, 0.0, 1.0),
        pairs: Which = "all",
        max_points: int = 15_000,
        threads: int = 0,
    ) -> list[str]:
        """Writes pages to look at. ``index.html`` shows each model with every scan in a color of
        its own, the pose graph, and each pair with why it was taken or not. ``pairs/`` has the page
        of each pair, as :meth:`pyemtr.Result.to_html` writes it. They load nothing.

        Args:
            folder: where to; it is made. Each page is written whole or not at all, the index last.
            title: above the index.
            unit: name of the scans' unit, for the scale bars and the distances.
            up: direction (3,) in the models' frame that is up on the screen.
            pairs: of which a page is written: "all" that were registered, those that were "taken",
                or "none".
            max_points: of each scan on the page of a pair. A page takes about 1 MB.
            threads: as in :meth:`pyemtr.Result.to_html`.

        Returns:
            The paths of the files, from the folder.

        Raises:
            ValueError: an argument out of range.
            OSError: a file that cannot be written, or read again.
        """
        return write_pages(
            self, folder, title=title, unit=unit, up=up, pairs=pairs, max_points=max_points,
            threads=threads,
        )  # fmt: skip

    def to_dict(self) -> dict[str, Any]:
        """Returns all that is known as JSON values: lists for arrays, None for NaN."""
        value: dict[str, Any] = to_json(
            {
                "scans": [vars(scan) for scan in self.scans],
                "edges": [vars(edge) for edge in self.edges],
                "models": self.models,
                "radius": self.radius,
                "seconds": self.seconds,
            }
        )
        return value

    def moved_rows(self, scan: int) -> Rows:
        """Returns all points of a placed scan in its model's frame, with its normals and colors."""
        pose, rows = self.scans[scan].pose, self._source.rows(scan)
        normals = None if rows.normals is None else rows.normals @ pose[:3, :3].T
        return Rows(moved(pose, rows.points), normals, rows.colors)

    def registration(self, source: int, target: int) -> Result:
        """Returns the result of a pair that was registered: a :class:`pyemtr.Result`, source into
        target. Raises KeyError for a pair that was not, also for the reverse of one that was."""
        return self._results[source, target]

    def points(self, scan: int) -> Floats:
        """Returns all finite points of a scan in its own frame, float64 (N, 3). A scan that was
        given by path is read again."""
        return self._source.rows(scan).points

    def surface(self, scan: int) -> Floats:
        """Returns a scan's surface in its own frame, thinned to some thousand points: float64
        (N, 3)."""
        return self._source.surface(scan).points

    def _moved(self, members: list[int]) -> Iterator[Rows]:
        for scan in members:
            yield self.moved_rows(scan)

    def __repr__(self) -> str:
        lines = [
            f"<pyemtr.MultiwayResult: {len(self.placed)} of {len(self.scans)} scans placed in"
            f" {len(self.models)} model{'s' if len(self.models) != 1 else ''},"
            f" {sum(edge.taken for edge in self.edges)} of {len(self.edges)} edges taken,"
            f" {self.seconds:.1f} s>"
        ]
        for i, scan in enumerate(self.scans):
            where = f"model {scan.model}" if scan.placed else scan.verdict
            lines.append(f"  {i:3d} {scan.name}: {where}, {scan.text}")
        return "\n".join(lines)
