"""The sweep of the other libraries' settings: what is run, which is the fastest, the frontier."""

import json
import math
from pathlib import Path

import accuracy_fakes
import numpy as np
import pytest
from emtr_bench import layout, pairs, records
from emtr_bench.peers import methods, output, program, runs, sweep, sweep_tables, voxel
from emtr_bench.peers.arguments import parser
from emtr_bench.peers.runs import Options, PeerRun
from emtr_bench.peers.settings import Setting, grid
from emtr_bench.report.peers_section import peers_section
from peers_fakes import FakeMethod, VoxelTeller

OWN = Setting(30)
OPTIONS = Options(transforms=2, threads=1, limit=20.0, seed=0, recommended=OWN)


def test_the_grid_begins_with_the_recommended_setting_and_has_each_once():
    assert grid(OWN, [30, 60], [0, 40]) == [OWN, Setting(30, 40), Setting(60), Setting(60, 40)]
    assert grid(OWN, [30], [0]) == [OWN]
    assert (OWN.name, Setting(30, 40).name) == ("30 / own", "30 / 40")


def run_of(method, setting, seconds, success=True, name="a", tier="paper", index=0):
    lost = math.isnan(seconds)
    error = 0.0 if success else 90.0
    return PeerRun(method, pairs.Pair(name, tier, Path(name)), index, "any", 1.0, np.eye(4),
                   None if lost else np.eye(4), seconds, math.nan if lost else error, 0.0,
                   "crashed" if lost else "", setting)  # fmt: skip


@pytest.fixture
def swept():
    """Two motions each: a coarse setting that fails once, one as good as the recommended and
    faster, one better and slower, one that always crashes; and emtr."""
    table = {
        ("peer+x", OWN): [(2.0, True), (2.0, False)],
        ("peer+x", Setting(10)): [(0.5, False), (0.5, False)],
        ("peer+x", Setting(20)): [(1.0, True), (1.2, False)],
        ("peer+x", Setting(60)): [(4.0, True), (4.0, True)],
        ("peer+x", Setting(90)): [(math.nan, False), (math.nan, False)],
        ("emtr-fast", None): [(0.6, True), (0.8, True)],
    }
    return [
        run_of(method, setting, seconds, success, index=index)
        for (method, setting), both in table.items()
        for index, (seconds, success) in enumerate(both)
    ]


def test_the_fastest_that_loses_nothing(swept):
    found = sweep.points(swept)
    peers = [point for point in found if point.method == "peer+x"]
    assert [point.success for point in peers] == [50.0, 0.0, 50.0, 100.0, 0.0]
    best = sweep.fastest(peers, OWN)
    assert best.setting == Setting(20) and best.seconds == pytest.approx(1.1)
    assert sweep.fastest(found[-1:], OWN).method == "emtr-fast"
    kept = sweep.at_their_fastest(swept, OWN)
    assert {(run.method, run.setting) for run in kept} == {
        ("peer+x", Setting(20)), ("emtr-fast", None)}  # fmt: skip
    assert {run.setting for run in sweep.at_recommended(swept, OWN)} == {OWN, None}


def test_a_recommended_setting_that_always_crashes_can_be_beaten():
    both = [run_of("peer+x", OWN, math.nan, False), run_of("peer+x", Setting(20), 1.0, False)]
    assert sweep.fastest(sweep.points(both), OWN).setting == Setting(20)
    assert sweep.fastest(sweep.points(both[:1]), OWN).setting == OWN


def test_the_frontier_has_what_no_other_beats(swept):
    labels = [point.label for point in sweep.frontier(sweep.points(swept))]
    assert labels == ["peer+x 10 / own", "emtr-fast"]
    others = [run for run in swept if run.method == "peer+x"]
    labels = [point.setting for point in sweep.frontier(sweep.points(others))]
    assert labels == [Setting(10), Setting(20), Setting(60)]


def test_tables_and_json_and_page_show_both_settings(swept, tmp_path):
    text = sweep_tables.sweep_tables("tier paper", swept, OWN)
    (line,) = (line for line in text.splitlines() if line.startswith("peer+x "
               ) and "30 / own" in line)  # fmt: skip
    assert line.split() == ["peer+x", "30", "/", "own", "50.0", "2.000",
                            "20", "/", "own", "50.0", "1.100", "0.55"]  # fmt: skip
    assert "tier paper, the others at their fastest: 1 pairs, 2 runs" in text
    records.write(tmp_path / "a.json", output.record({"cpu": "x"}, OPTIONS, {}, swept))
    value = json.loads((tmp_path / "a.json").read_text())
    assert [row["seconds"]["median"] for row in value["tiers"]["paper"]["methods"]] == [2.0, 0.7]
    found = value["sweep"]["paper"]
    assert found["fastest"]["peer+x"] == {"search_points": 20, "refine_points": None}
    assert [row["frontier"] for row in found["points"]] == [False, True, False, False, False, True]
    page = peers_section(value, "pictures/peers.png")
    assert "](pictures/peers.png)" in page
    assert "| peer+x | 2 | 0 | 50.0 |" in page
    assert "### Tier paper: the others at their fastest" in page
    assert "| peer+x | 20 | its own | 50.0 | 1.100" in page and "| emtr-fast |  |  | 100.0" in page
    without = output.record({"cpu": "x"}, OPTIONS, {}, sweep.at_recommended(swept, OWN))
    assert without["sweep"] is None and "fastest" not in peers_section(without, "")


def test_each_method_meets_each_setting_and_ours_none(tmp_path):
    manifest = layout.read_folder(accuracy_fakes.write_data(tmp_path))[:1]
    settings = grid(OWN, [15], [0, 12])
    known = [FakeMethod("emtr-paper"), VoxelTeller("peer+x")]
    done = list(runs.measure(manifest, known, OPTIONS, settings))
    assert [[(r.method, r.setting) for r in both] for both in done] == 2 * [
        [("emtr-paper", None), *(("peer+x", setting) for setting in settings)]]  # fmt: skip
    clouds = pairs.load(manifest[0])

    def size(points):
        return voxel.voxel_size(clouds.source, clouds.target, points)

    told = [run.T_est[:3, 3].tolist() for run in done[0][1:]]
    assert told == [[size(30), -1.0, 0.0], [size(15), -1.0, 0.0], [size(15), size(12), 0.0]]
    assert done[0][2].voxel == size(15) > size(30)


def test_the_plot_is_a_picture_of_every_tier(swept, tmp_path):
    pytest.importorskip("matplotlib")
    from emtr_bench.peers.sweep_plot import plot

    found = sweep.points(swept)
    plot({"tier a": found, "tier b": found[:-1], "tier c": found[4:]}, OWN, tmp_path / "s.png")
    assert (tmp_path / "s.png").read_bytes().startswith(b"\x89PNG")
    assert [path.name for path in tmp_path.iterdir()] == ["s.png"]


@pytest.fixture
def fakes(tmp_path, monkeypatch):
    """The command with two methods of the fakes, on two tiers."""
    monkeypatch.setenv("EMTR_DATA", str(accuracy_fakes.write_data(tmp_path / "data")))
    monkeypatch.setattr(program, "choose_methods", lambda *_: [
        FakeMethod("emtr-paper"), FakeMethod("peer+x", "rotate", 1)])  # fmt: skip
    monkeypatch.setattr(FakeMethod, "missing", lambda self: [], raising=False)
    monkeypatch.setattr(program.machine, "describe", lambda packages: {"cpu": "a fine one"})
    return lambda *words: program.compare(parser().parse_args([str(word) for word in words]))


def test_the_command_prints_both_and_draws(fakes, tmp_path, capsys):
    pytest.importorskip("matplotlib")
    words = [
        "--tier",
        "all",
        "--transforms",
        2,
        "--threads",
        1,
        "--sweep",
        "--sweep-points",
        20,
        "--refine-points",
        0,
        10,
        "--plot",
        tmp_path / "p.png",
        "--json",
        tmp_path / "j.json",
    ]
    assert fakes(*words) == 0
    printed = capsys.readouterr().out
    for title in ("tier paper", "tier standard", "all tiers"):
        assert f"{title}: recommended settings, and the fastest" in printed
        assert f"{title}, the others at their fastest" in printed
    assert "favors the other libraries" in printed
    (line,) = (line for line in printed.splitlines() if line.startswith("hare[1]"))
    assert line.count("!") == 1  # one of the recommended runs; the swept ones are not shown here
    assert (tmp_path / "p.png").is_file()
    value = json.loads((tmp_path / "j.json").read_text())
    assert len(value["runs"]) == 3 * 2 * (1 + 3)
    assert set(value["sweep"]) == {"paper", "standard", "all"}


def test_a_plot_without_a_sweep_is_refused(fakes, capsys):
    assert fakes("--plot", "a.png") == 2
    assert capsys.readouterr().err.startswith("peers: --plot draws a sweep")


def test_a_task_has_the_librarys_own_refinement_by_default():
    assert methods.Task(1.0, 2, 3).refine_voxel is None
