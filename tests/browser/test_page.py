"""The page of one registration in a browser: drawn, quiet, alone, by keyboard and on a phone."""

from __future__ import annotations

import numpy as np
import pytest

CANVAS = "return document.getElementById('canvas')"


@pytest.mark.parametrize("name", ["registered", "ambiguous", "stopped", "index"])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_it_loads_nothing_and_has_nothing_to_complain_of(page, pages, name, scheme) -> None:
    page.open(pages[name], scheme=scheme)
    page.js("await new Promise((done) => setTimeout(done, 200));")
    assert page.complaints() == []
    assert [url for url in page.requests() if not url.startswith("data:image/png")] == [
        pages[name].as_uri()
    ]


@pytest.mark.parametrize("name", ["registered", "ambiguous", "stopped", "index"])
def test_a_phone_scrolls_in_one_direction_only(page, pages, name) -> None:
    page.open(pages[name], width=390, height=844)
    assert page.js("return document.documentElement.scrollWidth") <= 390
    if name != "index":
        page.js("for (const d of document.querySelectorAll('details')) d.open = true;")
        assert page.js("return document.documentElement.scrollWidth") <= 390
        assert page.share_drawn() > 0.05
        assert page.js("return document.querySelector('.view').clientHeight") < 844


def test_each_toggle_changes_what_is_drawn(page, pages) -> None:
    page.open(pages["registered"])
    first = page.drawn()
    assert page.share_drawn() > 0.05
    for name in ("show-target", "show-before", "show-aligned", "show-error"):
        page.click(name)
        other = page.drawn()
        assert page.share_drawn() > 0.02, name
        assert np.abs(other - first).max(axis=2).mean() > 0.002, name
        page.click(name)
        assert np.array_equal(page.drawn(), first), name
    for name in ("show-target", "show-aligned"):
        page.click(name)
    assert page.share_drawn() == 0


def test_the_source_goes_from_before_to_after(page, pages) -> None:
    page.open(pages["registered"])
    after = page.drawn()
    for value in ("0", "0.5"):
        page.js(
            "const e = document.getElementById('progress'); e.value = arguments[0];"
            "e.dispatchEvent(new Event('input'));",
            value,
        )
        assert page.share_drawn() > 0.01
        assert np.abs(page.drawn() - after).mean() > 0.01
    page.click("play")  # with reduced motion at once
    assert page.js("return emtrView.progress") == 1


def test_point_size_and_error_scale(page, pages) -> None:
    page.open(pages["registered"])
    page.click("show-error")
    shares, texts = [], []
    for size, limit in (("0.5", "-1"), ("3", "1")):
        for name, value in (("size", size), ("limit", limit)):
            page.js(
                "const e = document.getElementById(arguments[0]); e.value = arguments[1];"
                "e.dispatchEvent(new Event('input'));",
                name,
                value,
            )
        shares.append(page.share_drawn())
        texts.append(page.js("return document.getElementById('ramp-end').textContent"))
    assert shares[1] > shares[0]
    assert float(texts[1].split()[0]) == pytest.approx(4 * float(texts[0].split()[0]), rel=0.02)
    assert texts[0].endswith(" mm")


def test_an_alternative_is_shown_when_it_is_chosen(page, pages) -> None:
    page.open(pages["ambiguous"])
    first = page.drawn()
    matrix = page.js("return document.getElementById('matrix').textContent")
    page.click("pose-1")
    assert np.abs(page.drawn() - first).max() > 0.1
    assert page.js("return document.getElementById('matrix').textContent") != matrix
    assert page.js("return document.querySelectorAll('tr.chosen').length") == 1
    page.click("pose-0")
    assert np.array_equal(page.drawn(), first)


def test_the_keyboard_reaches_and_moves_everything(page, pages) -> None:
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.keys import Keys

    page.open(pages["ambiguous"])
    order = []
    for _ in range(14):
        ActionChains(page.browser).send_keys(Keys.TAB).perform()
        order.append(page.js("return document.activeElement.id"))
    begin = ["canvas", "show-target", "show-before", "show-aligned", "show-error", "progress"]
    assert order[: len(begin)] == begin
    assert {"size", "limit", "play", "reset", "copy", "pose-0"} <= set(order)

    page.js("document.getElementById('canvas').focus()")
    seen = [page.js("return emtrView.camera.position.toArray()")]
    for keys in (Keys.ARROW_LEFT, Keys.ARROW_UP, "+", "-", Keys.SHIFT + Keys.ARROW_RIGHT):
        ActionChains(page.browser).send_keys(keys).perform()
        ActionChains(page.browser).key_up(Keys.SHIFT).perform()
        seen.append(page.js("return emtrView.camera.position.toArray()"))
    assert all(not np.allclose(a, b) for a, b in zip(seen, seen[1:]))
    ActionChains(page.browser).send_keys(Keys.HOME).perform()
    assert np.allclose(page.js("return emtrView.camera.position.toArray()"), seen[0])

    page.js("document.getElementById('progress').focus()")
    ActionChains(page.browser).send_keys(Keys.ARROW_LEFT * 3).perform()
    assert page.js("return emtrView.progress") == pytest.approx(0.97)


def test_the_verdict_in_plain_words(page, pages) -> None:
    page.open(pages["registered"])
    text = page.js("return document.body.innerText")
    assert "✓ Registered" in text and "The clouds are registered." in text
    page.open(pages["ambiguous"])
    text = page.js("return document.body.innerText")
    assert "✕ Not registered" in text and "a clearly different pose fits about as well" in text
    assert "What to try" in text and "The shape is symmetric" in text


def test_the_scale_bar_is_as_long_as_it_says(page, pages) -> None:
    page.open(pages["registered"])
    page.drawn()
    length = float(page.js("return document.getElementById('scale-text').textContent").split()[0])
    width = page.js("return document.getElementById('scale-bar').getBoundingClientRect().width")
    wanted = page.js(
        """
        const { camera, controls, canvas } = emtrView;
        const side = new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
        const a = controls.target.clone().project(camera);
        const b = controls.target.clone().addScaledVector(side, arguments[0]).project(camera);
        return (b.x - a.x) / 2 * canvas.clientWidth;
        """,
        length,
    )
    assert width == pytest.approx(wanted, rel=0.01)


def test_hostile_names_are_text(page, pages) -> None:
    page.open(pages["stopped"])
    assert page.js("return document.querySelectorAll('img').length") == 0
    assert "<img src=x onerror" in page.js("return document.getElementById('title').textContent")
    page.open(pages["index"])
    assert page.js("return document.querySelectorAll('img').length") == 2
    assert "<img src=x onerror" in page.js("return document.body.innerText")


def test_charts_are_drawn(page, pages) -> None:
    page.open(pages["registered"])
    assert page.js("return document.querySelectorAll('#residuals rect').length") == 40
    assert page.js("return document.querySelectorAll('#convergence polyline').length") >= 3
    assert "sparse" in page.js("return document.getElementById('convergence').textContent")
    assert page.js("return document.querySelectorAll('#timings .bars i').length") >= 8


def test_without_webgl_the_rest_of_the_page_is_there(page, pages) -> None:
    script = page.browser.execute_cdp_cmd(
        "Page.addScriptToEvaluateOnNewDocument",
        {"source": "HTMLCanvasElement.prototype.getContext = () => null;"},
    )
    try:
        page.open(pages["registered"])
        text = page.js("return document.body.innerText")
        assert "has no WebGL" in text and "The clouds are registered." in text
        assert page.js("return document.querySelectorAll('#residuals rect').length") == 40
        assert page.js("return document.querySelectorAll('#poses input').length") >= 1
    finally:
        page.browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", script)


def test_the_index_is_sorted_by_the_head_that_is_pressed(page, pages) -> None:
    page.open(pages["index"])
    names = (
        "return [...document.querySelectorAll('tbody tr')].map((r) => r.children[1].textContent)"
    )
    assert page.js(names)[:2] == ["ambiguous", "registered"]
    assert page.js(names)[2].startswith("</script>")  # of unknown confidence
    press = "document.querySelectorAll('th button')[arguments[0]].click()"
    page.js(press, 2)
    assert page.js(names)[:2] == ["registered", "ambiguous"]
    heads = "return [...document.querySelectorAll('th')].map((h) => h.getAttribute('aria-sort'))"
    assert page.js(heads)[3] == "descending" and page.js(heads).count(None) == 7
    page.js(press, 0)
    assert page.js(names)[1:] == ["ambiguous", "registered"]
    page.click("only")
    assert len(page.js(names)) == 2
    link = page.js("return document.querySelector('tbody a[href=\"ambiguous.html\"]').href")
    assert link == pages["ambiguous"].as_uri()
