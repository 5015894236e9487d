#!/usr/bin/env python3
"""Writes the inputs that fuzzing begins with: seeds.py FOLDER makes FOLDER/<target>/<name>."""

from __future__ import annotations

import math
import random
import struct
import sys
from pathlib import Path

POINTS = [
    (round(math.cos(i), 3), round(math.sin(2.0 * i), 3), round(0.1 * i - 0.6, 3)) for i in range(12)
]
XYZ = struct.Struct("<3f")


def calls() -> dict[str, bytes]:
    """For the targets that read choices from bytes: of several lengths, the same every time."""
    draw = random.Random(7)
    return {
        f"bytes-{n}": bytes(draw.randrange(256) for _ in range(n)) for n in (1, 8, 40, 120, 400)
    }


def pcd_header(
    fields: str,
    sizes: str,
    types: str,
    data: str,
    counts: str = "",
    viewpoint: str = "0 0 0 1 0 0 0",
    width: int = 12,
    height: int = 1,
) -> bytes:
    counts = counts or " ".join("1" for _ in fields.split())
    return (
        f"# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS {fields}\n"
        f"SIZE {sizes}\nTYPE {types}\nCOUNT {counts}\nWIDTH {width}\nHEIGHT {height}\n"
        f"VIEWPOINT {viewpoint}\nPOINTS {width * height}\nDATA {data}\n"
    ).encode()


def text(rows: list[tuple[float, ...]]) -> bytes:
    return "".join(" ".join(map(str, row)) + "\n" for row in rows).encode()


def lzf(plain: bytes) -> bytes:
    """An LZF stream of literals and of one long reference, when the data ends in equal bytes."""
    zeros = len(plain) - len(plain.rstrip(b"\0"))
    reference = b""
    if zeros >= 10:
        length = min(zeros - 1, 264)
        plain = plain[: len(plain) - length]
        reference = bytes([7 << 5, length - 9, 0])
    runs = (plain[i : i + 32] for i in range(0, len(plain), 32))
    return b"".join(bytes([len(run) - 1]) + run for run in runs) + reference


def pcd() -> dict[str, bytes]:
    columns = b"".join(struct.pack("<12f", *axis) for axis in zip(*POINTS)) + bytes(48)
    packed = lzf(columns)
    binary = b"".join(XYZ.pack(*p) for p in POINTS)
    mixed = b"".join(struct.pack("<3dIB3hf", *p, 0xFF8040, 7, 1, 2, 3, math.nan) for p in POINTS)
    return {
        "ascii": pcd_header("x y z", "4 4 4", "F F F", "ascii") + text(POINTS),
        "ascii-fields": pcd_header(
            "x y z rgb normal_x normal_y normal_z label",
            "8 8 8 4 4 4 4 2",
            "F F F F F F F U",
            "ascii",
            width=4,
            height=3,
        )
        + text([(*p, 4.2e-38, 0, 0, 1, 65535) for p in POINTS]),
        "ascii-array": pcd_header(
            "x y z hist _", "4 4 4 4 1", "F F F F U", "ascii", "1 1 1 3 2", "1 2 3 0 1 0 0"
        )
        + text([(*p, 1, 2, 3, 0, 0) for p in POINTS]),
        "binary": pcd_header("x y z", "4 4 4", "F F F", "binary") + binary,
        "binary-fields": pcd_header(
            "x y z rgba ring v w", "8 8 8 4 1 2 4", "F F F U U I F", "binary", "1 1 1 1 1 3 1"
        )
        + mixed,
        "compressed": pcd_header("x y z w", "4 4 4 4", "F F F F", "binary_compressed")
        + struct.pack("<II", len(packed), len(columns))
        + packed,
    }


def ply_header(form: str, *lines: str) -> bytes:
    return "\n".join(
        ["ply", f"format {form} 1.0", "comment made for a test", *lines, "end_header", ""]
    ).encode()


def ply() -> dict[str, bytes]:
    vertex = ["element vertex 12", *(f"property float {axis}" for axis in "xyz")]
    color = [f"property uchar {name}" for name in ("red", "green", "blue", "alpha")]
    face = ["element face 2", "property list uchar int vertex_indices"]
    camera = [
        "element camera 1",
        *(f"property float view_p{a}" for a in "xyz"),
        *(f"property float {a}_axis{b}" for a in "xyz" for b in "xyz"),
    ]
    pose = (1, 2, 3, 1, 0, 0, 0, 1, 0, 0, 0, 1)
    grid = ["element range_grid 12", "property list uchar int vertex_indices"]
    seeds = {
        "ascii": ply_header("ascii", *vertex) + text(POINTS),
        "ascii-all": ply_header("ascii", *vertex, *color, *face, *camera)
        + text([(*p, 1, 2, 3, 255) for p in POINTS])
        + b"3 0 1 2\n4 0 1 2 3\n"
        + text([pose]),
        "ascii-grid": ply_header(
            "ascii", "obj_info num_cols 4", "obj_info num_rows 3", *vertex, *grid
        )
        + text(POINTS)
        + b"".join(b"1 %d\n" % i for i in range(12)),
    }
    for order, form in (("<", "binary_little_endian"), (">", "binary_big_endian")):
        plain = b"".join(struct.pack(order + "3f", *p) for p in POINTS)
        colored = b"".join(struct.pack(order + "3f4B", *p, 1, 2, 3, 255) for p in POINTS)
        faces = struct.pack(order + "B3iB4i", 3, 0, 1, 2, 4, 0, 1, 2, 3)
        seeds[form] = ply_header(form, *vertex) + plain
        seeds[form + "-all"] = (
            ply_header(form, *camera, *vertex, *color, *face)
            + struct.pack(order + "12f", *pose)
            + colored
            + faces
        )
    doubles = [line.replace("float", "double") for line in vertex]
    seeds["doubles"] = ply_header(
        "binary_little_endian", *doubles, "property short intensity"
    ) + b"".join(struct.pack("<3dh", *p, 5) for p in POINTS)
    return seeds


def obj() -> dict[str, bytes]:
    vertices = b"".join(b"v %g %g %g\n" % p for p in POINTS)
    normals = b"vn 0 0 1\n" * 12
    return {
        "plain": vertices,
        "normals": b"# made for a test\nmtllib none.mtl\n"
        + vertices
        + normals
        + b"g part\nusemtl none\ns off\nvt 0 1\nf 1//1 2//2 3//3\nf 1 2 3 4\nl 1 2\n",
        "colors": b"".join(b"v %g %g %g 0.5 0.5 1\n" % p for p in POINTS),
    }


FACES = [(i, i + 1, i + 2) for i in range(10)]


def off() -> dict[str, bytes]:
    vertices = b"".join(b"%g %g %g\n" % p for p in POINTS)
    colored = b"".join(b"%g %g %g 255 0 0 255\n" % p for p in POINTS)
    faces = b"".join(b"3 %d %d %d\n" % face for face in FACES)
    return {
        "plain": b"OFF\n# made for a test\n12 10 0\n" + vertices + faces,
        "colors": b"COFF 12 1 0\n" + colored + b"4 0 1 2 3 0.5 0.5 0.5\n",
        "no-faces": b"OFF\n12 0 0\n" + vertices,
    }


def stl() -> dict[str, bytes]:
    text, binary = b"", b""
    for face in FACES:
        corners = b"".join(b"  vertex %g %g %g\n" % POINTS[i] for i in face)
        text += b"facet normal 0 0 1\n outer loop\n" + corners + b" endloop\nendfacet\n"
        binary += struct.pack("<12fH", 0, 0, 1, *(v for i in face for v in POINTS[i]), 0)
    return {
        "ascii": b"solid part\n" + text + b"endsolid part\n",
        "binary": b"made for a test".ljust(80) + struct.pack("<I", len(FACES)) + binary,
    }


def tables() -> dict[str, bytes]:
    plain = text(POINTS)
    return {
        "blanks": b"# made for a test\n" + plain,
        "commas": b"x,y,z,nx,Intensity\n" + b"".join(b"%g,%g,%g,1,\n" % p for p in POINTS),
        "semicolons": b'"Y";"X";"Z"\r\n' + b"".join(b"%g;%g;%g\r\n" % p for p in POINTS),
        "counted": b"5\n" + text(POINTS[:5]) + b"7\n" + text(POINTS[5:]),
        "unnamed": text([(*p, 1, 2) for p in POINTS]),
    }


def npy() -> dict[str, bytes]:
    def whole(kind: str, version: int) -> bytes:
        header = f"{{'descr': '<{kind}', 'fortran_order': False, 'shape': (12, 3), }}\n".encode()
        size = struct.pack("<H" if version == 1 else "<I", len(header))
        code = "<3f" if kind == "f4" else "<3d"
        rows = b"".join(struct.pack(code, *p) for p in POINTS)
        return b"\x93NUMPY" + bytes([version, 0]) + size + header + rows

    return {"floats": whole("f4", 1), "doubles": whole("f8", 2)}


def matrix() -> dict[str, bytes]:
    return {
        "identity": b"1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n",
        "rotation": b"# degrees: 90\n0 -1 0 1e3\n1 0 0 -2.5\n\n0 0 1 +0.125\r\n0 0 0 1",
    }


def main() -> None:
    files = {
        "settings": calls(),
        "cloud": calls(),
        "residuals": calls(),
        "registration": calls(),
        "pcd": pcd(),
        "ply": ply(),
        "obj": obj(),
        "off": off(),
        "stl": stl(),
        "text": tables(),
        "npy": npy(),
        "matrix": matrix(),
    }
    for target, seeds in files.items():
        folder = Path(sys.argv[1]) / target
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in seeds.items():
            (folder / name).write_bytes(content)


if __name__ == "__main__":
    main()
