"""tools/bench/convert: from tiny archives in each set's format to pairs whose poses are true."""

import csv
import subprocess
import sys
import tarfile
import zipfile

import archive_fakes
import numpy as np
import pytest
from accuracy_fakes import REPOSITORY
from emtr_bench import layout, pairs, protocol
from emtr_bench.convert import archives, fgr, logs, modelnet, resso, stanford
from emtr_bench.convert.arguments import SETS, parser
from emtr_bench.convert.program import convert
from emtr_bench.convert.shares import tier_of
from emtr_bench.pairs import DataError
from scipy.spatial import cKDTree

SCRIPT = REPOSITORY / "tools" / "bench" / "convert"


def run(*words):
    return convert(parser().parse_args([str(word) for word in words]))


def check_poses(folder, count, exact=True):
    """Under T_gt each source point is on one of the target's, and under its inverse it is not."""
    found = layout.read_folder(folder)
    assert len(found) == count
    for pair in found:
        clouds = pairs.load(pair)
        tree = cKDTree(clouds.target)
        moved = tree.query(protocol.apply(clouds.T_gt, clouds.source))[0]
        back = tree.query(protocol.apply(np.linalg.inv(clouds.T_gt), clouds.source))[0]
        if exact:
            assert moved.max() < 1e-4, pair.name
        assert np.median(moved) < 0.3 * np.median(back), pair.name
    return {pair.name: pair for pair in found}


def test_every_set_has_a_fake():
    assert set(archive_fakes.SETS) == set(SETS)


@pytest.mark.parametrize("name", SETS)
@pytest.mark.parametrize("form", ["folder", "zip", "tar"])
def test_the_poses_of_each_set_map_source_into_target(name, form, tmp_path, capsys):
    raw = tmp_path / "downloads"
    raw.mkdir()
    place = raw if form == "folder" else tmp_path / "raw"
    count = archive_fakes.SETS[name](place)
    if form == "zip":
        archive_fakes.zipped(place, raw / "set.zip")
    if form == "tar":
        archive_fakes.tarred(place, raw / "set.tar.gz")
    assert run(raw, tmp_path / "made") == 0
    found = check_poses(tmp_path / "made", count, exact=name != "modelnet")
    assert {pair.group for pair in found.values()} == {name}
    printed = capsys.readouterr().out
    assert f"wrote {count} pairs" in printed and ("unpacking" in printed) == (form != "folder")


def test_names_and_tiers(tmp_path, capsys):
    for name, make in archive_fakes.SETS.items():
        make(tmp_path / "raw" / name)
        archive_fakes.zipped(tmp_path / "raw" / name, tmp_path / f"{name}.zip")
    assert run(tmp_path, tmp_path.parent / "made_all") == 0
    found = {p.name: p.tier for p in layout.read_folder(tmp_path.parent / "made_all")}
    assert found == {
        "bun_bun045_bun000": "standard", "bun_chin_bun000": "standard",
        "bun_chin_bun045": "standard", "fgr_n0_01": "standard", "fgr_n2_18": "standard",
        "7-scenes-redkitchen_4_0": "standard", "7-scenes-redkitchen_11_0": "standard",
        "7-scenes-redkitchen_lo_11_4": "standard", "chef_rs1": "clutter", "trex_rs1": "clutter",
        "office_scan_1_scan_0": "standard", "office_scan_2_scan_0": "standard",
        "office_scan_2_scan_1": "standard", "night_stand_0201_crop": "cad",
        "sofa_0201_crop": "cad",
    }  # fmt: skip
    printed = capsys.readouterr().out
    assert "left out: rhino-rs1.xf: no cloud of the model rhino" in printed
    assert "bun.conf names bun_zipper.ply, not there" in printed


def test_sets_are_added_to_a_folder_and_others_left_alone(tmp_path):
    for name in ("fgr", "uwa"):
        archive_fakes.SETS[name](tmp_path / "raw" / name)
    made = tmp_path / "made"
    assert run(tmp_path / "raw", made, "--set", "fgr") == 0
    assert {p.group for p in layout.read_folder(made)} == {"fgr"}
    lines = (made / "MANIFEST.csv").read_text().splitlines()
    (made / "MANIFEST.csv").write_text(
        "\n".join([f"{lines[0]},note", *(f"{line}," for line in lines[1:]),
                   "mine,duck,standard,1,1,,,a note of mine"])
    )  # fmt: skip
    assert run(tmp_path / "raw", made, "--set", "uwa") == 0
    assert run(tmp_path / "raw", made, "--set", "uwa") == 0  # once more changes nothing
    found = layout.read_folder(made)
    assert {p.group for p in found} == {"fgr", "uwa", "mine"} and len(found) == 5
    assert "mine,duck,standard,1,1,,,a note of mine\n" in (made / "MANIFEST.csv").read_text()
    with (made / "MANIFEST.csv").open(newline="") as file:
        (row,) = (row for row in csv.DictReader(file) if row["name"] == "chef_rs1")
    assert row["n_source"] == "700" and row["overlap_source"] == "1.000"


def test_scans_that_share_little_are_no_pair(tmp_path):
    archive_fakes.resso(tmp_path / "raw")
    place = tmp_path / "raw" / "office"
    cloud = pairs.read_ply(place / "scan_2.ply")
    layout.write_ply(place / "scan_2.ply", cloud + 50.0)
    assert run(tmp_path / "raw", tmp_path / "a") == 0
    assert [p.name for p in layout.read_folder(tmp_path / "a")] == ["office_scan_1_scan_0"]
    assert run(tmp_path / "raw", tmp_path / "b", "--least-overlap", "0") == 0
    assert len(layout.read_folder(tmp_path / "b")) == 3


@pytest.mark.parametrize(
    ("shares", "tier"),
    [((0.9, 0.45), "standard"), ((0.2, 0.9), "low-overlap"), ((0.5, 0.19), "extreme")],
)
def test_the_smaller_share_says_the_tier(shares, tier):
    assert tier_of(shares) == tier


def broken(folder, name, text):
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path


def test_a_pose_without_overlap_is_told(tmp_path, capsys):
    archive_fakes.fgr(tmp_path)
    log = tmp_path / "dataset" / "pairwise_no_noise_01_rot_05" / "gt.log"
    log.write_text("0 1 2\n1 0 0 90\n0 1 0 0\n0 0 1 0\n0 0 0 1\n")
    assert run(tmp_path, tmp_path / "made") == 0
    assert "fgr_n0_01: overlap 0% and 0%, tier extreme  (next to none" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("read", "name", "text", "message"),
    [
        (stanford.read_conf, "a.conf", "bmesh a.ply 0 0 0 1 2 3\n", "a.conf:1: expected bmesh"),
        (stanford.read_conf, "a.conf", "\nbmesh a.ply 0 0 0 0 0 0 one\n", "a.conf:2: expected"),
        (logs.read_log, "gt.log", "", "gt.log: expected blocks .*got 0 lines"),
        (logs.read_log, "gt.log", "0 1 2\n1 0 0 0\n", "got 2 lines"),
        (logs.read_log, "gt.log", "0 1 2\n" + 4 * "1 0 0\n", "got a matrix of shape"),
        (logs.read_log, "gt.log", "0 1 2\n" + 4 * "1 0 0 0\n", "expected a rigid matrix"),
        (logs.read_log, "gt.log", "0 x 2\n" + 4 * "1 0 0 0\n", "expected blocks"),
        (resso.read_poses, "p.txt", "2\na.ply\n" + 4 * "1 0 0 0\n", "expected 2 scans.*got 5"),
        (resso.read_poses, "p.txt", "1\na.ply\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n",
         "names a.ply, which is not beside it"),
        (modelnet.read_off, "a.off", "PLY\n", "a.off: expected a mesh in OFF"),
        (modelnet.read_off, "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "expected a"),
        (modelnet.read_off, "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "expected a mesh"),
        (modelnet.read_off, "a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "there is no face"),
    ],
)  # fmt: skip
def test_a_file_that_is_not_what_it_should_be_is_named(read, name, text, message, tmp_path):
    with pytest.raises(DataError, match=message):
        read(broken(tmp_path, name, text))


def test_a_quaternion_of_the_inverse_rotation_is_read(tmp_path):
    """A quarter rotation about z: qz > 0 takes x to y, so the pose takes x to -y."""
    path = broken(tmp_path, "a.conf", "bmesh a.ply 1 2 3 0 0 0.70710678 0.70710678\n")
    (scan,) = stanford.read_conf(path)
    np.testing.assert_allclose(scan.pose @ [1, 0, 0, 1], [1, 1, 3, 1], atol=1e-7)


def test_two_samples_have_the_pose_that_they_are_given():
    corners = np.array([[0, 0, 0], [4, 0, 0], [0, 1, 0], [0, 0, 2.0]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    source, target, T = modelnet.two_samples(corners, faces, 3)
    assert source.shape == target.shape == (716, 3)
    off = cKDTree(protocol.apply(T, source)).query(target)[0]
    assert np.median(off) < 0.05  # of a shape in the unit ball
    again = modelnet.two_samples(corners, faces, 3)
    np.testing.assert_array_equal(again[0], source)
    assert not np.array_equal(modelnet.two_samples(corners, faces, 4)[0], source)


def test_names_of_folders():
    assert fgr.name_of("pairwise_noise_xyz_level_02_18_rot_05") == "fgr_n2_18"
    assert fgr.name_of("mine") == "mine"


@pytest.mark.parametrize("kind", ["zip", "tar"])
def test_nothing_is_unpacked_outside_the_folder(kind, tmp_path):
    archive = tmp_path / f"bad.{kind}"
    content = tmp_path / "a.ply"
    content.write_text("x")
    names = (
        "../out.ply",
        "/out.ply",
        "in/../../out_too.ply",
        ".hidden/a.ply",
        "in/a.exe",
        "in/a.ply",
    )
    if kind == "zip":
        with zipfile.ZipFile(archive, "w") as opened:
            for name in names:
                opened.write(content, name)
    else:
        with tarfile.open(archive, "w") as opened:
            for name in names:
                opened.add(content, name)
            link = tarfile.TarInfo("in/link.ply")
            link.type, link.linkname = tarfile.SYMTYPE, "/etc/passwd"
            opened.addfile(link)
    inside = tmp_path / "deep" / "inside"
    archives.unpack(archive, inside)
    found = [p.relative_to(tmp_path / "deep").as_posix()
             for p in (tmp_path / "deep").rglob("*") if p.is_file()]  # fmt: skip
    # An absolute path in a tar file is stored without its slash; it stays inside then.
    assert set(found) - {"inside/out.ply"} == {"inside/in/a.ply"}
    assert not list(tmp_path.glob("out*"))


def test_the_command_tells_what_is_wrong_and_writes_nothing(tmp_path):
    def command(*words):
        words = [str(word) for word in words]
        done = subprocess.run([sys.executable, str(SCRIPT), *words], capture_output=True,
                              text=True, timeout=120, check=False)  # fmt: skip
        return done.returncode, done.stderr

    empty, made = tmp_path / "empty", tmp_path / "made"
    empty.mkdir()
    code, said = command(empty, made)
    assert code == 2 and said.startswith(f"convert: {empty} has nothing of stanford, fgr")
    code, said = command(tmp_path / "no", made)
    assert code == 2 and "no: no such folder" in said
    (empty / "cut.zip").write_bytes(b"PK\x03\x04 and no more")
    code, said = command(empty, made)
    assert code == 2 and "cut.zip: not a whole archive" in said
    code, said = command(tmp_path, empty)
    assert code == 2 and "empty: expected a new folder, or one with a MANIFEST.csv" in said
    assert not made.exists()
