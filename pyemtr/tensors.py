"""Tensors of Open3D and PyTorch as arrays."""

from __future__ import annotations

from typing import Any


def is_tensor(thing: Any) -> bool:
    """Tells whether it is a tensor of Open3D or PyTorch, perhaps on another device."""
    return hasattr(thing, "cpu") and hasattr(thing, "numpy")


def plain(points: Any) -> Any:
    """Returns what an attribute gives: points, a method that returns them (small_gicp, python-pcl),
    or a map of tensors by name (Open3D)."""
    if callable(points):
        points = points()
    if hasattr(points, "positions"):
        points = points.positions
    if is_tensor(points):
        points = points.detach() if hasattr(points, "detach") else points
        points = points.cpu().numpy()
    return points
