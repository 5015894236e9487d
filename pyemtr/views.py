"""The figures and arrays of a Problem."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .arrays import Floats

Singles = NDArray[np.float32]


class ProblemViews(ABC):
    """Figures, and arrays as read-only views that keep the problem's memory alive.

    All lengths but ``normalization_scale`` and the centers are in the normalized frame.
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
        """float32 (n, 3), the points that are matched: the dense cloud's, or those with
        user-provided features or correspondences."""
        return self._array("source_feature_points")

    @property
    def target_feature_points(self) -> Singles:
        """float32 (n, 3), likewise of the target."""
        return self._array("target_feature_points")

    @property
    def source_feature_rows(self) -> NDArray[np.int32]:
        """int32 (n,), the rows of the feature points in the caller's array; empty when they are the
        dense cloud."""
        return self._array("source_feature_rows")[:, 0]

    @property
    def target_feature_rows(self) -> NDArray[np.int32]:
        """int32 (n,), likewise of the target."""
        return self._array("target_feature_rows")[:, 0]

    @property
    def source_normals(self) -> Singles:
        """float32 (n, 3), row by row with the dense cloud; NaN for a point without a normal."""
        return self._array("source_normals")

    @property
    def target_normals(self) -> Singles:
        """float32 (n, 3), row by row with the dense cloud; NaN for a point without a normal."""
        return self._array("target_normals")

    @property
    def source_features(self) -> Singles:
        """float32 (n, 33) FPFH, row by row with the dense cloud, NaN where there is none; or
        user-provided descriptors (n, D), row by row with the feature points; no rows with
        user-provided correspondences."""
        return self._array("source_features")

    @property
    def target_features(self) -> Singles:
        """float32 (n, 33) FPFH, row by row with the dense cloud, NaN where there is none; or
        user-provided descriptors (n, D), row by row with the feature points; no rows with
        user-provided correspondences."""
        return self._array("target_features")

    @property
    def correspondences(self) -> NDArray[np.int32]:
        """int32 (k, 2): rows of the source's and the target's feature points; the nearest
        descriptors first, or user-provided ones in their own order."""
        return self._array("correspondences")

    @property
    def tim_source(self) -> Singles:
        """float32 (l, 3): p_k - p_j of the pairs that are not pruned, among the first
        correspondences, up to ``max_tims`` pairs."""
        return self._array("tim_source")

    @property
    def tim_target(self) -> Singles:
        """float32 (l, 3): q_k - q_j, row by row with ``tim_source``."""
        return self._array("tim_target")

    @property
    def normalization_scale(self) -> float:
        """Length of one unit of the normalized frame, in the clouds' unit:
        p' = (p - center) / normalization_scale."""
        return self._number("normalization_scale")

    @property
    def center_source(self) -> Floats:
        """Centroid, float64 (3,), in the clouds' unit."""
        return np.array(self._describe()["center_source"], dtype=np.float64)

    @property
    def center_target(self) -> Floats:
        """Centroid, float64 (3,), in the clouds' unit."""
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
        """The number of translation invariant measurements, pruned ones included."""
        return int(self._describe()["tims"])

    @property
    def tims_pruned(self) -> int:
        """The number of them that no rotation can make an inlier; they are not in the arrays."""
        return int(self._describe()["tims_pruned"])
