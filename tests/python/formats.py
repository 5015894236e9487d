"""Writers of one small cloud or mesh in each format that is read."""

from __future__ import annotations

import gzip
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

Mesh = tuple[np.ndarray, np.ndarray]
_MESHES = (".obj", ".off", ".stl", ".ply")


def relief(cells: int = 20) -> Mesh:
    """A bumpy sheet: vertices (cells**2, 3) float64 with the digits of float32, faces (F, 3)."""
    x, y = (axis.ravel() for axis in np.meshgrid(*[np.linspace(-1, 1, cells)] * 2, indexing="ij"))
    z = 0.35 * np.sin(3 * x + 1) * np.cos(2.5 * y) + 0.25 * np.exp(-8 * ((x - 0.4) ** 2 + y**2))
    at = np.arange(cells * cells).reshape(cells, cells)
    a, b, c, d = (part.ravel() for part in (at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]))
    faces = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    return np.column_stack([x, y, z]).astype("f4").astype(float), faces


def is_mesh(path: Path) -> bool:
    return path.with_suffix("").suffix in _MESHES or path.suffix in _MESHES


def write(path: Path, mesh: Mesh) -> Path:
    """Writes the mesh, or its vertices where the format has no faces; skips where the package that
    reads the format is not installed."""
    ending = "".join(path.suffixes[-2:]) if path.suffix == ".gz" else path.suffix
    WRITERS[ending](path, mesh)
    return path


def _rows(array: np.ndarray, between: str = " ") -> str:
    return "".join(between.join(map(repr, row)) + "\n" for row in array.tolist())


def _obj(path: Path, mesh: Mesh) -> None:
    vertices = "".join(f"v {row}\n" for row in _rows(mesh[0]).splitlines())
    path.write_text(vertices + "".join(f"f {row}\n" for row in _rows(mesh[1] + 1).splitlines()))


def _off(path: Path, mesh: Mesh) -> None:
    faces = "".join(f"3 {row}\n" for row in _rows(mesh[1]).splitlines())
    path.write_text(f"OFF\n{len(mesh[0])} {len(mesh[1])} 0\n" + _rows(mesh[0]) + faces)


def _stl(path: Path, mesh: Mesh) -> None:
    layout = [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")]
    rows = np.zeros(len(mesh[1]), layout)
    rows["corners"] = mesh[0][mesh[1]]
    path.write_bytes(bytes(80) + len(rows).to_bytes(4, "little") + rows.tobytes())


def _ply(path: Path, mesh: Mesh) -> None:
    pytest.importorskip("plyfile", reason="pip install 'pyemtr[files]'")
    head = f"ply\nformat ascii 1.0\nelement vertex {len(mesh[0])}\n"
    head += "".join(f"property double {axis}\n" for axis in "xyz")
    head += f"element face {len(mesh[1])}\nproperty list uchar int vertex_indices\nend_header\n"
    path.write_text(
        head + _rows(mesh[0]) + "".join(f"3 {r}\n" for r in _rows(mesh[1]).splitlines())
    )


def _pcd(path: Path, mesh: Mesh) -> None:
    pytest.importorskip("pypcd4", reason="pip install 'pyemtr[files]'")
    count = len(mesh[0])
    path.write_text(
        "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\n"
        f"WIDTH {count}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {count}\nDATA ascii\n"
        + _rows(mesh[0])
    )


def _las(path: Path, mesh: Mesh) -> None:
    laspy = pytest.importorskip("laspy", reason="pip install 'pyemtr[files]'")
    if path.suffix == ".laz":
        pytest.importorskip("lazrs", reason="pip install 'pyemtr[files]'")
    header = laspy.LasHeader(point_format=0, version="1.2")
    header.scales = [1e-6] * 3
    las = laspy.LasData(header)
    las.x, las.y, las.z = mesh[0].T
    las.write(path)


def _e57(path: Path, mesh: Mesh) -> None:
    pye57 = pytest.importorskip("pye57", reason="pip install 'pyemtr[e57]'")
    file = pye57.E57(str(path), mode="w")
    scan = {f"cartesian{axis}": mesh[0][:, i].copy() for i, axis in enumerate("XYZ")}
    file.write_scan_raw(scan, rotation=np.array([1.0, 0, 0, 0]), translation=np.zeros(3))
    file.close()


def _packed(write_plain: Callable[[Path, Mesh], None]) -> Callable[[Path, Mesh], None]:
    def packed(path: Path, mesh: Mesh) -> None:
        plain = path.with_suffix("")
        write_plain(plain, mesh)
        path.write_bytes(gzip.compress(plain.read_bytes()))
        plain.unlink()

    return packed


def _text(head: str = "", between: str = " ") -> Callable[[Path, Mesh], None]:
    def text(path: Path, mesh: Mesh) -> None:
        path.write_text(head.replace("COUNT", str(len(mesh[0]))) + _rows(mesh[0], between))

    return text


WRITERS: dict[str, Callable[[Path, Mesh], None]] = {
    ".asc": _text("% made by a test\n"),
    ".csv": _text("x,y,z\n", ","),
    ".e57": _e57,
    ".las": _las,
    ".laz": _las,
    ".npy": lambda path, mesh: np.save(path, mesh[0]),
    ".npz": lambda path, mesh: np.savez(path, points=mesh[0]),
    ".obj": _obj,
    ".off": _off,
    ".pcd": _pcd,
    ".ply": _ply,
    ".pts": _text("COUNT\n"),
    ".stl": _stl,
    ".txt": _text("# x y z\n"),
    ".xyz": _text(),
}
WRITERS.update({f"{name}.gz": _packed(WRITERS[name]) for name in (".ply", ".stl", ".xyz", ".las")})
