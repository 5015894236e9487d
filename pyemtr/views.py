"""What a Problem shows of itself."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .arrays import Floats

Singles = NDArray[np.float32]


class ProblemViews(ABC):
    """Figures, and arrays that are read-only views: they keep the problem's memory alive.

    All lengths but ``scale`` and the centres are in the normalized frame.
    """

    @abstractmethod
    def _array(self, name: str) -> NDArray[Any]: ...

    @abstractmethod
    def _describe(self) -> dict[str, Any]: ...

    def _number(self, name: str) -> float:
        return float(self._describe()[name])

    @property
    def source_sparse(self) -> Singles:
        """float32 (n, 3)."""
        return self._array("source_sparse")

    @property
    def target_sparse(self) -> Singles:
        """float32 (n, 3)."""
        return self._array("target_sparse")

    @property
    def source_dense(self) -> Singles:
        """float32 (n, 3)."""
        return self._array("source_dense")

    @property
    def target_dense(self) -> Singles:
        """float32 (n, 3)."""
        return self._array("target_dense")

    @property
    def source_feature_points(self) -> Singles:
        """float32 (n, 3), the points that are matched: those of the dense cloud, or those that
        features or correspondences were handed in for."""
        return self._array("source_feature_points")

    @property
    def target_feature_points(self) -> Singles:
        """float32 (n, 3), likewise of the target."""
        return self._array("target_feature_points")

    @property
    def source_feature_rows(self) -> NDArray[np.int32]:
        """int32 (n,), where the feature points stand in the caller's array; empty when they are the
        dense cloud."""
        return self._array("source_feature_rows")[:, 0]

    @property
    def target_feature_rows(self) -> NDArray[np.int32]:
        """int32 (n,), likewise of the target."""
        return self._array("target_feature_rows")[:, 0]

    @property
    def source_normals(self) -> Singles:
        """float32 (n, 3), by rows of the dense cloud; NaN where there is none."""
        return self._array("source_normals")

    @property
    def target_normals(self) -> Singles:
        """float32 (n, 3), by rows of the dense cloud; NaN where there is none."""
        return self._array("target_normals")

    @property
    def source_features(self) -> Singles:
        """FPFH, float32 (n, 33), by rows of the dense cloud, NaN where there is none; or what was
        handed in, by rows of the feature points; no rows with correspondences."""
        return self._array("source_features")

    @property
    def target_features(self) -> Singles:
        """FPFH, float32 (n, 33), by rows of the dense cloud, NaN where there is none; or what was
        handed in, by rows of the feature points; no rows with correspondences."""
        return self._array("target_features")

    @property
    def correspondences(self) -> NDArray[np.int32]:
        """int32 (k, 2): rows of the source's and the target's feature points; the nearest
        descriptors first, or in the order in which they were handed in."""
        return self._array("correspondences")

    @property
    def tim_source(self) -> Singles:
        """float32 (l, 3): p_k - p_j of the pairs that are not pruned, of the first correspondences,
        as many as ``max_tims`` lets in."""
        return self._array("tim_source")

    @property
    def tim_target(self) -> Singles:
        """float32 (l, 3): q_k - q_j, row by row with ``tim_source``."""
        return self._array("tim_target")

    @property
    def scale(self) -> float:
        """p' = (p - center) / scale; the clouds' unit."""
        return self._number("scale")

    @property
    def center_source(self) -> Floats:
        """float64 (3,), the clouds' unit."""
        return np.array(self._describe()["center_source"], dtype=np.float64)

    @property
    def center_target(self) -> Floats:
        """float64 (3,), the clouds' unit."""
        return np.array(self._describe()["center_target"], dtype=np.float64)

    @property
    def leaf_sparse(self) -> float:
        """Edge of the sparse clouds' voxels."""
        return self._number("leaf_sparse")

    @property
    def leaf_dense(self) -> float:
        """Edge of the dense clouds' voxels."""
        return self._number("leaf_dense")

    @property
    def c_sparse(self) -> float:
        """Scale c of the M-estimator in the S stage."""
        return self._number("c_sparse")

    @property
    def c_dense(self) -> float:
        """Scale c of the M-estimator in the D stage."""
        return self._number("c_dense")

    @property
    def tau(self) -> float:
        """Noise bound of task beta."""
        return self._number("tau")

    @property
    def tims(self) -> int:
        """Translation invariant measurements formed, pruned ones included."""
        return int(self._describe()["tims"])

    @property
    def tims_pruned(self) -> int:
        """Those that can be an inlier of no rotation; not in the arrays."""
        return int(self._describe()["tims_pruned"])
