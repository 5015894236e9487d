"""The ablation benchmark: its variants, its figures, and its place on the page."""

import json

import accuracy_fakes
import pytest
from accuracy_fakes import REPOSITORY, FakeEngine
from emtr_bench.ablation.arguments import parser
from emtr_bench.ablation.program import ablation
from emtr_bench.ablation.variants import SWARM, VARIANTS, WHOLE
from emtr_bench.engine import PyemtrEngine
from emtr_bench.report.ablation_section import ablation_section
from emtr_bench.runner import Options


class Without(FakeEngine):
    """Fails where the transfer is off."""

    def register(self, source, target, options, sensors=None):
        spoiled = {0: (90.0, 0.0)} if options.settings.get("transfer") == 0 else {}
        return FakeEngine(spoiled=spoiled).register(source, target, options, sensors)


def run(engine, *argv):
    return ablation(parser().parse_args([str(a) for a in argv]), engine)


def test_the_library_knows_every_variant_and_none_is_another_again():
    for variant in VARIANTS:
        PyemtrEngine().check(Options("default", 0, 1, variant.settings))
    assert len({tuple(sorted(v.settings.items())) for v in VARIANTS}) == len(VARIANTS)
    for block in (WHOLE, SWARM):
        assert next(v.part for v in VARIANTS if v.block == block) == "nothing"
    assert all(v.settings["seeds"] == 0 for v in VARIANTS if v.block == SWARM)


def test_rows_tell_what_is_lost(tmp_path, capsys):
    data, out = accuracy_fakes.write_data(tmp_path), tmp_path / "out.json"
    options = ("--data", data, "--json", out, "--transforms", 2)
    assert run(Without(), *options, "--part", "transfer", "seeds") == 0
    value = json.loads(out.read_text())
    assert value["pairs"] == [["paper", 2], ["standard", 1]] and value["transforms"] == 2
    rows = {(row["block"], row["part"]): row for row in value["rows"]}
    assert set(rows) == {(WHOLE, "nothing"), (WHOLE, "seeds"), (WHOLE, "transfer"),
                         (SWARM, "nothing"), (SWARM, "transfer")}  # fmt: skip
    assert rows[WHOLE, "nothing"]["joint"] == {"standard": 100.0, "paper": 100.0}
    lost = rows[SWARM, "transfer"]
    assert lost["joint_all"] == 50.0 and (lost["registered"], lost["runs"]) == (3, 6)
    assert (lost["lost"], lost["won"]) == (3, 0)
    assert all(row["lost"] == row["won"] == 0 for row in rows.values() if row["part"] == "nothing")
    assert "without seeds: transfer" in capsys.readouterr().out
    text = ablation_section(value)
    assert "2 motions a pair" in text
    assert "| off | paper (2) | standard (1) | all | lost | won | seconds |" in text
    assert "| transfer | 50.0 | 50.0 | 50.0 | 3 | 0 |" in text and "without seeds" in text


def test_a_crash_is_told_and_fails(tmp_path, capsys):
    data = accuracy_fakes.write_data(tmp_path)
    crashing = FakeEngine(crashing=(1,))
    assert run(crashing, "--data", data, "--transforms", 2, "--part", "seeds") == 1
    assert "CRASHED: 3 runs" in capsys.readouterr().out


@pytest.mark.parametrize(
    "argv", [("--data", "/nowhere"), ("--preset", "none"), ("--tier", "no_tier")]
)
def test_what_cannot_be_run_is_said(tmp_path, capsys, argv):
    data = ("--data", accuracy_fakes.write_data(tmp_path))
    assert run(FakeEngine(), *data, *argv) == 2
    assert capsys.readouterr().err.startswith("ablation: ")


def test_the_command_is_a_program_with_a_smoke_run():
    script = REPOSITORY / "tools" / "bench" / "ablation"
    assert script.stat().st_mode & 0o111
    assert parser().parse_args(["--smoke"]).smoke
