"""Reading the manifest and the pairs, and what is said of bad ones."""

import argparse

import accuracy_fakes
import numpy as np
import pytest
from emtr_bench import data as chosen_data
from emtr_bench import layout, pairs
from emtr_bench.pair_arguments import add_pair_options, pair_words
from emtr_bench.pairs import DataError


@pytest.fixture
def data(tmp_path):
    return accuracy_fakes.write_data(tmp_path)


def test_pairs_come_in_the_order_of_the_tiers(data):
    manifest = layout.read_folder(data)
    assert [(p.name, p.tier, p.paper_row) for p in manifest] == [
        ("hare", "paper", "Bunny"),
        ("hall", "paper", "7a (stand-in)"),
        ("duck", "standard", ""),
    ]


def test_tiers_and_names_select(data):
    manifest = layout.read_folder(data)

    def chosen(tiers, names):
        return [p.name for p in chosen_data.select(manifest, tiers, names)]

    assert chosen(["paper"], []) == ["hare", "hall"]
    assert chosen(["all"], []) == ["hare", "hall", "duck"]
    assert chosen(["paper", "standard"], []) == ["hare", "hall", "duck"]
    assert chosen(["paper"], ["duck"]) == ["duck"]
    with pytest.raises(DataError, match="--tier best: no such tier; there are all, paper"):
        chosen(["best"], [])
    with pytest.raises(DataError, match="--pair cow: no such pair; there are duck, hall"):
        chosen(["paper"], ["cow"])


def test_a_pair_is_read_in_double_with_an_orthonormal_truth(data):
    clouds = pairs.load(layout.read_folder(data)[0])
    assert clouds.source.shape == clouds.target.shape == (50, 3)
    assert clouds.source.dtype == clouds.target.dtype == np.float64
    R = clouds.T_gt[:3, :3]
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-15)
    mapped = clouds.source @ R.T + clouds.T_gt[:3, 3]
    np.testing.assert_allclose(mapped, clouds.target, atol=1e-4)  # float32 at 100


def test_the_folder_is_the_argument_then_the_environment(data, tmp_path, monkeypatch):
    monkeypatch.setenv("EMTR_DATA", str(data))
    assert chosen_data.locate(None) == data
    assert chosen_data.locate(str(tmp_path)) == tmp_path
    with pytest.raises(DataError, match=r"--data .*nowhere: no such folder .*generated pairs"):
        chosen_data.locate(str(tmp_path / "nowhere"))
    monkeypatch.setattr(chosen_data, "REPOSITORY", tmp_path / "project")
    monkeypatch.setenv("EMTR_DATA", "/nowhere")
    assert chosen_data.locate(None) is None
    monkeypatch.delenv("EMTR_DATA")
    assert chosen_data.locate(None) is None
    (tmp_path / "shared" / "data").mkdir(parents=True)
    assert chosen_data.locate(None) == tmp_path / "shared" / "data"


def parse(tier, *words):
    made = argparse.ArgumentParser()
    add_pair_options(made, tier)
    return made.parse_args(words)


def test_the_tier_by_default_is_all_where_there_is_no_such_tier(data, capsys):
    own = str(data / "pairs")
    assert [p.name for p in chosen_data.chosen(parse("paper", "--data", str(data)))] == [
        "hare", "hall"]  # fmt: skip
    assert f"data: {data}" in capsys.readouterr().out
    assert len(chosen_data.chosen(parse("all", "--data", str(data)))) == 3
    assert len(chosen_data.chosen(parse("paper", "--data", own))) == 3
    one = parse("paper", "--data", own, "--tier", "rooms")
    assert [p.name for p in chosen_data.chosen(one)] == ["hall"]
    two = parse("all", "--data", own, "--pair", "hall", "--pair", "duck", "hall")
    assert {p.name for p in chosen_data.chosen(two)} == {"hall", "duck"}
    again = parse("paper", *pair_words(two))
    assert chosen_data.chosen(again) == chosen_data.chosen(two)


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
    pair = layout.read_folder(data)[0]
    file = pair.folder / name
    file.unlink()
    if content is not None:
        file.write_bytes(content)
    with pytest.raises(DataError, match=message):
        pairs.load(pair)


def test_a_bad_manifest_is_named(data):
    (data / "MANIFEST.csv").write_text("group,name\nobjects,duck\n")
    with pytest.raises(DataError, match=r"MANIFEST.csv: expected the columns group, name and tier"):
        layout.read_folder(data)


def test_without_a_manifest_each_folder_is_a_pair(data, tmp_path):
    found = layout.read_folder(data / "pairs" / "objects")
    assert [(p.name, p.tier, p.group) for p in found] == [
        ("duck", "objects", "duck"),
        ("hare", "objects", "hare"),
    ]
    assert found[0].size > found[1].size > 0
    assert pairs.load(found[0]).source.shape == (60, 3)


def test_folders_of_pairs_are_tiers_and_a_pair_alone_is_one_too(data):
    (data / "MANIFEST.csv").unlink()
    found = {p.name: (p.tier, p.group) for p in layout.read_folder(data)}
    assert found == {"duck": ("objects", "objects"), "hare": ("objects", "objects"),
                     "hall": ("rooms", "rooms")}  # fmt: skip
    (alone,) = layout.read_folder(data / "pairs" / "rooms" / "hall")
    assert (alone.name, alone.tier) == ("hall", "hall") and pairs.load(alone)


def test_a_folder_without_pairs_half_a_pair_and_one_name_twice_are_told(data, tmp_path):
    (tmp_path / "none").mkdir()
    with pytest.raises(DataError, match=r"no pairs in .*none: .*MANIFEST.csv.*BENCHMARKING.md"):
        layout.read_folder(tmp_path / "none")
    manifest = data / "MANIFEST.csv"
    manifest.write_text("group,name,tier\na,x,t\nb,x,t\n")
    with pytest.raises(DataError, match="two pairs are called x"):
        layout.read_folder(data)
    manifest.unlink()
    (data / "pairs" / "rooms" / "hall" / "T_gt.txt").unlink()
    with pytest.raises(DataError, match=r"hall: half a pair: it has no T_gt\.txt"):
        layout.read_folder(data)


def test_what_is_written_is_read(tmp_path):
    rng = np.random.default_rng(4)
    source, target = rng.normal(size=(2, 30, 3)).astype(np.float32).astype(float)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]], rng.normal(size=3)
    sensors = rng.normal(size=(2, 3))
    layout.write_pair(tmp_path / "known", source, target, T, sensors)
    layout.write_pair(tmp_path / "apart", source, target, None)
    apart, known = layout.read_folder(tmp_path)
    assert (known.related, apart.related) == (True, False)
    clouds = pairs.load(known)
    for read, written in ((clouds.source, source), (clouds.target, target), (clouds.T_gt, T),
                          (pairs.viewpoints(known), sensors)):  # fmt: skip
        np.testing.assert_array_equal(read, written)
    assert pairs.viewpoints(apart) is None and not list(tmp_path.rglob("*.part"))
    with pytest.raises(DataError, match="none of the chosen pairs has a pose"):
        chosen_data.related([apart])


@pytest.mark.parametrize("text", ["1 2 3", "1 2\n3 4", "1 2 3\n4 5 x", "1 2 3\n4 5 nan"])
def test_bad_viewpoints_are_named(tmp_path, text):
    (tmp_path / "viewpoints.txt").write_text(text)
    with pytest.raises(DataError, match=r"viewpoints\.txt: expected two lines of three"):
        pairs.viewpoints(pairs.Pair("a", "b", tmp_path))
