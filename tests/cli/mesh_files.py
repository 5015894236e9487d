"""Small writers of meshes, and a mesh whose surface is known."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np

Mesh = tuple[np.ndarray, np.ndarray]


def relief(cells: int = 40) -> Mesh:
    """A bumpy sheet: vertices (N, 3), and faces (M, 3) whose sizes differ."""
    ticks = np.sign(np.linspace(-1, 1, cells)) * np.linspace(-1, 1, cells) ** 2
    x, y = (grid.ravel() for grid in np.meshgrid(ticks, ticks, indexing="ij"))
    z = 0.35 * np.sin(3 * x + 1) * np.cos(2.5 * y) + 0.2 * x * x * y
    z += 0.25 * np.exp(-8 * ((x - 0.4) ** 2 + y**2))
    corner = (np.arange(cells - 1)[:, None] * cells + np.arange(cells - 1)).ravel()
    one = np.column_stack([corner, corner + cells, corner + cells + 1])
    other = np.column_stack([corner, corner + cells + 1, corner + 1])
    return np.column_stack([x, y, z]).astype("f4").astype(float), np.vstack([one, other])


def square() -> Mesh:
    """The unit square in z = 0 by two triangles of areas 1/8 and 7/8, as far as faces go."""
    vertices = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.25, 0, 0]], float)
    return vertices, np.array([[0, 4, 3], [4, 1, 2], [4, 2, 3]])


def write_ply(path: Path, mesh: Mesh, data: str = "binary") -> Path:
    vertices, faces = mesh
    kind = {"ascii": "ascii", "binary": "binary_little_endian", "big": "binary_big_endian"}[data]
    lines = [f"ply\nformat {kind} 1.0\nelement vertex {len(vertices)}"]
    lines += [f"property float {axis}" for axis in "xyz"]
    lines += [f"element face {len(faces)}", "property uchar part"]
    lines += ["property list uchar int vertex_indices", "end_header\n"]
    if data == "ascii":
        body = "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in vertices.tolist())
        body += "".join(f"7 {len(f)} {' '.join(map(str, f))}\n" for f in faces.tolist())
        path.write_text("\n".join(lines) + body)
        return path
    order = ">" if data == "big" else "<"
    body = vertices.astype(order + "f4").tobytes()
    for face in faces.tolist():
        body += struct.pack(f"{order}BB{len(face)}i", 7, len(face), *face)
    path.write_bytes("\n".join(lines).encode() + body)
    return path


def write_obj(path: Path, mesh: Mesh, from_last: bool = False) -> Path:
    vertices, faces = mesh
    text = "mtllib none.mtl\n" + "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices.tolist())
    text += "vt 0 1\nvn 0 0 1\ng part\nusemtl none\n"
    rows = faces - len(vertices) if from_last else faces + 1
    text += "".join("f " + " ".join(f"{i}/1/1" for i in face) + "\n" for face in rows.tolist())
    path.write_text(text)
    return path


def write_off(path: Path, mesh: Mesh) -> Path:
    vertices, faces = mesh
    text = f"OFF\n# made by a test\n{len(vertices)} {len(faces)} 0\n"
    text += "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in vertices.tolist())
    text += "".join(f"{len(f)} {' '.join(map(str, f))} 255 0 0\n" for f in faces.tolist())
    path.write_text(text)
    return path


def write_stl(path: Path, mesh: Mesh, data: str = "binary") -> Path:
    vertices, faces = mesh
    if data == "ascii":
        text = "solid made by a test\n"
        for face in faces:
            corners = "".join(
                f"  vertex {x!r} {y!r} {z!r}\n" for x, y, z in vertices[face].tolist()
            )
            text += f"facet normal 0 0 0\n outer loop\n{corners} endloop\nendfacet\n"
        path.write_text(text + "endsolid made by a test\n")
        return path
    rows = np.zeros(len(faces), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
    rows["corners"] = vertices[faces]
    path.write_bytes(b"solid, but binary".ljust(80) + struct.pack("<I", len(rows)) + rows.tobytes())
    return path


def read_ply(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces as pcl_emtr writes them: triangles, before the camera."""
    raw = path.read_bytes()
    end = raw.index(b"end_header\n") + 11
    header = raw[:end].decode()
    kinds = {"float": "<f4", "double": "<f8"}
    layout, count, camera, element = [], {}, 0, ""
    for words in (line.split() for line in header.splitlines()):
        if words[0] == "element":
            element, count[words[1]] = words[1], int(words[2])
        elif words[0] == "property" and element == "vertex":
            layout.append((words[2], kinds[words[1]]))
        elif words[0] == "property" and element == "camera":
            camera += 4
    assert list(count) == ["vertex", "face", "camera"]
    vertices = np.frombuffer(raw, layout, count["vertex"], end)
    faces = np.frombuffer(
        raw, [("n", "u1"), ("corners", "<i4", 3)], count["face"], end + vertices.nbytes
    )
    assert end + vertices.nbytes + camera + faces.nbytes == len(raw)
    assert (faces["n"] == 3).all()
    return vertices, faces["corners"]


def read_obj(path: Path) -> tuple[np.ndarray, np.ndarray]:
    lines = [line.split() for line in path.read_text().splitlines()]
    vertices = [[float(word) for word in words[1:4]] for words in lines if words[:1] == ["v"]]
    faces = [[int(w.split("/")[0]) - 1 for w in ws[1:]] for ws in lines if ws[:1] == ["f"]]
    return np.array(vertices), np.array(faces)
