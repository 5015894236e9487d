"""Pairs whose sensors have known positions: the origin of each scan's coordinates."""

from __future__ import annotations

import re

from .pairs import Pair

_GROUPS = ("lidar", "threedmatch")
_VIEWS = re.compile(r"[a-z]+_\d+_\d+")  # two scans of an object; not its model, nor a simulated one


def sensors_known(pair: Pair) -> bool:
    return pair.group in _GROUPS or (
        pair.group == "uwa" and _VIEWS.fullmatch(pair.name) is not None
    )
