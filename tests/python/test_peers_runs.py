"""The comparison over pairs: fairness, scores, tables, JSON."""

import json
import math

import accuracy_fakes
import numpy as np
import pytest
from emtr_bench import layout, pairs, protocol, records
from emtr_bench.peers import methods, output, runs, summary, tables, units, voxel
from emtr_bench.peers.runs import Options, PeerRun
from emtr_bench.peers.settings import Setting
from emtr_bench.peers.summary import Quartiles
from peers_fakes import FakeMethod

OPTIONS = Options(transforms=3, threads=1, limit=20.0, seed=0, recommended=Setting(30))


@pytest.fixture(scope="module")
def measured(tmp_path_factory):
    """Three pairs, three motions, five methods of which four go wrong in motion 1."""
    manifest = layout.read_folder(accuracy_fakes.write_data(tmp_path_factory.mktemp("data")))
    known = [FakeMethod("emtr-paper")]
    known += [
        FakeMethod(f"peer+{how}", how, 1) for how in ("segfault", "skew", "rotate", "translate")
    ]
    return list(runs.measure(manifest, known, OPTIONS))


def test_runs_come_by_pair_and_motion_in_the_methods_order(measured):
    order = [name for name in ("hare", "hall", "duck") for _ in range(3)]
    assert [done[0].pair.name for done in measured] == order
    for done in measured:
        assert [r.method for r in done] == [r.method for r in measured[0]]
        assert len({(r.index, r.voxel, r.T_true.tobytes()) for r in done}) == 1


def test_only_what_went_wrong_is_a_failure(measured):
    wrong = [(r.method, r.index) for done in measured for r in done if not r.success]
    expected = [f"peer+{how}" for how in ("segfault", "skew", "rotate", "translate")]
    assert wrong == [(name, 1) for _ in range(3) for name in expected]
    by_how = {r.method: r for r in measured[1]}
    assert "SIGSEGV" in by_how["peer+segfault"].error
    assert "gave no pose" in by_how["peer+skew"].error
    assert by_how["peer+rotate"].rotation == pytest.approx(20.0, abs=1e-3)
    assert by_how["peer+translate"].rotation < 1e-3 and by_how["peer+translate"].translation > 1.0
    assert math.isnan(by_how["peer+segfault"].seconds) and by_how["peer+rotate"].seconds > 0.0


def test_tables_name_every_method_and_what_was_lost(measured):
    flat = [run for done in measured for run in done]
    text = tables.tier_tables("tier paper", flat)
    assert "3 pairs, 9 runs of each method" in text
    cells = next(line.split() for line in text.splitlines() if line.startswith("peer+skew"))
    assert cells[1:4] == ["9", "3", "66.7"]
    assert tables.lost(flat).count("SIGSEGV") == 3
    assert tables.lost([run for run in flat if run.method == "emtr-paper"]) == ""


def test_the_json_holds_every_run_and_has_no_nan(measured, tmp_path):
    flat = [run for done in measured for run in done]
    records.write(tmp_path / "a.json", output.record({"cpu": "x"}, OPTIONS, {"p": "no p"}, flat))
    value = json.loads((tmp_path / "a.json").read_text())
    assert len(value["runs"]) == 45 and value["left_out"] == {"p": "no p"}
    assert sum(1 for run in value["runs"] if run["error"]) == 6
    assert set(value["tiers"]) == {"paper", "standard", "all"}
    assert len(value["tiers"]["paper"]["ratios"]) == 4


def run_of(method, name, index, seconds, error=""):
    pair = pairs.Pair(name, "paper", None)
    return PeerRun(method, pair, index, "any", 1.0, np.eye(4), None if error else np.eye(4),
                   math.nan if error else seconds, 0.0, 0.0, error)  # fmt: skip


def test_ratios_are_pair_by_pair_and_skip_lost_runs():
    flat = [run_of("emtr-fast", "a", i, s) for i, s in enumerate((1.0, 2.0, 3.0, 9.0))]
    flat += [run_of("peer+x", "a", i, s) for i, s in enumerate((2.0, 2.0, 2.0))]
    flat += [run_of("peer+x", "a", 3, 0.0, "crashed")]
    (ratio,) = summary.ratios(flat)
    assert (ratio.ours, ratio.peer, ratio.runs) == ("emtr-fast", "peer+x", 3)
    assert ratio.times == Quartiles(0.75, 1.0, 1.25)


def test_quartiles_of_little():
    assert summary.quartiles([2.0]) == Quartiles(2.0, 2.0, 2.0)
    assert all(math.isnan(v) for v in summary.quartiles([]))


def test_the_voxel_leaves_as_many_points_as_asked_in_any_unit():
    rng = np.random.default_rng(1)
    a, b = (rng.normal(size=(n, 3)) for n in (4000, 6000))
    found = voxel.voxel_size(a, b, 2000)
    left = voxel.occupied(a, found) + voxel.occupied(b, found)
    assert 1900 <= left <= 2000
    assert voxel.voxel_size(1000 * a, 1000 * b, 2000) == pytest.approx(1000 * found, rel=1e-6)


def test_the_voxel_of_small_clouds_still_thins_them():
    cloud = np.random.default_rng(1).normal(size=(500, 3))
    assert 400 <= 2 * voxel.occupied(cloud, voxel.voxel_size(cloud, cloud, 6000)) <= 500


def test_another_unit_and_back_is_the_same_pose():
    rng = np.random.default_rng(2)
    source, target = rng.normal(size=(2, 50, 3)) + 1e4
    unit = units.Unit.of(source, target, 7.0)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = protocol.euler_zyx(np.array([0.3, -0.8, 2.0])), [5.0, 6.0, -7.0]
    np.testing.assert_allclose(unit.pose_from(unit.pose_to(T)), T, atol=1e-9)
    moved = protocol.apply(unit.pose_to(T), unit.source(source))
    np.testing.assert_allclose(moved, unit.target(protocol.apply(T, source)), atol=1e-8)


def test_methods_are_chosen_by_row_search_or_emtr():
    known = methods.all_methods(["paper", "fast"])
    names = [method.name for method in known]
    assert names[:3] == ["emtr-paper", "emtr-fast", "open3d-ransac+point-to-plane"]
    assert len(names) == 8
    assert methods.select(known, []) == known
    chosen = [m.name for m in methods.select(known, ["kiss-matcher", "emtr", "open3d-fgr+gicp"])]
    assert chosen == ["emtr-paper", "emtr-fast", "open3d-fgr+gicp",
                      "kiss-matcher+point-to-plane", "kiss-matcher+gicp"]  # fmt: skip
    with pytest.raises(ValueError, match="--only teaser: no such method; there are emtr-paper"):
        methods.select(known, ["teaser"])


def test_the_libraries_of_a_row_are_known_without_importing_them():
    rows = {method.name: method.modules for method in methods.all_methods(["paper"])}
    assert rows["open3d-fgr+point-to-plane"] == ("open3d",)
    assert rows["kiss-matcher+gicp"] == ("kiss_matcher", "small_gicp")
    assert rows["emtr-paper"] == ("pyemtr",)
