"""The template of the pages, and the one place of a page where its data go."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

TEMPLATE = Path(__file__).resolve().parent / "template"

# What stands for the contents of which files in the templates, in the order in which it is put in.
# CMake has the list of the page for the command in tools/pcl_emtr/html/template.cmake.
PAGE_PARTS: dict[str, tuple[str, ...]] = {
    "@head@": ("head.html",),
    "@header@": ("header.html",),
    "@view@": ("view.html",),
    "@style@": ("page.css",),
    "@advice@": ("advice.json",),
    "@three@": ("three.min.js",),
    "@script@": ("charts.js", "scene.js", "pair_view.js", "page.js"),
}
INDEX_PARTS: dict[str, tuple[str, ...]] = {
    "@head@": ("head.html",),
    "@style@": ("page.css", "table.css"),
    "@script@": ("charts.js", "table.js", "index.js"),
}
MODEL_PARTS: dict[str, tuple[str, ...]] = {
    "@head@": ("head.html",),
    "@header@": ("header.html",),
    "@view@": ("view.html",),
    "@style@": ("page.css", "table.css", "model.css"),
    "@three@": ("three.min.js",),
    "@script@": ("charts.js", "table.js", "scene.js", "model_view.js", "model.js"),
}


def page_with(payload: dict[str, Any]) -> str:
    """Returns the page of one registration with its data inside."""
    return _filled("page.html", PAGE_PARTS, payload)


def index_with(payload: dict[str, Any]) -> str:
    """Returns the index with its data inside."""
    return _filled("index.html", INDEX_PARTS, payload)


def model_with(payload: dict[str, Any]) -> str:
    """Returns the page of many scans with its data inside."""
    return _filled("model.html", MODEL_PARTS, payload)


def as_json(payload: dict[str, Any]) -> str:
    """Returns JSON that can stand in an HTML page: no name ends the script that it is in."""
    text = json.dumps(payload, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c")


def _filled(name: str, parts: dict[str, tuple[str, ...]], payload: dict[str, Any]) -> str:
    before, after = template(name, tuple(parts.items())).split("@payload@")
    return before + as_json(payload) + after


@cache
def template(name: str, parts: tuple[tuple[str, tuple[str, ...]], ...]) -> str:
    """Returns the template with its style and scripts inside, and "@payload@" for the data."""
    text = (TEMPLATE / name).read_text(encoding="utf-8")
    for mark, files in parts:
        content = "".join((TEMPLATE / file).read_text(encoding="utf-8") for file in files)
        text = text.replace(mark, content)
    return text
