"""The kinds of unknown scale, for command lines: without numpy, which need not be there yet."""

from __future__ import annotations

#: Values of the library's setting `scale`.
SEARCHED = ("free", "bounded", "units")
