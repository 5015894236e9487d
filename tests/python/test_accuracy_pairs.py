"""Reading the manifest and the pairs, and what is said of bad ones."""

import accuracy_fakes
import numpy as np
import pytest
from emtr_bench import pairs
from emtr_bench.pairs import DataError


@pytest.fixture
def data(tmp_path):
    return accuracy_fakes.write_data(tmp_path)


def test_pairs_come_in_the_order_of_the_tiers(data):
    manifest = pairs.read_manifest(data)
    assert [(p.name, p.tier, p.paper_row) for p in manifest] == [
        ("hare", "paper", "Bunny"),
        ("hall", "paper", "7a (stand-in)"),
        ("duck", "standard", ""),
    ]


def test_tiers_and_names_select(data):
    manifest = pairs.read_manifest(data)

    def chosen(tiers, names):
        return [p.name for p in pairs.select(manifest, tiers, names)]

    assert chosen(["paper"], []) == ["hare", "hall"]
    assert chosen(["all"], []) == ["hare", "hall", "duck"]
    assert chosen(["paper", "standard"], []) == ["hare", "hall", "duck"]
    assert chosen(["paper"], ["duck"]) == ["duck"]
    with pytest.raises(DataError, match="--tier best: no such tier; there are all, paper"):
        chosen(["best"], [])
    with pytest.raises(DataError, match="--pair cow: no such pair; there are duck, hall"):
        chosen(["paper"], ["cow"])


def test_a_pair_is_read_in_double_with_an_orthonormal_truth(data):
    clouds = pairs.load(pairs.read_manifest(data)[0])
    assert clouds.source.shape == clouds.target.shape == (50, 3)
    assert clouds.source.dtype == clouds.target.dtype == np.float64
    R = clouds.T_gt[:3, :3]
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-15)
    mapped = clouds.source @ R.T + clouds.T_gt[:3, 3]
    np.testing.assert_allclose(mapped, clouds.target, atol=1e-4)  # float32 at 100


def test_the_folder_is_the_argument_then_the_environment(data, tmp_path, monkeypatch):
    monkeypatch.setenv("EMTR_DATA", str(data))
    assert pairs.data_folder() == data
    with pytest.raises(DataError, match=r"nowhere.*MANIFEST.csv does not exist"):
        pairs.data_folder(str(tmp_path / "nowhere"))
    monkeypatch.delenv("EMTR_DATA")
    monkeypatch.setattr(pairs, "REPOSITORY", tmp_path / "project")
    with pytest.raises(DataError, match=r"shared/data/MANIFEST.csv.*EMTR_DATA"):
        pairs.data_folder()


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("source.ply", b"not a ply", "source.ply: expected a PLY file"),
        ("target.ply", None, "target.ply: expected a PLY file"),
        ("T_gt.txt", b"1 0 0\n0 1 0\n0 0 1\n", "T_gt.txt: expected a finite 4x4"),
        ("T_gt.txt", b"2 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", "T_gt.txt: expected a rigid"),
        ("T_gt.txt", b"1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1\n", "T_gt.txt: expected a rigid"),
        ("T_gt.txt", b"one two", "T_gt.txt: expected a 4x4 matrix in text"),
    ],
)
def test_a_bad_file_is_named(data, name, content, message):
    pair = pairs.read_manifest(data)[0]
    file = pair.folder / name
    file.unlink()
    if content is not None:
        file.write_bytes(content)
    with pytest.raises(DataError, match=message):
        pairs.load(pair)


def test_a_bad_manifest_is_named(data):
    (data / "MANIFEST.csv").write_text("group,name\nobjects,duck\n")
    with pytest.raises(DataError, match=r"MANIFEST.csv: expected the columns group, name and tier"):
        pairs.read_manifest(data)


def test_without_a_manifest_each_folder_is_a_pair(data, tmp_path):
    folder = data / "pairs" / "objects"
    assert pairs.data_folder(str(folder)) == folder
    found = pairs.read_manifest(folder)
    assert [(p.name, p.tier, p.group) for p in found] == [
        ("duck", "objects", "duck"),
        ("hare", "objects", "hare"),
    ]
    assert found[0].size > found[1].size > 0
    assert pairs.load(found[0]).source.shape == (60, 3)
    with pytest.raises(DataError, match=r"no folder in .* has source\.ply, target\.ply, T_gt\.txt"):
        pairs.data_folder(str(tmp_path / "none"))
