"""BENCHMARK.md: its parts, what is kept of a run, and the page made of it."""

import dataclasses
import json
from pathlib import Path

import accuracy_fakes
from accuracy_fakes import FakeEngine
from emtr_bench import layout, records
from emtr_bench.calibration.figures import calibration
from emtr_bench.calibration.judged import Judged
from emtr_bench.peers import output, runs
from emtr_bench.peers.settings import Setting
from emtr_bench.report.page import page
from emtr_bench.report.parts import NAMES, Part, all_parts
from emtr_bench.virtual_pairs import folder as on_disk
from peers_fakes import FakeMethod

MACHINE = {"date": "today", "revision": "abc", "load average": "0.1", "cpu": "a fine one"}
QUARTILES = {"low": 0.01, "median": 0.02, "high": 0.03}


def parts_of(folder, presets=("paper",)):
    return all_parts(folder, folder, list(presets), smoke=False)


def keep(part, value, status=0, **machine):
    records.write(part.json, value)
    how = {"command": part.line, "machine": {**MACHINE, **machine}, "status": status,
           "seconds": 3.0}  # fmt: skip
    records.write(part.json.with_name(f"{part.json.stem}.run.json"), how)


def text_of(parts, folder):
    return page(parts, folder, folder / "BENCHMARK.md")


def test_each_preset_has_the_protocol_and_every_pair():
    parts = parts_of(Path("build/bench"), ["paper", "fast"])
    assert [part.section for part in parts if part.section != "accuracy"] == list(NAMES[1:])
    lines = [part.line for part in parts]
    for preset in ("paper", "fast"):
        assert (f"tools/bench/accuracy --preset {preset} --tier paper --transforms 20 --threads 2 "
                f"--json=build/bench/accuracy-{preset}-paper.json") in lines  # fmt: skip
    assert (
        "tools/bench/calibration build/bench/accuracy-paper-all.json "
        "build/bench/accuracy-fast-all.json --plot=build/bench/calibration.png "
        "--json=build/bench/calibration.json"
    ) in lines
    assert "tools/bench/regress --json=build/bench/regress.json" in lines
    assert len({part.json for part in parts}) == len(parts)


def test_generated_pairs_are_told(tmp_path, monkeypatch):
    folder = accuracy_fakes.write_data(tmp_path / "data")
    monkeypatch.setenv("EMTR_DATA", str(folder))
    parts = parts_of(tmp_path)
    for generated, place in ((False, tmp_path / "elsewhere"), (True, tmp_path / "data")):
        monkeypatch.setattr(on_disk, "FOLDER", place)
        accuracy_fakes.run_accuracy(
            ["--transforms", "1", "--json", str(parts[0].json)], FakeEngine()
        )
        keep(parts[0], json.loads(parts[0].json.read_text()))
        assert ("On the generated pairs" in text_of(parts, tmp_path)) == generated


def test_a_sweep_of_the_others_is_asked_for():
    folder = Path("build/bench")
    lines = [p.line for p in all_parts(folder, Path("docs"), ["paper"], smoke=False, sweep=True)]
    assert (
        "tools/bench/peers --tier all --transforms 1 --threads 2 --sweep --plot=docs/peers.png "
        "--json=build/bench/peers.json"
    ) in lines
    assert not any("--sweep" in part.line for part in parts_of(folder))


def test_every_command_is_one_that_the_programs_take():
    from emtr_bench.ablation.arguments import parser as ablation_parser
    from emtr_bench.arguments import parser as accuracy_parser
    from emtr_bench.calibration.arguments import parser as calibration_parser
    from emtr_bench.peers.arguments import parser as peers_parser
    from emtr_bench.regress.arguments import parser as regress_parser
    from emtr_bench.stages.arguments import parser as stages_parser

    parsers = {"accuracy": accuracy_parser, "ablation": ablation_parser,
               "calibration": calibration_parser, "peers": peers_parser,
               "regress": regress_parser, "stages": stages_parser}  # fmt: skip
    for smoke in (False, True):
        for part in all_parts(Path("b"), Path("p"), ["paper"], smoke):
            if part.section in parsers:
                parsers[part.section]().parse_args(part.command[1:])


def test_what_was_not_measured_is_said(tmp_path):
    text = text_of(parts_of(tmp_path), tmp_path)
    assert text.count("Not measured.") == 9 and "Nothing has been measured." in text


def test_accuracy_is_rendered_from_its_own_json(tmp_path, monkeypatch):
    monkeypatch.setenv("EMTR_DATA", str(accuracy_fakes.write_data(tmp_path)))
    parts = parts_of(tmp_path)
    words = ["--tier", "all", "--transforms", "5", "--json", str(parts[1].json)]
    accuracy_fakes.run_accuracy(words, FakeEngine(spoiled={3: (90.0, 0.0)}))
    keep(parts[1], json.loads(parts[1].json.read_text()))
    text = text_of(parts, tmp_path)
    assert "| paper | 2 | 10 | 80.0 | 80.0 |" in text and "| all | 3 | 15 | 80.0 |" in text
    accuracy_fakes.run_accuracy(["--transforms", "5", "--json", str(parts[0].json)], FakeEngine())
    keep(parts[0], json.loads(parts[0].json.read_text()))
    assert "| hare | 100.0 | Bunny | 0.000 | 0.233 |" in text_of(parts, tmp_path)


def test_calibration_is_rendered_from_its_own_json(tmp_path):
    runs = [Judged(0.95, True, True, True)] * 3 + [Judged(0.05, False, False, False)]
    value = {"presets": {"fast": dataclasses.asdict(calibration(runs, 2))}}
    (part,) = (p for p in parts_of(tmp_path) if p.section == "calibration")
    keep(part, value)
    text = text_of([part], tmp_path)
    assert "| `fast` | 4 | 1 | 3 | 0.050 | 0.0025 | 1.0000 | 1.000 (0.439 to 1.000) |" in text
    assert "| 0.50 to 1.00 | 3 | 0.950 | 1.000 | 0.439 to 1.000 |" in text
    assert "](calibration.png)" in text


def test_peers_are_rendered_from_their_own_json(tmp_path):
    manifest = layout.read_folder(accuracy_fakes.write_data(tmp_path))[:1]
    options = runs.Options(2, 1, 20.0, 0, Setting(30))
    methods = [FakeMethod("emtr-paper"), FakeMethod("peer+x", "raise", 1)]
    measured = [run for done in runs.measure(manifest, methods, options) for run in done]
    (part,) = (p for p in parts_of(tmp_path) if p.section == "peers")
    keep(part, output.record({**MACHINE, "open3d": "9.9"}, options, {"y": "no y"}, measured))
    text = text_of([part], tmp_path)
    assert "Versions: open3d 9.9." in text and "Left out: y (no y)." in text
    assert "| peer+x | 2 | 1 | 50.0 |" in text and "| emtr-paper | 2 | 0 | 100.0 |" in text
    assert "| our seconds / theirs, pair by pair | emtr-paper |" in text


def test_costs_are_rendered(tmp_path):
    values = {
        "stages": {"points": [10, 20], "kernel": "generic", "repetitions": 3,
                   "slow_repetitions": 1,
                   "profiles": [{"preset": "paper", "threads": 1,
                                 "seconds": {"normalization": QUARTILES}}],
                   "structures": [{"preset": "paper", "threads": 1, "ratio": 12.34,
                                   "same_bits": False,
                                   "evolution": {"grid": QUARTILES, "kdtree": QUARTILES}}],
                   "limits": [{"preset": "paper", "total": 0.1,
                               "rows": [{"kind": "bytes", "amount": 1920000, "least": 0.0005,
                                         "stage": "normalization", "reached": 0.002}]}]},
        "scaling": {"slope": 0.987, "slope_from": 1000,
                    "sizes": [{"points": 5000, "stages": {"normalization": 0.5}, "seconds": 1.5,
                               "peak_bytes": 3e6, "memory_over_input": 2.5, "E_R": 0.25}]},
        "neighbors": {"benchmarks": [
            {"run_type": "iteration", "run_name": f"{name}/random/600", "query": seconds}
            for name, seconds in (("flann", 5e-7), ("flann", 7e-7), ("flann", 6e-7),
                                  ("grid", 4e-9))]},
        "regress": {"toolchain": {"pcl": "1"},
                    "programs": {"p": {"instructions": 2500000,
                                       "functions": {"emtr::f": 1200000}}}},
    }  # fmt: skip
    parts = parts_of(tmp_path)
    for part in parts:
        if part.section in values:
            keep(part, values[part.section])
    text = text_of(parts, tmp_path)
    for expected in (
        "| `paper` | 1 | 20.0 |",
        "| `paper` | bytes | 1,920,000 | normalization | 0.50 | 2.00 | 4.0 |",
        "| `paper` | all of these |  | the whole | 0.50 | 100.00 | 200.0 |",
        "| 12.3 | **not the same bits** |", "![time and memory",
        "](scaling.png)", "| 5,000 | 500.0 | 1.500 | 3 | 2.50 | 0.25 |", "power 0.99",
        "| 600 | random | 600.0 | 4.0 |", "| **p** | 2.5 |", "| `emtr::f` | 1.2 |",
    ):  # fmt: skip
        assert expected in text, expected


def test_another_machine_or_a_failure_is_told(tmp_path):
    parts = [p for p in parts_of(tmp_path) if p.section == "regress"]
    keep(parts[0], {"toolchain": {}, "programs": {}}, status=1)
    text = text_of(parts, tmp_path)
    assert "It ended with status 1." in text and "not all measured" not in text
    other = Part("regress2", "regress", ("tools/bench/regress",), tmp_path / "regress2.json")
    keep(other, {"toolchain": {}, "programs": {}}, cpu="another", date="tomorrow")
    text = text_of([*parts, other], tmp_path)
    assert "not all measured" in text and "| cpu | a fine one |" in text
