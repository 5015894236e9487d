"""The index of many registrations, and the small pictures in it."""

from __future__ import annotations

import base64
import io
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pyemtr
from pyemtr.html import IndexEntry, write_index
from pyemtr.html.thumbnail import HEIGHT, WIDTH, thumbnail

HOSTILE = "</script><img src=x onerror=alert(1)>"


@pytest.fixture(scope="module")
def solved(pair) -> pyemtr.Result:
    return pyemtr.register(pair.source, pair.target, preset="fast", threads=2)


def entries_of(path: Path) -> list[dict[str, Any]]:
    text = path.read_text()
    (payload,) = re.findall(r'id="payload">(.*?)</script>', text, re.DOTALL)
    return json.loads(payload)["entries"]


def test_a_result_its_dict_and_a_report_are_the_same_row(solved, tmp_path) -> None:
    from pyemtr.html.report import report_of

    report = report_of(solved, ("a", "b"), (1, 1))
    write_index(
        tmp_path / "index.html",
        [IndexEntry("x", solved), ("x", solved.to_dict()), ("x", json.loads(json.dumps(report)))],
    )
    first, second, third = entries_of(tmp_path / "index.html")
    assert first == second == third
    assert first["confidence"] == solved.confidence and first["registered"] is True
    assert first["seconds"] == solved.timings["total"]
    assert first["overlap_source"] == solved.overlap_source


def test_links_lead_from_the_index_to_the_pages(solved, tmp_path) -> None:
    (tmp_path / "pages").mkdir()
    write_index(
        tmp_path / "index.html",
        [
            ("a", solved, tmp_path / "pages" / "a b#1.html"),
            ("b", solved, tmp_path / "javascript:alert(1)"),
            ("c", solved),
        ],
    )
    links = [entry["page"] for entry in entries_of(tmp_path / "index.html")]
    assert links == ["pages/a%20b%231.html", "javascript%3Aalert%281%29", None]


def test_names_are_data_and_never_markup(solved, tmp_path) -> None:
    write_index(tmp_path / "index.html", [(HOSTILE, solved)], title=HOSTILE)
    assert "<img" not in (tmp_path / "index.html").read_text()
    assert entries_of(tmp_path / "index.html")[0]["name"] == HOSTILE


def test_what_is_missing_is_unknown(tmp_path) -> None:
    write_index(tmp_path / "i.html", [("failed", {"registered": False, "confidence": np.nan})])
    (entry,) = entries_of(tmp_path / "i.html")
    assert entry["confidence"] is None and entry["seconds"] is None and entry["page"] is None


@pytest.mark.parametrize(
    ("entry", "error", "message"),
    [
        (("", {"registered": True}), TypeError, "name: expected"),
        (("a", {}), ValueError, "a: the record has no 'registered'"),
        (("a", {"registered": True}, None, "http://x/y.png"), ValueError, "a: thumbnail"),
    ],
)
def test_a_wrong_entry_writes_nothing(tmp_path, entry, error, message) -> None:
    with pytest.raises(error, match=message):
        write_index(tmp_path / "index.html", [entry])
    assert list(tmp_path.iterdir()) == []


def pixels_of(url: str) -> np.ndarray:
    image = pytest.importorskip("matplotlib.image")
    data = base64.b64decode(url.removeprefix("data:image/png;base64,"))
    return np.asarray(image.imread(io.BytesIO(data), format="png"))


def test_the_thumbnail_shows_both_clouds(pair, solved) -> None:
    pixels = pixels_of(thumbnail(solved, pair.source, pair.target))
    assert pixels.shape == (HEIGHT, WIDTH, 4)
    drawn = pixels[pixels[..., 3] > 0]
    assert 0.05 < len(drawn) / (WIDTH * HEIGHT) < 0.95
    orange, blue = drawn[:, 0] > drawn[:, 2], drawn[:, 0] < drawn[:, 2]
    assert orange.mean() > 0.05 and blue.mean() > 0.05


def test_the_thumbnail_follows_the_pose(pair, solved) -> None:
    other = solved.transformation.copy()
    other[:3, 3] += solved.normalization_scale
    moved = thumbnail(other, pair.source, pair.target)
    assert moved != thumbnail(solved.transformation, pair.source, pair.target)
    alone = pixels_of(thumbnail(np.full((4, 4), np.nan), pair.source, pair.target))
    drawn = alone[alone[..., 3] > 0]
    assert len(drawn) and (drawn[:, 0] < drawn[:, 2]).all()
