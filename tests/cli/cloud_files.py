"""Small writers and readers of PCD, PLY and OBJ, apart from those of PCL which are under test."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np

PCD_TYPES = {"f": "F", "i": "I", "u": "U"}
PLY_TYPES = {
    "f4": "float",
    "f8": "double",
    "u1": "uchar",
    "u2": "ushort",
    "i4": "int",
    "i1": "char",
    "u4": "uint",
    "i2": "short",
}
PLY_FORMATS = {"ascii": "ascii", "binary": "binary_little_endian", "big": "binary_big_endian"}


def table(points: np.ndarray, dtype: str = "f4", **fields: np.ndarray) -> np.ndarray:
    """A structured array of x, y, z and further fields, packed."""
    columns = {"x": points[:, 0], "y": points[:, 1], "z": points[:, 2]}
    layout = [(name, dtype) for name in columns]
    layout += [(name, values.dtype.str[1:], values.shape[1:]) for name, values in fields.items()]
    rows = np.zeros(len(points), layout)
    for name, values in (columns | fields).items():
        rows[name] = values
    return rows


def as_table(points: np.ndarray) -> np.ndarray:
    return points if points.dtype.names else table(points)


def pcd_header(
    rows: np.ndarray,
    data: str,
    width: int | None = None,
    height: int = 1,
    viewpoint: str = "0 0 0 1 0 0 0",
) -> str:
    kinds = [rows.dtype[name] for name in rows.dtype.names]
    count = len(rows) if width is None else width * height
    return "\n".join(
        [
            "# .PCD v0.7 - Point Cloud Data file format",
            "VERSION 0.7",
            "FIELDS " + " ".join(rows.dtype.names),
            "SIZE " + " ".join(str(kind.base.itemsize) for kind in kinds),
            "TYPE " + " ".join(PCD_TYPES[kind.base.kind] for kind in kinds),
            "COUNT " + " ".join(str(int(np.prod(kind.shape, dtype=int))) for kind in kinds),
            f"WIDTH {len(rows) if width is None else width}",
            f"HEIGHT {height}",
            f"VIEWPOINT {viewpoint}",
            f"POINTS {count}",
            f"DATA {data}",
            "",
        ]
    )


def text_rows(rows: np.ndarray) -> str:
    lines = []
    for row in rows:
        values = [value for item in row for value in np.atleast_1d(item)]
        lines.append(
            " ".join(repr(v.item()) if isinstance(v, np.generic) else repr(v) for v in values)
        )
    return "\n".join(lines) + "\n"


def write_pcd(path: Path, points: np.ndarray, data: str = "binary", **header) -> Path:
    rows = as_table(points)
    body = rows.tobytes()
    if data == "ascii":
        body = text_rows(rows).encode()
    elif data == "binary_compressed":
        planes = b"".join(rows[name].tobytes() for name in rows.dtype.names)
        packed = lzf_literals(planes)
        body = struct.pack("<II", len(packed), len(planes)) + packed
    path.write_bytes(pcd_header(rows, data, **header).encode() + body)
    return path


def lzf_literals(data: bytes) -> bytes:
    """A valid LZF stream that compresses nothing: runs of at most 32 literal bytes."""
    return b"".join(
        bytes([len(run) - 1]) + run for run in (data[i : i + 32] for i in range(0, len(data), 32))
    )


def write_ply(path: Path, points: np.ndarray, data: str = "binary", faces: bool = False) -> Path:
    rows = as_table(points)
    lines = [
        "ply",
        f"format {PLY_FORMATS[data]} 1.0",
        "comment written by a test",
        f"element vertex {len(rows)}",
    ]
    lines += [f"property {PLY_TYPES[rows.dtype[name].str[1:]]} {name}" for name in rows.dtype.names]
    if faces:
        lines += ["element face 1", "property list uchar int vertex_indices"]
    header = "\n".join([*lines, "end_header", ""]).encode()
    order = ">" if data == "big" else "<"
    face = (b"\x03" + struct.pack(order + "3i", 0, 1, 2)) if faces else b""
    body = rows.astype(rows.dtype.newbyteorder(order)).tobytes() + face
    if data == "ascii":
        body = (text_rows(rows) + ("3 0 1 2\n" if faces else "")).encode()
    path.write_bytes(header + body)
    return path


def with_element(ply: bytes, header: str, rows: bytes) -> bytes:
    """A PLY file with one more element behind the others."""
    return ply.replace(b"end_header\n", header.encode() + b"end_header\n", 1) + rows


def write_obj(path: Path, points: np.ndarray, normals: np.ndarray | None = None) -> Path:
    text = "# written by a test\n"
    text += "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist())
    if normals is not None:
        text += "".join(f"vn {x!r} {y!r} {z!r}\n" for x, y, z in normals.tolist())
    path.write_text(text + "f 1 2 3\n")
    return path


WRITERS = {".pcd": write_pcd, ".ply": write_ply, ".obj": write_obj}


def read_pcd(path: Path) -> tuple[np.ndarray, dict[str, list[str]]]:
    """Rows and header of a binary PCD file."""
    raw = path.read_bytes()
    end = raw.index(b"\n", raw.index(b"\nDATA ") + 1) + 1
    header = {
        words[0]: words[1:]
        for words in (line.split() for line in raw[:end].decode().splitlines() if line[0] != "#")
    }
    assert header["DATA"] == ["binary"]
    kinds = {"F": "f", "I": "i", "U": "u"}
    layout = [
        (name, f"<{kinds[kind]}{size}", (int(count),) if count != "1" else ())
        for name, size, kind, count in zip(
            header["FIELDS"], header["SIZE"], header["TYPE"], header["COUNT"], strict=True
        )
    ]
    rows = np.frombuffer(raw[end:], layout)
    assert len(rows) == int(header["POINTS"][0])
    return rows, header


def read_ply(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices of a binary PLY file, and what of its element camera is float (or nothing)."""
    raw = path.read_bytes()
    end = raw.index(b"end_header\n") + 11
    types = {name: "<" + kind for kind, name in PLY_TYPES.items()}
    layouts: dict[str, list] = {}
    counts = {}
    for line in raw[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            layouts[words[1]], counts[words[1]] = [], int(words[2])
        elif words[0] == "property":
            layouts[list(layouts)[-1]].append((words[2], types[words[1]]))
    assert next(iter(layouts)) == "vertex" and counts.get("face", 0) == 0
    vertices = np.frombuffer(raw, layouts["vertex"], counts["vertex"], end)
    camera = np.frombuffer(
        raw,
        layouts.get("camera", [("none", "<f4")]),
        counts.get("camera", 0),
        end + vertices.nbytes,
    )
    assert end + vertices.nbytes + camera.nbytes == len(raw)
    return vertices, camera


def xyz(rows: np.ndarray, names: str = "x y z") -> np.ndarray:
    return np.column_stack([rows[name].astype(float) for name in names.split()])
