"""Tiny archives in the format of each public set, made of one surface whose true poses are known.

Every scan has points of the surface, moved by the inverse of a pose that maps it back: the poses
are drawn here and written in the set's own way.
"""

import tarfile
import zipfile

import numpy as np
from emtr_bench.layout import write_ply
from scipy.spatial.transform import Rotation

POINTS = 700


def surface(seed=0):
    """(POINTS, 3) of a bumpy ball, in float32 numbers."""
    rng = np.random.default_rng(seed)
    away = rng.normal(size=(POINTS, 3))
    away /= np.linalg.norm(away, axis=1, keepdims=True)
    return ((1 + 0.3 * np.sin(4 * away[:, :1]) * away[:, 1:2]) * away).astype(np.float32)


def poses(count, seed=1):
    """Rigid matrices (4, 4) that map a scan into the common frame."""
    rng = np.random.default_rng(seed)
    made = []
    for index in range(count):
        T = np.eye(4)
        T[:3, :3] = Rotation.random(random_state=seed + index).as_matrix()
        T[:3, 3] = rng.uniform(-3, 3, 3)
        made.append(T)
    return made


def scan(pose, seed=0):
    """The surface in the frame of a scan with this pose."""
    return (surface(seed) - pose[:3, 3]) @ pose[:3, :3]


def rows(T, digits=10):
    return "".join(" ".join(f"{value:.{digits}g}" for value in row) + "\n" for row in T)


def zipped(folder, archive):
    with zipfile.ZipFile(archive, "w") as opened:
        for path in sorted(folder.rglob("*")):
            if path.is_file():
                opened.write(path, path.relative_to(folder))
    return archive


def tarred(folder, archive):
    with tarfile.open(archive, "w:gz") as opened:
        opened.add(folder, ".")
    return archive


def stanford(folder):
    """bunny/data with a .conf, whose quaternions are of the inverse rotations."""
    place = folder / "bunny" / "data"
    place.mkdir(parents=True)
    lines = ["camera -0.01 -0.02 -0.07 -0.01 0.2 0.09 0.9", "mesh bun_zipper.ply 0 0 0 0 0 0 1"]
    for name, pose in zip(("bun000", "bun045", "chin"), poses(3)):
        write_ply(place / f"{name}.ply", scan(pose))
        x, y, z, w = Rotation.from_matrix(pose[:3, :3].T).as_quat()
        numbers = [*pose[:3, 3], x, y, z, w]
        lines.append(f"bmesh {name}.ply " + " ".join(f"{value:.8g}" for value in numbers))
    (place / "bun.conf").write_text("\n".join(lines) + "\n")
    return 3


def fgr(folder):
    """Two folders with two views each; the log's matrix maps the second view into the first."""
    for number, name in enumerate(("pairwise_no_noise_01_rot_05",
                                   "pairwise_noise_xyz_level_02_18_rot_05")):  # fmt: skip
        place = folder / "dataset" / name
        place.mkdir(parents=True)
        first, second = poses(2, seed=5 + number)
        write_ply(place / "Depth_0000.ply", scan(first))
        write_ply(place / "Depth_0001.ply", scan(second))
        (place / "gt.log").write_text("0 1 2\n" + rows(np.linalg.inv(first) @ second))
    return 2


def threedmatch(folder):
    """A scene with three fragments, the poses of two pairs beside it, and one of another list."""
    scene = folder / "7-scenes-redkitchen"
    scene.mkdir(parents=True)
    made = poses(12, seed=9)
    for number in (0, 4, 11):
        write_ply(scene / f"cloud_bin_{number}.ply", scan(made[number]))

    def log(place, *both):
        place.mkdir(parents=True)
        text = ""
        for i, j in both:
            text += f"{i}\t {j}\t 60\n" + rows(np.linalg.inv(made[i]) @ made[j], 8)
        (place / "gt.log").write_text(text)
        (place / "gt.info").write_text("0 4 60\n")

    log(folder / "7-scenes-redkitchen-evaluation", (0, 4), (0, 11))
    log(folder / "3DLoMatch" / "7-scenes-redkitchen", (4, 11))
    return 3


def uwa(folder):
    """Two models, a scene with both in it, and a matrix that maps each into the scene."""
    for name in ("models", "scenes", "GroundTruth"):
        (folder / name).mkdir(parents=True)
    placed = {"cheff": ("chef", poses(1, 3)[0], 1), "T-rex_high": ("T-rex", poses(1, 4)[0], 2)}
    parts = []
    for file, (name, pose, seed) in placed.items():
        model = scan(pose, seed)
        write_ply(folder / "models" / f"{file}.ply", model)
        parts.append(model @ pose[:3, :3].T + pose[:3, 3])
        (folder / "GroundTruth" / f"{name}-rs1.xf").write_text(rows(pose, 6))
    write_ply(folder / "scenes" / "rs1.ply", np.concatenate(parts))
    (folder / "GroundTruth" / "rhino-rs1.xf").write_text(rows(np.eye(4)))
    return 2


def resso(folder):
    """Three scans and one list of their poses in a common frame."""
    place = folder / "office"
    place.mkdir(parents=True)
    text = "3\n"
    for number, pose in enumerate(poses(3, seed=20)):
        write_ply(place / f"scan_{number}.ply", scan(pose))
        text += f"scan_{number}.ply\n" + rows(pose)
    (place / "groundtruth.txt").write_text(text)
    (place / "README.txt").write_text("3 scans of an office\nscan_0.ply and others\n")
    return 3


def modelnet(folder):
    """A wedge in two categories; the counts are in the first line of one, as in some files."""
    corners = "0 0 0\n4 0 0\n4 1 0\n0 1 0\n0 0 2\n0 1 2\n"
    faces = "4 0 3 2 1\n4 0 4 5 3\n3 0 1 4\n3 3 5 2\n4 1 2 5 4\n"
    for category, head in (("night_stand", "OFF\n6 5 0\n"), ("sofa", "OFF6 5 0\n")):
        for part, number in (("train", 1), ("test", 201), ("test", 202)):
            place = folder / "ModelNet10" / category / part
            place.mkdir(parents=True, exist_ok=True)
            (place / f"{category}_{number:04}.off").write_text(head + corners + faces)
    return 2


SETS = {function.__name__: function
        for function in (stanford, fgr, threedmatch, uwa, resso, modelnet)}  # fmt: skip
