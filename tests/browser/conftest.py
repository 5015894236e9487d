"""Headless Chromium, and pages for it. Without Chromium these tests are skipped: tools/browser."""

from __future__ import annotations

import io
import json
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pyemtr

HOSTILE = "</script><img src=x onerror=alert(1)>"
ARGUMENTS = (
    "--headless=new",
    "--no-sandbox",  # root has none
    "--disable-dev-shm-usage",
    "--hide-scrollbars",
    "--use-angle=swiftshader",  # WebGL without a graphics card
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--disable-component-update",
)


def relief(count: int, seed: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    u, v = rng.uniform(-1, 1, (2, count))
    w = 0.3 * np.sin(3 * u + v) * np.cos(2 * v) + 0.2 * np.exp(-8 * ((u - 0.3) ** 2 + v**2))
    return 100 * np.column_stack([u, v, w])


def box(count: int, seed: int) -> np.ndarray:
    """The surface of a box, which looks alike from two sides."""
    rng = np.random.default_rng(seed)
    points = rng.uniform(-1, 1, (count, 3))
    face = rng.integers(0, 3, count)
    points[np.arange(count), face] = rng.choice([-1, 1], count)
    return points * (3, 2, 1)


@pytest.fixture(scope="session")
def pages(tmp_path_factory) -> dict[str, Path]:
    """A registered pair, an ambiguous one, one that no pose is known of, and their index."""
    from pyemtr.html import IndexEntry, write_index
    from pyemtr.html.thumbnail import thumbnail

    folder = tmp_path_factory.mktemp("pages")
    quarter = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    clouds = {
        "registered": (relief(9000, 1) @ quarter + [300, -40, 10], relief(9000, 2)),
        "ambiguous": (box(5000, 3) @ quarter, box(5000, 4)),
    }
    found, entries = {}, []
    for name, (source, target) in clouds.items():
        result = pyemtr.register(source, target, seed=1, threads=2)
        found[name] = folder / f"{name}.html"
        result.to_html(found[name], source, target, unit="mm", names=(f"{name} a", f"{name} b"))
        entries.append(IndexEntry(name, result, found[name], thumbnail(result, source, target)))
    source, target = clouds["registered"]
    stopped = pyemtr.register(source, target, callback=lambda progress: True)
    found["stopped"] = folder / "stopped.html"
    stopped.to_html(found["stopped"], source, target, title=HOSTILE, names=(HOSTILE, HOSTILE))
    entries.append(IndexEntry(HOSTILE, stopped, found["stopped"]))
    found["index"] = folder / "index.html"
    write_index(found["index"], entries)
    return found


def lumps(count: int, seed: int, bumps: int) -> np.ndarray:
    """Points on a lumpy egg; ``bumps`` tells one egg from another."""
    rng = np.random.default_rng(seed)
    at = rng.normal(size=(count, 3))
    at /= np.linalg.norm(at, axis=1, keepdims=True)
    x, y, z = at.T
    height = 1 + 0.12 * np.sin(bumps * x + 1) * np.sin(5 * y) + 0.1 * np.sin(6 * z + 2 * x)
    return at * height[:, None] * [1.0, 0.8, 0.6]


@pytest.fixture(scope="session")
def models(tmp_path_factory) -> Path:
    """The page of two models and a scan that is left out."""
    pytest.importorskip("gtsam", reason="gtsam is not installed")
    clouds, names = [], []
    for bumps in (4, 7):
        body = lumps(9000, bumps, bumps)
        for k, side in enumerate([(1, 0, 0), (-0.6, 0.8, 0), (0, 1, 0.3)]):
            clouds.append(body[body @ np.array(side) > -0.25] + [3 * k, 0, 0])
            names.append(f"egg {bumps} side {k}")
    clouds.append(relief(2000, 9) / 100)
    folder = tmp_path_factory.mktemp("models")
    result = pyemtr.align_all(clouds, preset="fast", names=[*names, HOSTILE])
    assert [len(members) for members in result.models] == [3, 3]
    result.to_html(folder, unit="mm", title=HOSTILE)
    return folder / "index.html"


@pytest.fixture(scope="session")
def chromium() -> Iterator[Any]:
    webdriver = pytest.importorskip("selenium.webdriver", reason="selenium is not installed")
    program = os.environ.get("EMTR_CHROMIUM") or shutil.which("chromium")
    driver = shutil.which("chromedriver")
    if not program or not driver:
        pytest.skip("no chromium and chromedriver (tools/browser installs them)")
    options = webdriver.ChromeOptions()
    options.binary_location = program
    for argument in ARGUMENTS:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    browser = webdriver.Chrome(options=options, service=webdriver.ChromeService(driver))
    browser.set_page_load_timeout(120)
    browser.set_script_timeout(60)
    yield browser
    browser.quit()


class Page:
    """A page in the browser."""

    def __init__(self, browser: Any) -> None:
        self.browser = browser

    def open(self, path: Path, width: int = 1280, height: int = 900, scheme: str = "light") -> None:
        self.browser.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500},
        )
        self.browser.execute_cdp_cmd(
            "Emulation.setEmulatedMedia",
            {
                "features": [
                    {"name": "prefers-color-scheme", "value": scheme},
                    {"name": "prefers-reduced-motion", "value": "reduce"},
                ]
            },
        )
        for kind in ("browser", "performance"):
            self.browser.get_log(kind)
        self.browser.get(path.as_uri())

    def js(self, text: str, *arguments: Any) -> Any:
        return self.browser.execute_script(text, *arguments)

    def drawn(self) -> np.ndarray:
        """Pixels (H, W, 3) of the canvas alone, as it is drawn now; 0 to 1."""
        import base64

        from matplotlib.image import imread

        url = self.js(
            "emtrView.drawNow(); return document.getElementById('canvas').toDataURL('image/png');"
        )
        data = base64.b64decode(url.split(",")[1])
        return np.asarray(imread(io.BytesIO(data), format="png"))[..., :3]

    def share_drawn(self) -> float:
        """The share of the pixels that are not the ground."""
        pixels = self.drawn()
        return float((np.abs(pixels - pixels[2, 2]).max(axis=2) > 0.02).mean())

    def click(self, name: str) -> None:
        self.js("document.getElementById(arguments[0]).click()", name)

    def complaints(self) -> list[str]:
        return [
            entry["message"]
            for entry in self.browser.get_log("browser")
            if entry["level"] in ("SEVERE", "WARNING") and "GPU stall" not in entry["message"]
        ]

    def requests(self) -> list[str]:
        messages = [
            json.loads(e["message"])["message"] for e in self.browser.get_log("performance")
        ]
        return [
            message["params"]["request"]["url"]
            for message in messages
            if message["method"] == "Network.requestWillBeSent"
        ]


@pytest.fixture
def page(chromium) -> Page:
    return Page(chromium)
