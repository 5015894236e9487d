"""The pages of an alignment: the models with why each pair was taken or not, and the pairs."""

from __future__ import annotations

import gzip
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from many_scans import scene

import pyemtr

pytest.importorskip("gtsam", reason="gtsam is not installed")


def payload_of(page: Path) -> dict[str, Any]:
    (payload,) = re.findall(r'id="payload">(.*?)</script>', page.read_text(), re.DOTALL)
    return json.loads(payload)


@pytest.fixture(scope="module")
def aligned() -> pyemtr.MultiwayResult:
    made = scene({2: 3, 3: 1}, seed=5, count=2000, half_angle=85.0)
    return pyemtr.align_all(made.clouds, preset="fast", names=["</script>", "b", "c", "d"])


def points(block: dict[str, Any]) -> np.ndarray:
    import base64

    steps = np.frombuffer(base64.b64decode(block["points"]), dtype="<u2").reshape(-1, 3)
    return np.array(block["origin"]) + block["step"] * steps


def test_the_index_shows_the_scans_where_they_are(aligned, tmp_path) -> None:
    files = aligned.to_html(tmp_path, unit="mm", title="A <thing>")
    assert files[-1] == "index.html" and len(files) == 1 + len(aligned.edges)
    assert sorted(str(p.relative_to(tmp_path)) for p in tmp_path.rglob("*.html")) == sorted(files)
    page = tmp_path / "index.html"
    assert page.stat().st_size < 3e6 and "<thing>" not in page.read_text()
    payload = payload_of(page)
    assert payload["models"] == aligned.models and payload["unit"] == "mm"
    for shown, scan, i in zip(payload["scans"], aligned.scans, range(4)):
        assert shown["name"] == scan.name and shown["text"] == scan.text
        assert shown["placed"] is scan.placed and (shown["cloud"] is None) is not scan.placed
        if scan.placed:
            assert shown["pose"] == scan.pose.tolist()
            found, wanted = points(shown["cloud"]), aligned.surface(i)
            assert 1000 < len(found) <= len(wanted)
            assert np.abs(found.min(axis=0) - wanted.min(axis=0)).max() < 0.05 * aligned.radius
    assert sum(scan.placed for scan in aligned.scans) == 3  # so both kinds were looked at


def test_each_pair_has_its_page_and_why(aligned, tmp_path) -> None:
    aligned.to_html(tmp_path)
    payload = payload_of(tmp_path / "index.html")
    assert {edge["taken"] for edge in payload["edges"]} == {True, False}
    for shown, edge in zip(payload["edges"], aligned.edges):
        assert shown["why"] == edge.why and shown["probability"] == edge.probability
        assert shown["page"] == f"pairs/{edge.source:03d}_{edge.target:03d}.html"
        page = tmp_path / shown["page"]
        assert page.stat().st_size < 3e6
        report = payload_of(page)["report"]
        result = aligned.registration(edge.source, edge.target)
        assert report["transformation"] == result.transformation.tolist()
        assert report["confidence"] == edge.confidence
        names = aligned.scans[edge.source].name, aligned.scans[edge.target].name
        assert report["files"] == {"source": names[0], "target": names[1]}


@pytest.mark.parametrize(("pairs", "count"), [("taken", None), ("none", 0)])
def test_pages_of_some_pairs(aligned, tmp_path, pairs, count) -> None:
    taken = sum(edge.taken for edge in aligned.edges)
    files = aligned.to_html(tmp_path, pairs=pairs)
    assert len(files) - 1 == (taken if count is None else count)
    edges = payload_of(tmp_path / "index.html")["edges"]
    assert [edge["page"] is not None for edge in edges] == [
        edge["taken"] and pairs == "taken" for edge in edges
    ]


def test_without_a_model_there_is_an_index_still(tmp_path) -> None:
    made = scene({2: 1, 3: 1}, seed=1, count=1500, half_angle=60.0)
    apart = pyemtr.align_all(made.clouds, preset="fast")
    assert apart.models == []
    apart.to_html(tmp_path)
    payload = payload_of(tmp_path / "index.html")
    assert payload["models"] == [] and not any(scan["cloud"] for scan in payload["scans"])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"pairs": "some"}, "pairs: expected all, taken or none"),
        ({"up": (0, 0, 0)}, "up: expected a direction"),
        ({"max_points": 0}, "max_points: expected 1 to"),
    ],
)
def test_wrong_arguments(aligned, tmp_path, arguments, message) -> None:
    with pytest.raises(ValueError, match=message):
        aligned.to_html(tmp_path, **arguments)
    assert not (tmp_path / "index.html").exists()


def test_a_pair_that_was_not_registered_has_no_result(aligned) -> None:
    with pytest.raises(KeyError):
        aligned.registration(0, 1)  # the reverse of (1, 0)


def test_a_folder_of_several_formats_has_its_pages(tmp_path) -> None:
    made = scene({2: 3}, seed=5, count=2000, half_angle=85.0)
    np.save(tmp_path / "a.npy", made.clouds[0])
    np.savetxt(tmp_path / "b.xyz", made.clouds[1], fmt="%.17g")
    points = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in made.clouds[2].tolist())
    (tmp_path / "c.obj.gz").write_bytes(gzip.compress(points.encode()))
    (tmp_path / "notes.doc").write_text("no scan")
    found = pyemtr.align_all(tmp_path, preset="fast")
    assert [scan.name for scan in found.scans] == ["a.npy", "b.xyz", "c.obj.gz"]
    wanted = pyemtr.align_all(made.clouds, preset="fast")
    assert (
        np.array([s.pose for s in found.scans]).tobytes()
        == np.array([s.pose for s in wanted.scans]).tobytes()
    )
    assert len(found.to_html(tmp_path / "pages")) == 1 + len(found.edges)
    payload = payload_of(tmp_path / "pages" / "index.html")
    assert all(scan["cloud"] is not None for scan in payload["scans"])
