"""Python processes started by tests."""

from __future__ import annotations

import os
from pathlib import Path

HERE = Path(__file__).resolve().parent


def environment() -> dict[str, str]:
    """The variables under which a child finds the same pyemtr, and the tests' own modules.

    Start it away from the checkout: Python looks in the working directory first, and would
    find the sources there.
    """
    import pyemtr

    places = [str(Path(pyemtr.__file__).parent.parent), str(HERE)]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(places)}
