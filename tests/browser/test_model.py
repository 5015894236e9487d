"""The page of many scans in a browser: models, scans that are switched off, the pose graph."""

from __future__ import annotations

import numpy as np
import pytest


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_it_loads_nothing_and_has_nothing_to_complain_of(page, models, scheme) -> None:
    page.open(models, scheme=scheme)
    page.js("await new Promise((done) => setTimeout(done, 200));")
    assert page.complaints() == []
    assert page.requests() == [models.as_uri()]
    assert page.share_drawn() > 0.05
    assert page.js("return document.querySelectorAll('img').length") == 0  # a name is text


def test_a_phone_scrolls_in_one_direction_only(page, models) -> None:
    page.open(models, width=390, height=844)
    assert page.js("return document.documentElement.scrollWidth") <= 390
    assert page.js("return document.querySelector('.view').clientHeight") < 844
    assert page.share_drawn() > 0.05


def test_each_scan_has_a_color_and_can_be_switched_off(page, models) -> None:
    page.open(models)
    first = page.drawn()
    colors = page.js(
        "return [...document.querySelectorAll('#scans .dot')].map((d) => d.style.background)"
    )
    assert len(colors) == len(set(colors)) == 3
    shown = [first]
    for scan in range(3):
        page.click(f"scan-{scan}")
        shown.append(page.drawn())
        page.click(f"scan-{scan}")
        assert np.array_equal(page.drawn(), first)
    for i, one in enumerate(shown):
        assert all(np.abs(one - other).max() > 0.1 for other in shown[:i])
    page.click("none")
    assert page.share_drawn() == 0
    page.click("all")
    assert np.array_equal(page.drawn(), first)


def test_the_other_model_is_shown_when_it_is_chosen(page, models) -> None:
    page.open(models)
    first = page.drawn()
    page.click("model-1")
    assert page.share_drawn() > 0.05 and np.abs(page.drawn() - first).max() > 0.1
    names = page.js("return [...document.querySelectorAll('#scans label')].map((l) => l.innerText)")
    assert names == [f"egg 7 side {k}" for k in range(3)]
    page.click("model-0")
    assert np.array_equal(page.drawn(), first)


def test_the_graph_tells_why_a_pair_was_taken_or_not(page, models) -> None:
    page.open(models)
    lines = "#graph .edge"
    count = page.js(f"return document.querySelectorAll('{lines}').length")
    assert count == page.js("return edges.length") > 6
    assert page.js(f"return document.querySelectorAll('{lines}:not(.refused)').length") >= 4
    for kind, word in ((".refused", "not taken"), (":not(.refused)", ": taken")):
        page.js(f"document.querySelector('{lines}{kind}').dispatchEvent(new Event('click'))")
        text = page.js("return document.getElementById('chosen').innerText")
        assert word in text and "probability" in text
    link = page.js("return document.querySelector('#chosen a').href")
    assert link.startswith(models.parent.as_uri() + "/pairs/")


def test_the_edges_are_sorted_and_lead_to_their_pages(page, models) -> None:
    page.open(models)
    probabilities = "return edges.map((e) => e.probability).sort((a, b) => a - b)"
    rows = "[...document.querySelectorAll('#edges tbody tr')]"
    names = f"return {rows}.map((r) => r.children[0].innerText)"
    first = page.js(names)
    assert len(first) == len(page.js(probabilities))
    page.js("document.querySelectorAll('#edges th button')[3].click()")
    last = page.js(names)
    assert first != last and sorted(first) == sorted(last)
    page.click("only")
    assert 0 < len(page.js(f"return {rows}")) < len(first)
    href = page.js("return document.querySelector('#edges tbody a').getAttribute('href')")
    page.open(models.parent / href)
    assert page.share_drawn() > 0.05 and page.complaints() == []


def test_without_webgl_the_rest_of_the_page_is_there(page, models) -> None:
    script = page.browser.execute_cdp_cmd(
        "Page.addScriptToEvaluateOnNewDocument",
        {"source": "HTMLCanvasElement.prototype.getContext = () => null;"},
    )
    try:
        page.open(models)
        text = page.js("return document.body.innerText")
        assert "has no WebGL" in text and "left out" in text
        page.click("model-1")
        page.click("scan-3")
        assert page.js("return document.querySelectorAll('#graph .edge').length") > 6
    finally:
        page.browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", script)
