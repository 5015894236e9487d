#!/usr/bin/env python3
"""Makes the two made files of the template in pyemtr/html/template, and tells if they are old.

html_template.py            compare advice.json with docs/TROUBLESHOOTING.md; 1 if it is old
html_template.py --write    write advice.json: what to try, by reason, in the words of that page
html_template.py --three    make three.min.js from its package in the npm registry (needs npm and a
                            network): the parts of three.js that the page uses, with its license
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TEMPLATE = ROOT / "pyemtr" / "html" / "template"
ADVICE = TEMPLATE / "advice.json"
LIBRARY = TEMPLATE / "three.min.js"
PAGE = ROOT / "docs" / "TROUBLESHOOTING.md"

THREE = "three@0.187.0"
ESBUILD = "esbuild@0.28.2"
ENTRY = """\
export {Box3, BufferAttribute, BufferGeometry, DepthTexture, Matrix4, Mesh, PerspectiveCamera,
  Points, Quaternion, Scene, ShaderMaterial, Spherical, Vector2, Vector3, WebGLRenderTarget,
  WebGLRenderer} from "three";
export {OrbitControls} from "three/addons/controls/OrbitControls.js";
"""


def advice() -> str:
    """The sections of the reasons as JSON: {reason: {"meaning": [paragraph], "try": [action]}}."""
    page = PAGE.read_text(encoding="utf-8")
    text = page.split("## The reasons\n")[1].split("\n## ")[0]
    sections = re.findall(r"^### `(\w+)`\n\n(.+?)(?=^### |\Z)", text, re.MULTILINE | re.DOTALL)
    told = {name: _told(section) for name, section in sections}
    wrong = page.split("## Registered, but wrong\n")[1].split("```")[0]
    told["registered"]["try"] = _told(wrong)["try"]
    return json.dumps(told, indent=1, ensure_ascii=False).replace("<", "\\u003c") + "\n"


def _told(section: str) -> dict[str, list[str]]:
    blocks = re.split(r"\n\n|\n(?=\* )", section.strip())
    return {
        "meaning": [_plain(block) for block in blocks if not block.startswith("* ")],
        "try": [_plain(block[2:]) for block in blocks if block.startswith("* ")],
    }


def _plain(markdown: str) -> str:
    """One line, links as their text. What is in backticks keeps them. A sentence that only sends
    the reader on, to another place of the page, is left out."""
    markdown = re.sub(r"(?<=[.:]) [^.:]+: see\s\[[^\]]+\]\(#[^)]+\)\.|$", "", markdown)
    return " ".join(re.sub(r"\[([^\]]+)\]\([^)]+\)", r"\1", markdown).split())


def make_library() -> None:
    """Installs both packages into a temporary folder and writes the library."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run(
            ["npm", "install", "--no-save", "--no-audit", "--no-fund", THREE, ESBUILD],
            cwd=folder, check=True,
        )  # fmt: skip
        (folder / "entry.js").write_text(ENTRY)
        terms = (folder / "node_modules" / "three" / "LICENSE").read_text(encoding="utf-8")
        banner = f"/*! {THREE}, https://threejs.org\n\n{terms.strip()}\n*/"
        subprocess.run(
            [
                "node_modules/.bin/esbuild", "entry.js", "--bundle", "--minify", "--format=iife",
                "--global-name=THREE", "--legal-comments=none", "--charset=ascii",
                f"--banner:js={banner}", f"--outfile={LIBRARY}",
            ],
            cwd=folder, check=True,
        )  # fmt: skip


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--write", action="store_true", help="write advice.json")
    parser.add_argument("--three", action="store_true", help="make three.min.js again")
    options = parser.parse_args()
    if options.three:
        make_library()
    if options.write:
        ADVICE.write_text(advice(), encoding="utf-8")
    if ADVICE.read_text(encoding="utf-8") == advice():
        return 0
    print(f"{ADVICE} is old: run tools/html_template.py --write", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
