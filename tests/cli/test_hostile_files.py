"""A table of bad and odd files, under a limit of memory: refused in one line, or read as meant."""

from __future__ import annotations

import json
import os
import re
import resource
import struct
from collections.abc import Callable

import cloud_files
import conftest
import numpy as np
import pytest

COUNT = 240
POINTS = conftest.surface(COUNT, 3).astype("f4")
ROWS = cloud_files.table(POINTS)
PCD = cloud_files.pcd_header(ROWS, "binary")
BODY = ROWS.tobytes()
MEMORY = 2 << 30


def limited() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def pcd(old: str = "", new: str = "", body: bytes = BODY) -> bytes:
    assert old in PCD
    return PCD.replace(old, new, 1).encode() + body


def ply(old: str = "", new: str = "", data: str = "binary", body: bytes = b"") -> bytes:
    fields = "".join(f"property float {name}\n" for name in "xyz")
    kind = cloud_files.PLY_FORMATS[data]
    head = f"ply\nformat {kind} 1.0\nelement vertex {COUNT}\n{fields}end_header\n"
    assert old in head
    text = cloud_files.text_rows(ROWS).encode()
    return head.replace(old, new, 1).encode() + (body or (text if data == "ascii" else BODY))


def compressed(packed: int | None = None, unpacked: int | None = None) -> bytes:
    planes = b"".join(ROWS[name].tobytes() for name in "xyz")
    stream = cloud_files.lzf_literals(planes)
    sizes = (
        len(stream) if packed is None else packed,
        len(planes) if unpacked is None else unpacked,
    )
    return cloud_files.pcd_header(ROWS, "binary_compressed").encode() + struct.pack(
        "<II", *sizes
    ) + stream  # fmt: skip


def cut(content: bytes, line: int) -> bytes:
    return b"".join(content.splitlines(keepends=True)[:line])


BAD: dict[str, tuple[str, Callable[[], bytes], str]] = {
    **{
        f"pcd, cut after header line {line}": (
            ".pcd",
            lambda line=line: cut(PCD.encode(), line),
            "truncated|has no|not a PCD|no line|no [A-Z]+",
        )
        for line in range(1, PCD.count("\n") + 1)
    },
    **{
        f"ply, cut after header line {line}": (
            ".ply",
            lambda line=line: cut(ply(), line),
            "truncated|has no|not a PLY|no line|holds no points|no vertex",
        )
        for line in range(1, 8)
    },
    "pcd, WIDTH is NaN": (".pcd", lambda: pcd(f"WIDTH {COUNT}", "WIDTH nan"), "WIDTH 'nan'"),
    "pcd, HEIGHT is 1e9": (".pcd", lambda: pcd("HEIGHT 1", "HEIGHT 1e9"), "HEIGHT '1e9'"),
    "pcd, POINTS is infinite": (".pcd", lambda: pcd(f"POINTS {COUNT}", "POINTS inf"), "POINTS"),
    "pcd, VIEWPOINT is text": (".pcd", lambda: pcd("0 0 0 1 0 0 0", "a b c d e f g"), "VIEWPOINT"),
    "pcd, no WIDTH": (".pcd", lambda: pcd(f"WIDTH {COUNT}\n", ""), "WIDTH"),
    "pcd, no DATA": (".pcd", lambda: pcd("DATA binary\n", ""), "DATA|unknown line|line"),
    "pcd, x twice": (".pcd", lambda: pcd("FIELDS x y z", "FIELDS x x z"), "field 'x'|'y'"),
    "pcd, y missing": (".pcd", lambda: pcd("FIELDS x y z", "FIELDS x u z"), "no field 'y'"),
    "pcd, no fields at all": (
        ".pcd",
        lambda: re.sub(r"(FIELDS|SIZE|TYPE|COUNT) .*", r"\1", PCD).encode() + BODY,
        "FIELDS|SIZE",
    ),
    "pcd, integers": (".pcd", lambda: pcd("TYPE F F F", "TYPE I I I"), "all float or all double"),
    "pcd, x of 3 numbers": (".pcd", lambda: pcd("COUNT 1 1 1", "COUNT 3 1 1"), "x|truncated"),
    "pcd, 2^31 points": (
        ".pcd",
        lambda: PCD.replace(f" {COUNT}\n", f" {2**31}\n").encode() + BODY,
        "truncated|WIDTH|more than",
    ),
    "pcd, WIDTH x HEIGHT beyond 2^64": (
        ".pcd",
        lambda: pcd("HEIGHT 1", f"HEIGHT {2**62}"),
        "HEIGHT|POINTS|WIDTH",
    ),
    "pcd, body one byte short": (".pcd", lambda: pcd(body=BODY[:-1]), "truncated"),
    "pcd, compressed size of nothing": (".pcd", lambda: compressed(packed=0), "compress|trunc|dam"),
    "pcd, compressed size beyond the file": (
        ".pcd", lambda: compressed(packed=2**32 - 1), "truncated|compressed"),
    "pcd, compressed size too small": (".pcd", lambda: compressed(packed=40), "cannot be|dam|more"),
    "pcd, unpacked size of nothing": (".pcd", lambda: compressed(unpacked=0), "unpacks to 0 bytes"),
    "pcd, unpacked size of 4 GB": (
        ".pcd", lambda: compressed(unpacked=2**32 - 1), "unpacks to 4294967295 bytes"),
    "ply, count is NaN": (".ply", lambda: ply(f"vertex {COUNT}", "vertex nan"), "count"),
    "ply, count is negative": (".ply", lambda: ply(f"vertex {COUNT}", "vertex -5"), "count"),
    "ply, huge count": (".ply", lambda: ply(f"vertex {COUNT}", f"vertex {2**40}"), "trunc|count"),
    "ply, x twice": (".ply", lambda: ply("float y", "float x"), "property 'x' twice"),
    "ply, z missing": (".ply", lambda: ply("property float z\n", ""), "no field 'z'"),
    "ply, two elements vertex": (
        ".ply",
        lambda: ply("end_header", "element vertex 3\nproperty float x\nend_header"),
        "vertex|truncated",
    ),
    "ply, coordinates in lists": (
        ".ply", lambda: ply("property float x", "property list uchar float x"), "list"),
    "ply, integers": (".ply", lambda: ply("property float x", "property int x"), "all float"),
    "ply, no format": (".ply", lambda: ply("format binary_little_endian 1.0\n", ""), "format"),
    "ply, body one byte short": (".ply", lambda: ply(body=BODY[:-1]), "truncated"),
    "obj, a NaN too few": (".obj", lambda: b"v 1 2\n" * 20, "coordinates"),
    "only zero bytes": (".pcd", lambda: bytes(4096), "not a PCD|unknown line"),
    "a long line without end": (".ply", lambda: b"ply" * 300000, "not a PLY"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_refused_in_one_line(refused, tmp_path, name):
    extension, make, pattern = BAD[name]
    cloud_files.write_pcd(tmp_path / "good.pcd", POINTS)
    (tmp_path / f"bad{extension}").write_bytes(make())
    for clouds in ([f"bad{extension}", "good.pcd"], ["good.pcd", f"bad{extension}"]):
        message = refused(2, *clouds, "-o", "T.txt", "--report", "r.json", preexec_fn=limited)
        assert f"'bad{extension}': " in message
        assert re.search(pattern, message), message


@pytest.mark.parametrize(
    ("place", "pattern"), [("/dev/null", "is empty"), ("/dev/zero", "does not begin like a .pcd")]
)
def test_devices_by_another_name(refused, tmp_path, place, pattern):
    cloud_files.write_pcd(tmp_path / "good.pcd", POINTS)
    (tmp_path / "device.pcd").symlink_to(place)
    message = refused(2, "device.pcd", "good.pcd", "-o", "T.txt", preexec_fn=limited)
    assert "'device.pcd': " in message and pattern in message


ODD: dict[str, tuple[str, Callable[[], bytes]]] = {
    "pcd, DOS line ends": (
        ".pcd",
        lambda: (
            (cloud_files.pcd_header(ROWS, "ascii") + cloud_files.text_rows(ROWS))
            .replace("\n", "\r\n")
            .encode()
        ),
    ),
    "ply, DOS line ends": (".ply", lambda: ply(data="ascii").replace(b"\n", b"\r\n")),
    "ply, big-endian": (
        ".ply",
        lambda: ply(data="big", body=ROWS.astype(ROWS.dtype.newbyteorder(">")).tobytes()),
    ),
    "ply, faces behind": (
        ".ply",
        lambda: ply(
            "end_header",
            "element face 1\nproperty list uchar int vertex_indices\nend_header",
            body=BODY + b"\x03" + struct.pack("<3i", 0, 1, 2),
        ),
    ),
    "pcd, more behind the points": (".pcd", lambda: pcd(body=BODY + bytes(100))),
    "pcd, doubles": (
        ".pcd",
        lambda: (
            cloud_files.pcd_header(cloud_files.table(POINTS, "f8"), "binary").encode()
            + cloud_files.table(POINTS, "f8").tobytes()
        ),
    ),
}


@pytest.mark.parametrize("name", ODD)
def test_odd_files_are_read_as_meant(run, tmp_path, name):
    """The same points in a plain file give the same matrix; or it is refused, and named."""
    extension, make = ODD[name]
    cloud_files.write_pcd(tmp_path / "plain.pcd", POINTS)
    cloud_files.write_pcd(tmp_path / "b.pcd", conftest.surface(COUNT, 4))
    (tmp_path / f"odd{extension}").write_bytes(make())
    wanted = run("plain.pcd", "b.pcd", *conftest.QUICK, preexec_fn=limited)
    assert wanted.returncode in (0, 3), wanted.stderr
    done = run(f"odd{extension}", "b.pcd", *conftest.QUICK, preexec_fn=limited)
    if done.returncode == 2:
        assert f"pcl_emtr: error: 'odd{extension}': " in done.stderr and not done.stdout
        pytest.skip(done.stderr.splitlines()[-1])
    assert (done.returncode, done.stdout) == (wanted.returncode, wanted.stdout)


def test_names_that_are_no_utf8(run, tmp_path):
    names = [os.fsdecode(name) for name in (b"\xff\xfe.pcd", b"caf\xe9.pcd")]
    for name, seed in zip(names, (3, 4)):
        cloud_files.write_pcd(tmp_path / name, conftest.surface(COUNT, seed))
    done = run(*names, *conftest.QUICK, "-o", "T.txt", "--report", "r.json", errors="replace")
    assert done.returncode in (0, 3), done.stderr
    assert np.loadtxt(tmp_path / "T.txt").shape == (4, 4)
    json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))
