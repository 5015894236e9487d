"""--html writes the page that Python writes, whole or not at all."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

MADE_APART = {"versions", "files", "preset", "user_provided", "seconds", "meshes"}


def payload_of(path: Path) -> dict[str, Any]:
    text = path.read_text(encoding="utf-8")
    (payload,) = re.findall(r'id="payload">(.*?)</script>', text, re.DOTALL)
    return json.loads(payload)


def without_payload(path: Path) -> str:
    text = path.read_text(encoding="utf-8")
    return re.sub(r'(id="payload">).*?(</script>)', r"\1\2", text, flags=re.DOTALL)


@pytest.fixture
def page(run, pair, tmp_path) -> Path:
    np.save(tmp_path / "a.npy", pair.source)
    np.save(tmp_path / "b.npy", pair.target)
    done = run("a.npy", "b.npy", "-o", "T.txt", "--html", "p.html", "--html-unit", "mm",
               "--report", "r.json", "--seed", "3", "--preset", "fast")  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert "p.html" in done.stderr
    return tmp_path / "p.html"


def test_python_writes_the_same(page, tmp_path):
    import pyemtr

    source, target = tmp_path / "a.npy", tmp_path / "b.npy"
    result = pyemtr.register(source, target, seed=3, preset="fast")
    result.to_html(tmp_path / "q.html", source, target, unit="mm")
    assert without_payload(page) == without_payload(tmp_path / "q.html")
    ours, theirs = payload_of(page), payload_of(tmp_path / "q.html")
    assert list(ours) == list(theirs)
    for key in set(ours) - {"report"}:
        assert ours[key] == theirs[key], key
    one, other = ours["report"], theirs["report"]
    assert set(other) <= set(one)
    for key in set(one) - MADE_APART:
        assert one[key] == other[key], key
    stages = set(one["seconds"]) - set(other["seconds"])
    assert stages == {"load_source", "load_target"}


def test_the_page_has_the_report(page, tmp_path):
    assert payload_of(page)["report"] == json.loads((tmp_path / "r.json").read_text())


def test_standard_output_and_names_of_any_kind(run, small, tmp_path):
    name = "</script><img onerror=x>.pcd"
    (tmp_path / name.replace("/", "_")).write_bytes(Path(tmp_path / small[0]).read_bytes())
    done = run(name.replace("/", "_"), small[1], "-o", "T.txt", "--html", "-")
    assert done.returncode in (0, 3), done.stderr
    assert done.stdout.startswith("<!doctype html>") and done.stdout.endswith("</html>\n")
    assert "<img" not in done.stdout


def test_nothing_is_left_where_it_cannot_be_written(run, small, tmp_path):
    before = sorted(path.name for path in tmp_path.iterdir())
    done = run(*small, "-o", "T.txt", "--html", "no/p.html")
    assert done.returncode == 2 and "no/p.html" in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == before


def test_a_unit_needs_a_page(run, small):
    done = run(*small, "--html-unit", "mm")
    assert done.returncode == 1
    assert "--html-unit: expected --html" in done.stderr
