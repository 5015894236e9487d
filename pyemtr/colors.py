"""Takes colors and intensities, given beside a cloud or brought along by it."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

from .arrays import contiguous_rows, real_array
from .tensors import plain

Singles = NDArray[np.float32]

# Names of columns and fields, of either case: the first group of which all are there.
_CHANNELS = (("red", "green", "blue"), ("r", "g", "b"))
_PACKED = ("rgb", "rgba")  # one number of four bytes: blue, green, red and perhaps alpha
_INTENSITY = ("intensity", "scalar_intensity")


def as_colors(colors: Any, name: str, points: int) -> Singles:
    """Returns colors float32 (N, 3), 0 to 1.

    Whole numbers count to 255, or to 65535 where one of them is larger; real ones to 1.

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N, 3), or numbers out of these ranges.
    """
    array = real_array(colors, name)
    if array.shape != (points, 3):
        raise ValueError(f"{name}: expected an array of shape ({points}, 3), got {array.shape}")
    whole = array.dtype.kind in "iu"
    known = array[~np.isnan(array)] if not whole else array
    most = float(known.max()) if known.size else 0.0
    if known.size and (known.min() < 0 or most > (65535 if whole else 1.0 + 1e-6)):
        raise ValueError(
            f"{name}: expected whole numbers from 0 to 255 (or 65535), or real ones from 0 to 1,"
            f" got {known.min()} to {most} of dtype {array.dtype}"
        )
    scale = (255 if most <= 255 else 65535) if whole else 1
    return contiguous_rows((array / scale).astype(np.float32))


def as_intensity(intensity: Any, name: str, points: int) -> Singles:
    """Returns intensities float32 (N, 1).

    Raises:
        TypeError: not numbers, or not real ones.
        ValueError: not (N,), or below 0.
    """
    array = real_array(intensity, name)
    if array.shape != (points,):
        raise ValueError(f"{name}: expected an array of shape ({points},), got {array.shape}")
    if (array < 0).any():
        raise ValueError(f"{name}: expected intensities not below 0, got {array.min()}")
    return array.astype(np.float32).reshape(-1, 1)


def brought_along(cloud: Any, name: str, points: int) -> tuple[Singles | None, Singles | None]:
    """Returns the colors and the intensities that a cloud has beside its points, None for none.

    They are columns of a table or fields of a structured array, or attributes of an object.

    Numbers that cannot be colors are none, since nobody asked for them.
    """
    names = cloud.dtype.names if isinstance(cloud, np.ndarray) else None
    if names:
        return _of_columns(names, cloud.__getitem__, name, points)
    if isinstance(cloud, np.ndarray):
        return None, None
    if hasattr(cloud, "columns") and hasattr(cloud, "__getitem__"):  # a DataFrame
        return _of_columns(cloud.columns, cloud.__getitem__, name, points)
    colors, intensity = getattr(cloud, "colors", None), getattr(cloud, "intensity", None)
    tensors = getattr(cloud, "point", None)  # of Open3D, by name
    if colors is None and tensors is not None and "colors" in tensors:
        colors = tensors.colors
    if intensity is not None and not isinstance(intensity, np.ndarray):
        intensity = None
    taken = None if colors is None or callable(colors) else np.asarray(plain(colors))
    if taken is not None and (taken.size == 0 or taken.ndim != 2 or taken.dtype.kind not in "fiu"):
        taken = None  # none, or something else of this name
    if taken is not None and taken.shape[1] == 4:
        taken = taken[:, :3]  # of red, green, blue and opacity
    return (
        None if taken is None else _usable_colors(taken, f"{name}: colors", points),
        None if intensity is None else _usable_intensity(intensity, f"{name}: intensity", points),
    )


def _of_columns(
    names: Any, column: Callable[[Any], Any], name: str, points: int
) -> tuple[Singles | None, Singles | None]:
    places = {str(one).strip().lower(): one for one in names}

    def get(one: str) -> NDArray[Any]:
        return np.asarray(column(places[one])).reshape(-1)

    colors = intensity = None
    group = next((g for g in _CHANNELS if all(one in places for one in g)), None)
    packed = next((one for one in _PACKED if one in places), None)
    if group:
        channels = np.column_stack([get(one) for one in group])
        colors = _usable_colors(channels, f"{name}: {', '.join(group)}", points)
    elif packed:
        colors = as_colors(_unpacked(get(packed)), f"{name}: {packed}", points)
    known = next((one for one in _INTENSITY if one in places), None)
    if known and get(known).dtype.kind in "fiu":
        intensity = _usable_intensity(get(known), f"{name}: {known}", points)
    return colors, intensity


def _usable_colors(channels: NDArray[Any], name: str, points: int) -> Singles | None:
    """The colors that nobody asked for; None where the numbers are none, which is no error."""
    if channels.dtype.kind not in "fiu" or channels.shape != (points, 3) or not channels.any():
        return None
    if channels.dtype.kind == "f":  # a text has no types
        most = float(np.nanmax(channels))
        channels = channels / (1 if most <= 1 else 255 if most <= 255 else 65535)
    try:
        return as_colors(channels, name, points)
    except ValueError:
        return None


def _usable_intensity(values: Any, name: str, points: int) -> Singles | None:
    """The intensities that nobody asked for: a negative number is none."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu" or array.shape != (points,):
        return None
    return as_intensity(np.where(array < 0, np.nan, array.astype(np.float64)), name, points)


def _unpacked(packed: NDArray[Any]) -> NDArray[np.uint8]:
    """Returns red, green and blue of numbers of four bytes, which PCD files call floats."""
    if packed.dtype.kind == "f":
        bits = packed.astype(np.float32).view(np.uint32)
    else:
        bits = packed.astype(np.int64).astype(np.uint32)
    return np.column_stack([(bits >> place) & 255 for place in (16, 8, 0)]).astype(np.uint8)
