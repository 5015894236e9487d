"""tools/reproducibility --record and --against: what is compared with a file, and what is said."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path

import pytest

TOOLS = Path(__file__).resolve().parents[2] / "tools"
sys.path.append(str(TOOLS))

from reproducibility_matrix import program, record  # noqa: E402
from reproducibility_matrix.arguments import parse  # noqa: E402

ONE = "3ff0000000000000"
NEXT = "3ff0000000000001"


def results(**changes: str) -> record.Results:
    return {"generated": {"default": {"reason": "registered", "fitness": ONE, **changes}}}


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "before.json"
    record.write(path, results(old_gap="nan"))
    return path


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch):
    """main() with these results in place of registrations, and with this command line."""

    def runs(found: record.Results, *words: object, wrong: int = 0) -> int:
        monkeypatch.setattr(program, "table", lambda arguments: (wrong, found))
        monkeypatch.setattr(sys, "argv", ["reproducibility", *map(str, words)])
        return program.main()

    return runs


def test_what_is_recorded_is_read_again(file: Path) -> None:
    assert record.read(file, {}) == results(old_gap="nan")
    assert record.read(file, {"old_gap": "fitness_gap"}) == results(fitness_gap="nan")


def test_the_same_results_differ_in_nothing() -> None:
    assert record.differences(results(), results()) == []


def test_one_bit_is_named() -> None:
    assert record.differences(results(), results(fitness=NEXT)) == [
        "generated default: different: fitness"
    ]


def test_fields_of_one_side_are_named() -> None:
    assert record.differences(results(old="nan"), results(new="nan", fitness=NEXT)) == [
        "generated default: different: fitness; only in the record: old; only in this run: new"
    ]


def test_pairs_and_presets_of_one_side_are_named() -> None:
    before = results() | {"bunny": {"paper": {"fitness": ONE}}}
    after = results()
    after["generated"]["fast"] = {"fitness": ONE}
    assert record.differences(before, after) == [
        "bunny paper: only in the record",
        "generated fast: only in this run",
    ]


def test_a_record_is_written_and_compared_with(run, file: Path, tmp_path: Path, capsys) -> None:
    again = tmp_path / "after.json"
    assert run(results(old_gap="nan"), "--record", again, "--against", file) == 0
    assert f"same bits as in {file}" in capsys.readouterr().out
    assert json.loads(again.read_text()) == json.loads(file.read_text())


def test_long_values_are_compared_by_their_digest(run, tmp_path: Path) -> None:
    path = tmp_path / "before.json"
    values = [ONE] * 100_000
    record.write(path, results(residuals=" ".join(values)))
    assert path.stat().st_size < 1000
    assert run(results(residuals=" ".join(values)), "--against", path) == 0
    assert run(results(residuals=" ".join([*values[1:], NEXT])), "--against", path) == 1


def test_a_difference_is_status_1(run, file: Path, capsys) -> None:
    assert run(results(old_gap="nan", fitness=NEXT), "--against", file) == 1
    assert "generated default: different: fitness\n" in capsys.readouterr().out


def test_renamed_fields_are_compared(run, file: Path, capsys) -> None:
    words = ["--against", file, "--renamed", "old_gap=fitness_gap"]
    assert run(results(fitness_gap="nan"), *words) == 0
    assert run(results(fitness_gap=ONE), *words) == 1
    assert "different: fitness_gap" in capsys.readouterr().out
    assert run(results(fitness_gap="nan"), "--against", file) == 1
    assert "only in the record: old_gap; only in this run: fitness_gap" in capsys.readouterr().out


def test_ways_that_differ_are_status_1_all_the_same(run, file: Path) -> None:
    assert run(results(old_gap="nan"), "--against", file, wrong=1) == 1
    assert run({}) == 1


@pytest.mark.parametrize(
    ("content", "words", "said"),
    [
        (None, [], "before.json"),
        ("{", [], "expected JSON as --record writes it"),
        ("{}", [], "expected results by pair and preset"),
        ('{"a": {"b": {"c": 1}}}', [], "expected results by pair and preset"),
        ('{"a": {"b": {"c": "x"}}}', ["d=e"], "--renamed d=e: .* has no field 'd'"),
        ('{"a": {"b": {"c": "x", "d": "x"}}}', ["c=d"], "has a field 'd' already"),
    ],
)
def test_a_bad_record_is_refused_before_anything_runs(
    content, words, said, run, tmp_path: Path, capsys
) -> None:
    path = tmp_path / "before.json"
    if content is not None:
        path.write_text(content)
    options = ["--renamed", *words] if words else []
    assert run(None, "--against", path, *options) == 2
    message = capsys.readouterr().err
    assert message.startswith("reproducibility: ")
    assert re.search(said, message), message


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--renamed", "a=b"], "--renamed: expected --against FILE too"),
        (["--against", "f", "--renamed", "ab"], "expected OLD=NEW, got 'ab'"),
        (["--against", "f", "--renamed", "=b"], "expected OLD=NEW, got '=b'"),
        (["--record", "/no/such/folder/f.json"], "--record: no folder /no/such/folder"),
    ],
)
def test_bad_arguments_are_refused(words, said, capsys) -> None:
    with pytest.raises(SystemExit) as stopped:
        parse(words)
    assert stopped.value.code == 2
    assert said in capsys.readouterr().err
