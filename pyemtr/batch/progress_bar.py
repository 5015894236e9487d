"""How far a run is, on a terminal."""

from __future__ import annotations

import sys
from importlib import import_module
from typing import Any


class ProgressBar:
    """Pairs done, pairs per second and the time left, by tqdm on standard error.

    Args:
        shown: None for a bar when standard error is a terminal and tqdm is installed; True for one
            in any case; False for none.
        total: the number of pairs, None when it is not known.
        done: how many are recorded already.

    Raises ImportError when ``shown`` is True and tqdm is not installed.
    """

    def __init__(self, shown: bool | None, total: int | None, done: int) -> None:
        self._bar: Any = None
        if shown is False or (shown is None and not sys.stderr.isatty()):
            return
        try:
            tqdm = import_module("tqdm").tqdm
        except ImportError as error:
            if shown is None:
                return
            raise ImportError(
                "progress: the bar needs the package tqdm, which is not installed:"
                " pip install 'pyemtr[batch]'"
            ) from error
        self._bar = tqdm(total=total, initial=done, unit="pair", dynamic_ncols=True)

    def add(self, pairs: int) -> None:
        if self._bar is not None:
            self._bar.update(pairs)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
