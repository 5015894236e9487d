"""Tables with named columns: x, y and z are taken by name, wherever they are."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray


def axes_among(names: Iterable[Any]) -> list[int] | None:
    """Returns the places of x, y and z among names of either case; None when there are none.

    Raises:
        ValueError: some of the three are missing, or one is there twice.
    """
    plain = [str(name).strip().lower() for name in names]
    counts = [plain.count(axis) for axis in "xyz"]
    if counts == [0, 0, 0]:
        return None
    if counts != [1, 1, 1]:
        raise ValueError(f"expected one column each of x, y and z, got {', '.join(plain)}")
    return [plain.index(axis) for axis in "xyz"]


def columns_by_name(
    names: Iterable[Any], column: Callable[[Any], Any], name: str, unnamed: int = 0
) -> NDArray[Any] | None:
    """Returns the columns x, y and z of the table ``name`` side by side, (N, 3).

    ``column`` returns one by its name. None stands for a table of ``unnamed`` columns whose names
    tell nothing; its columns are taken in their order.

    Raises:
        TypeError: no column is named x, y or z.
        ValueError: not one of each.
    """
    listed = list(names)
    try:
        places = axes_among(listed)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    if places is not None:
        return np.column_stack([np.asarray(column(listed[place])) for place in places])
    if len(listed) == unnamed:
        return None
    raise TypeError(
        f"{name}: expected columns x, y and z in the table or dtype, got"
        f" {', '.join(str(one) for one in listed) or 'none'}"
    )
