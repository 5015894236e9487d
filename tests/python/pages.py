"""The project's pages, and what they are made of."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")])


def name(page: Path) -> str:
    return page.relative_to(ROOT).as_posix()


def snippets(page: Path) -> list[tuple[str, str]]:
    """Language and text of each fenced block."""
    return re.findall(r"^```(\w*)\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL)


def prose(page: Path) -> str:
    """The page without its fenced blocks; their lines stay, empty."""
    return re.sub(
        r"^```.*?^```$",
        lambda block: "\n" * block[0].count("\n"),
        page.read_text(),
        flags=re.MULTILINE | re.DOTALL,
    )


def anchors(page: Path) -> set[str]:
    """What a link to one of the page's headings has behind its #."""
    heads = re.findall(r"^#+ (.+)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


def paths(page: Path) -> list[str]:
    """What stands in backticks and is a path, or a command line that begins with one."""
    quoted = [text.split()[0] for text in re.findall(r"`([^`\n]+)`", prose(page)) if text.strip()]
    return [text for text in quoted if "/" in text and re.fullmatch(r"\w[\w.\-/]*", text)]


def marked(page: Path, mark: str) -> str:
    """What stands between <!-- mark: begin --> and <!-- mark: end -->."""
    return page.read_text().split(f"<!-- {mark}: begin -->\n")[1].split(f"<!-- {mark}: end -->")[0]
