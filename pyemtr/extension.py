"""Imports the extension module, or says which library it lacks. Private."""

from __future__ import annotations

import re

__all__ = ["_emtr"]

# Packages that are not named as their library is.
_PACKAGES = {"flann-cpp": "flann"}


def _debian_package(library: str) -> str:
    """Names Debian's package of a shared library: libpcl_io.so.1.13 is in libpcl-io1.13."""
    stem, _, version = library.partition(".so")
    name = stem[3:].replace("_", "-").lower()
    name = _PACKAGES.get(name, name)
    dash = "-" if name[-1:].isdigit() else ""
    return f"lib{name}{dash}{version.lstrip('.')}"


def _explanation(message: str) -> str | None:
    """Says what to do about the dynamic linker's message; None if it names no missing library."""
    found = re.match(r"(lib[\w+.-]+?\.so[\w.]*): cannot open shared object file", message)
    if found is None:
        return None
    return (
        f"pyemtr needs the library {found[1]}, which was there when pyemtr was built and is not "
        f"on this system. On Debian: apt-get install {_debian_package(found[1])}. If the system "
        "has another release of it: apt-get install libpcl-dev, and build pyemtr again by "
        "pip install --force-reinstall --no-cache-dir"
    )


try:
    from . import _emtr
except ImportError as failure:
    explanation = _explanation(str(failure))
    if explanation is None:
        raise
    raise ImportError(explanation) from failure
