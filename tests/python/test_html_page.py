"""The page of one registration: what it says, and that it is whole, closed and safe."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial import cKDTree

import pyemtr
from pyemtr.html import template_files
from pyemtr.html.page import page_payload
from pyemtr.html.point_block import jittered, point_block

ROOT = Path(__file__).resolve().parents[2]
TEMPLATE = ROOT / "pyemtr" / "html" / "template"
HOSTILE = "</script><img src=x onerror=alert(1)><!--"


@pytest.fixture(scope="module")
def solved(pair) -> pyemtr.Result:
    return pyemtr.register(pair.source, pair.target, preset="fast", threads=2)


@pytest.fixture
def page(pair, solved, tmp_path) -> str:
    solved.to_html(tmp_path / "page.html", pair.source, pair.target, unit="mm")
    assert [path.name for path in tmp_path.iterdir()] == ["page.html"]
    return (tmp_path / "page.html").read_text(encoding="utf-8")


def payload_of(page: str) -> dict[str, Any]:
    (text,) = re.findall(
        r'<script type="application/json" id="payload">(.*?)</script>', page, re.DOTALL
    )
    return json.loads(text)


def unpacked(text: str) -> np.ndarray:
    return np.frombuffer(base64.b64decode(text), dtype="<u2")


def points_of(block: dict[str, Any]) -> np.ndarray:
    return block["origin"] + block["step"] * unpacked(block["points"]).reshape(-1, 3)


def test_the_report_has_every_field_of_the_result(page, solved) -> None:
    report = payload_of(page)["report"]
    flat = {**report, **report["quality"], **report["counts"], **report["normalization"]}
    values = solved.to_dict()
    for name in ("registered", "reason", "reason_text", "confidence", "transformation", "score"):
        assert flat[name] == values[name], name
    assert report["alternatives"] == values["alternatives"]
    assert report["history"] == values["history"] and report["seconds"] == values["timings"]
    assert set(report["settings"]) == set(pyemtr.settings())
    assert flat["read_source"] == values["points_source"] + values["dropped_source"]


def test_the_points_are_those_of_the_clouds(page, pair) -> None:
    clouds = payload_of(page)["clouds"]
    for name, cloud in (("source", pair.source), ("target", pair.target)):
        block = clouds[name]
        shown = points_of(block)
        assert len(shown) == block["shown"] and block["total"] == len(cloud)
        gaps, _ = cKDTree(cloud).query(shown, p=np.inf)
        assert gaps.max() <= 0.5 * block["step"] * (1 + 1e-6)


def test_the_residuals_are_those_of_each_pose(page, pair, solved) -> None:
    payload = payload_of(page)
    poses = [solved.transformation, *(other.transformation for other in solved.alternatives)]
    assert len(payload["residuals"]) == len(poses)
    shown = points_of(payload["clouds"]["source"])
    for entry, pose in zip(payload["residuals"], poses):
        wanted = pyemtr.residuals(shown, pair.target, pose)
        found = unpacked(entry["values"]) / 65535 * entry["maximum"]
        assert np.abs(found - wanted).max() < 1e-4 * entry["maximum"]


def test_it_loads_nothing(page) -> None:
    assert "default-src 'none'" in page
    markup = re.sub(r"<script.*?</script>", "", page, flags=re.DOTALL)
    assert not re.search(r"(?:\b(?:src|href|action)\s*=|url\()\s*[\"']?\w+:", markup)
    assert "<link" not in markup and "@import" not in markup
    own = "".join(path.read_text() for path in TEMPLATE.glob("*.js") if path.name != "three.min.js")
    assert not re.search(
        r"innerHTML|document\.write|eval\(|fetch\(|XMLHttp|import\(|https?:(?!//www\.w3\.org/2000/svg)",
        own,
    )


def test_sixty_thousand_points_stay_below_three_megabytes(solved, tmp_path) -> None:
    grid = np.linspace(-1, 1, 400)
    x, y = (axis.ravel() for axis in np.meshgrid(grid, grid))
    cloud = np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y)])
    solved = pyemtr.register(cloud[::40], cloud[:120_000:40], preset="fast", threads=2)
    solved.to_html(tmp_path / "large.html", cloud, cloud[:120_000])
    block = payload_of((tmp_path / "large.html").read_text())["clouds"]["source"]
    assert 15_000 < block["shown"] <= 30_000
    assert (tmp_path / "large.html").stat().st_size < 3e6


def test_names_are_data_and_never_markup(pair, solved, tmp_path) -> None:
    path = tmp_path / "page.html"
    solved.to_html(
        path, pair.source, pair.target, title=HOSTILE, names=(HOSTILE, "b"), unit=HOSTILE
    )
    page = path.read_text()
    assert "<img" not in page
    payload = payload_of(page)
    assert payload["title"] == HOSTILE == payload["report"]["files"]["source"]
    assert payload["unit"] == HOSTILE


def test_a_file_gives_its_name(pair, solved, tmp_path) -> None:
    np.save(tmp_path / "scan one.npy", pair.source)
    payload = page_payload(solved, tmp_path / "scan one.npy", pair.target)
    assert payload["report"]["files"] == {"source": "scan one.npy", "target": "target"}


def test_the_axis_of_the_registration_is_up(pair) -> None:
    result = pyemtr.register(pair.source, pair.target, preset="fast", axis=(0, 1, 0), iterations=2)
    assert page_payload(result, pair.source, pair.target)["up"] == [0, 1, 0]
    assert page_payload(result, pair.source, pair.target, up=(1, 0, 0))["up"] == [1, 0, 0]


def test_without_a_pose_the_page_has_no_residuals(pair) -> None:
    source, target = pair.source + 1000, pair.target * 1000  # nothing was measured of them
    result = pyemtr.register(source, target, callback=lambda progress: True)
    payload = page_payload(result, source, target)
    assert result.reason == payload["report"]["reason"] == "interrupted"
    assert np.isnan(result.transformation).any() and payload["residuals"] == []
    assert payload["report"]["transformation"][0][0] is None
    for cloud, points in (("source", source), ("target", target)):
        assert payload["clouds"][cloud]["shown"] == len(points)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"max_points": 0}, "max_points: expected 1 to"),
        ({"max_points": 10**7}, "max_points: expected 1 to"),
        ({"up": (0, 0, 0)}, "up: expected a direction"),
        ({"names": "ab"}, "names: expected two names"),
        ({"names": ("a",)}, "names: expected two names"),
    ],
)
def test_wrong_arguments_write_nothing(pair, solved, tmp_path, arguments, message) -> None:
    with pytest.raises(ValueError, match=message):
        solved.to_html(tmp_path / "page.html", pair.source, pair.target, **arguments)
    with pytest.raises(ValueError, match=r"source: expected .* finite"):
        solved.to_html(tmp_path / "page.html", np.full((20, 3), np.nan), pair.target)
    with pytest.raises(FileNotFoundError):
        solved.to_html(tmp_path / "none" / "page.html", pair.source, pair.target)
    assert list(tmp_path.iterdir()) == []


def test_strays_are_not_shown() -> None:
    rng = np.random.default_rng(3)
    cloud = rng.uniform(-1, 1, (500, 3))
    far = np.vstack([cloud, [[480.0, 0, 0], [np.nan, 0, 0], [np.inf, 0, 0]]])
    block = point_block(far, np.zeros(3), 2.0, 1000)
    assert (len(block.points), block.total) == (500, 503)
    assert block.step < 1e-4


def test_thinning_is_even_in_space() -> None:
    rng = np.random.default_rng(4)
    dense = rng.uniform(0, 0.1, (27_000, 3)) * (1, 1, 0)
    sparse = rng.uniform(0, 1, (5_000, 3)) * (1, 1, 0)
    cloud = np.concatenate([dense, sparse])
    block = point_block(cloud, np.full(3, np.nan), np.nan, 4000)
    corner = (block.points[:, :2] < 0.1).all(axis=1).mean()
    assert 2000 < len(block.points) <= 4000
    assert corner < 0.05  # 1 % of the area, 84 % of the points


def test_rows_are_spread_over_all_without_a_period() -> None:
    rows = jittered(10_000_000, 8_000)
    assert len(rows) == 8_000 and rows[0] < 1250 and rows[-1] >= 10_000_000 - 1250
    assert (np.diff(rows) > 0).all() and len(set(np.diff(rows).tolist())) > 100
    assert jittered(5, 8).tolist() == [0, 1, 2, 3, 4]


def test_a_cloud_of_one_place_and_large_coordinates() -> None:
    block = point_block(np.full((3, 3), 5e6), np.zeros(3), np.nan, 10)
    assert block.step == 1 and block.points.tolist() == [[5e6] * 3]
    rng = np.random.default_rng(5)
    block = point_block(rng.uniform(5e6, 5e6 + 100, (100, 3)), np.zeros(3), np.nan, 100)
    assert np.abs(block.origin + block.step * block.steps - block.points).max() < 1e-3


def test_the_library_is_the_one_that_was_reviewed() -> None:
    """three.js 0.187.0, MIT, as tools/html_template.py --three makes it."""
    library = (TEMPLATE / "three.min.js").read_bytes()
    assert hashlib.sha256(library).hexdigest() == (
        "a9fc1ef5bc95598f53a98b1e3915a75343ace1493df0dcb12b92710de7244be1"
    )
    assert b"three@0.187.0" in library and b"The MIT License" in library
    assert b"Permission is hereby granted" in library


def test_the_advice_is_that_of_the_page_about_failures() -> None:
    done = subprocess.run(
        [sys.executable, ROOT / "tools" / "html_template.py"],
        check=False,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    reasons = json.loads((TEMPLATE / "advice.json").read_text())
    declared = re.findall(
        r"EMTR_REASON_(\w+) = ", (ROOT / "libemtr/include/emtr/emtr.h").read_text()
    )
    assert sorted(reasons) == sorted(name.lower() for name in declared)
    for told in reasons.values():
        assert told["meaning"] and not any("](" in text for text in told["meaning"] + told["try"])


@pytest.mark.parametrize("name", [p.name for p in TEMPLATE.glob("*.js*")])
def test_no_part_ends_the_script_that_it_is_in(name: str) -> None:
    text = (TEMPLATE / name).read_text(encoding="utf-8").lower()
    assert "</script" not in text and "<!--" not in text and "]]>" not in text
    assert ")emtr_page" not in text  # nor the literal that the command has it in
    assert not re.search(r"@(?:payload|style|three|script|advice)@", text)


def test_each_mark_is_filled_once() -> None:
    for name, parts in (
        ("page.html", template_files.PAGE_PARTS),
        ("index.html", template_files.INDEX_PARTS),
        ("model.html", template_files.MODEL_PARTS),
    ):
        text = (TEMPLATE / name).read_text()
        for mark, files in parts.items():
            if files[0].endswith(".html"):  # a part of several pages, with marks of its own
                text = text.replace(mark, (TEMPLATE / files[0]).read_text() + mark)
        assert {*re.findall(r"@\w+@", text)} == {*parts, "@payload@"}
        assert all(text.count(mark) == 1 for mark in parts)
        whole = template_files.template(name, tuple(parts.items()))
        assert whole.count("@payload@") == 1


def test_labels_belong_to_controls_and_ids_are_single() -> None:
    parts = {
        "page.html": template_files.PAGE_PARTS,
        "index.html": template_files.INDEX_PARTS,
        "model.html": template_files.MODEL_PARTS,
    }
    for name, marks in parts.items():
        text = re.sub(
            r"<script.*?</script>", "", template_files.template(name, tuple(marks.items())),
            flags=re.DOTALL,
        )  # fmt: skip
        text += "".join(
            re.findall(r"<script[^>]*>", template_files.template(name, tuple(marks.items())))
        )
        ids = re.findall(r'\bid="([\w-]+)"', text)
        assert len(ids) == len(set(ids))
        assert set(re.findall(r'(?:for|aria-labelledby)="([\w-]+)"', text)) <= set(ids)
        script = "".join(
            (TEMPLATE / part).read_text()
            for part in marks["@script@"]
            if part not in ("charts.js", "table.js")
        )
        assert set(re.findall(r'byId\("([\w-]+)"\)', script)) <= set(ids)


def test_module_of_pages_is_documented() -> None:
    import pyemtr.html

    for name in pyemtr.html.__all__:
        assert getattr(pyemtr.html, name).__doc__
