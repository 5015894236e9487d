#!/usr/bin/env python3
"""Prints the manual page of pcl_emtr, made of its --help-all, or writes it.

man_page.py            print the page
man_page.py --write    replace tools/pcl_emtr/shell/pcl_emtr.1

The command is build/tools/pcl_emtr, or what the variable EMTR_CLI names.
"""

import argparse
import os
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "tools" / "pcl_emtr" / "shell" / "pcl_emtr.1"
OPTION = re.compile(r"^  (-\S.*?|\w+ FILE)(?:  +(.*))?$")


def escaped(text: str) -> str:
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in ".'" else text


def options(lines: list[str]) -> list[str]:
    """A paragraph for each option of a group: its names in bold, and what it does."""
    out = []
    for line in lines:
        option = OPTION.match(line)
        if option and not line.startswith("   "):
            out += [".TP", f".B {escaped(option[1].replace(',', ', '))}"]
            out += [escaped(option[2])] if option[2] else []
        elif line.strip():
            out.append(escaped(line.strip()))
    return out


def as_they_are(lines: list[str]) -> list[str]:
    return [".nf", *(escaped(line) for line in lines if line.strip()), ".fi"]


def page(text: str) -> str:
    """The help's own titles become sections; those of options are subsections."""
    head, *parts = re.split(r"^(\S.*):\n", text, flags=re.MULTILINE)
    description, _, usage = head.partition("Usage: ")
    out = [
        '.\\" Made by tools/man_page.py of what pcl_emtr --help-all prints.',
        '.TH PCL_EMTR 1 "" "emtr"',
        ".SH NAME",
        "pcl_emtr \\- register two partly overlapping point clouds without an initial guess",
        ".SH SYNOPSIS",
        f".B {escaped(usage.strip())}",
        ".SH DESCRIPTION",
        *(escaped(line) for line in description.strip().splitlines()),
        ".SH OPTIONS",
    ]
    for title, body in zip(parts[::2], parts[1::2], strict=True):
        lines = body.rstrip().splitlines()
        if title.startswith("Formats,") or title in ("Examples", "Notes", "Exit codes"):
            out += [f".SH {escaped(title.upper())}", *as_they_are(lines)]
        else:
            out += [f".SS {escaped(title)}", *options(lines)]
    return "\n".join(out) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description="The manual page of pcl_emtr.")
    parser.add_argument("--write", action="store_true", help=f"into {PAGE.name}")
    arguments = parser.parse_args()
    command = os.environ.get("EMTR_CLI", str(ROOT / "build" / "tools" / "pcl_emtr"))
    done = subprocess.run([command, "--help-all"], capture_output=True, text=True, check=True)
    if arguments.write:
        PAGE.write_text(page(done.stdout))
    else:
        print(page(done.stdout), end="")


if __name__ == "__main__":
    main()
