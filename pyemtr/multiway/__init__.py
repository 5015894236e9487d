"""Many scans of one thing, aligned by pairs, loops and a pose graph.

:func:`pyemtr.align_all` is what most users need. The formats of pose graphs can be used by
themselves::

    from pyemtr.multiway import read_g2o, write_open3d
"""

from .align import align_all
from .edges import Edge
from .fuse import FusedCloud
from .g2o import Graph, GraphEdge, read_g2o, write_g2o
from .open3d_graph import read_open3d, write_open3d
from .result import MultiwayResult
from .verdicts import ScanVerdict

__all__ = [
    "Edge",
    "FusedCloud",
    "Graph",
    "GraphEdge",
    "MultiwayResult",
    "ScanVerdict",
    "align_all",
    "read_g2o",
    "read_open3d",
    "write_g2o",
    "write_open3d",
]
