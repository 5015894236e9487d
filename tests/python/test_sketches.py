"""Programs in the docs that need a robot or a cluster, and are not run: they compile, all that they
import is used, and what they call of pyemtr is there with these arguments."""

from __future__ import annotations

import ast
import inspect
import re
from pathlib import Path

import pytest

import pyemtr

DOCS = Path(__file__).resolve().parents[2] / "docs"
BLOCK = re.compile(r"^```text\n(.*?)^```", re.MULTILINE | re.DOTALL)
SKETCHES = {
    f"{page.name} {number}": text
    for page in sorted(DOCS.glob("*.md"))
    for number, text in enumerate(BLOCK.findall(page.read_text()))
    if re.match(r"(import|from) \w+", text)
}


def test_there_are_sketches() -> None:
    assert any("rclpy.spin" in text for text in SKETCHES.values())
    assert any("SLURMCluster" in text for text in SKETCHES.values())


@pytest.mark.parametrize("name", SKETCHES)
def test_it_compiles_and_uses_what_it_imports(name: str) -> None:
    tree = ast.parse(SKETCHES[name])
    compile(tree, name, "exec")
    imported = {
        (alias.asname or alias.name).split(".")[0]
        for node in ast.walk(tree)
        if isinstance(node, (ast.Import, ast.ImportFrom))
        for alias in node.names
    }
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    assert imported <= used


@pytest.mark.parametrize("name", SKETCHES)
def test_what_it_calls_of_pyemtr_is_there(name: str) -> None:
    for node in ast.walk(ast.parse(SKETCHES[name])):
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)):
            continue
        if isinstance(node.func.value, ast.Name) and node.func.value.id == "pyemtr":
            called = inspect.signature(getattr(pyemtr, node.func.attr))
            given = {word.arg: None for word in node.keywords if word.arg}
            known = called.parameters.keys() | pyemtr.settings().keys()
            assert given.keys() <= known
            called.bind(*node.args, **given)
