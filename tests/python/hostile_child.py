"""Runs the rows of hostile_rows in this process, under limits, and writes one JSON line of each.

Usage: python -m hostile_child LIBEMTR|- : with a path, by the C library too.
"""

from __future__ import annotations

import ctypes
import json
import resource
import signal
import sys
from typing import Any

import hostile_rows
import numpy as np

import pyemtr

MEMORY, SECONDS = 4 << 30, 400  # of the whole process; of one row
STATUS_OK = 0


class CCloud(ctypes.Structure):
    _fields_ = (
        ("points", ctypes.c_void_p),
        ("count", ctypes.c_size_t),
        ("stride", ctypes.c_size_t),
        ("scalar", ctypes.c_int),
        ("normals", ctypes.c_void_p),
        ("normal_stride", ctypes.c_size_t),
        ("features", ctypes.c_void_p),
        ("feature_dimension", ctypes.c_size_t),
        ("feature_stride", ctypes.c_size_t),
        ("keep_points", ctypes.c_int32),
        ("colors", ctypes.c_void_p),
        ("color_stride", ctypes.c_size_t),
        ("intensities", ctypes.c_void_p),
        ("intensity_stride", ctypes.c_size_t),
    )


class CResult(ctypes.Structure):
    """The beginning of emtr_result."""

    _fields_ = (
        ("size", ctypes.c_size_t),
        ("transformation", ctypes.c_double * 16),
        ("registered", ctypes.c_int32),
        ("reason", ctypes.c_int),
    )


def by_python(source: object, target: object) -> dict[str, Any]:
    try:
        result = pyemtr.register(source, target)
    except (ValueError, TypeError, MemoryError, OSError, RuntimeError) as error:
        return {"error": type(error).__name__, "message": str(error)}
    return {
        "reason": result.reason,
        "registered": result.registered,
        "confidence": result.confidence,
        "transformation": result.transformation.ravel().tolist(),
    }


def as_it_lies(cloud: object) -> CCloud | None:
    """Returns rows of floats or doubles at any distance, as a C program may pass them."""
    if not isinstance(cloud, np.ndarray) or cloud.ndim != 2 or cloud.shape[1] != 3:
        return None
    scalars = {np.dtype("f4"): 0, np.dtype("f8"): 1}
    row, step = cloud.strides
    if cloud.dtype not in scalars or step != cloud.itemsize or row < 3 * step:
        return None
    return CCloud(cloud.ctypes.data, len(cloud), row, scalars[cloud.dtype])


def by_c(library: ctypes.CDLL, source: object, target: object) -> dict[str, Any] | None:
    clouds = [as_it_lies(cloud) for cloud in (source, target)]
    if None in clouds:
        return None
    found = ctypes.POINTER(CResult)()
    arguments = [ctypes.byref(cloud) for cloud in clouds if cloud]
    status = library.emtr_register(*arguments, None, None, None, ctypes.byref(found))
    if status != STATUS_OK:
        return {"status": status, "message": library.emtr_error_message().decode()}
    result = found.contents
    value = {
        "reason_text": library.emtr_reason_text(result.reason).decode(),
        "registered": bool(result.registered),
        "transformation": list(result.transformation),
    }
    library.emtr_result_free(found)
    return value


def load(path: str) -> ctypes.CDLL:
    library = ctypes.CDLL(path)
    library.emtr_error_message.restype = ctypes.c_char_p
    library.emtr_reason_text.restype = ctypes.c_char_p
    library.emtr_result_free.restype = None
    return library


def main() -> None:
    library = None if sys.argv[1] == "-" else load(sys.argv[1])
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    for name, row in hostile_rows.ROWS.items():
        print(json.dumps({"begin": name}), flush=True)
        signal.alarm(SECONDS)  # ends the process
        source, target = row.make()
        line = {"name": name, "python": by_python(source, target)}
        if library:
            line["c"] = by_c(library, source, target)
        signal.alarm(0)
        print(json.dumps(line), flush=True)


main()
