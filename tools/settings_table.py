#!/usr/bin/env python3
"""Prints the README's table of settings from the library's own, or writes it into the README.

    settings_table.py            print the table
    settings_table.py --write    replace what stands between the README's two markers
"""

import argparse
import os
from pathlib import Path

import pyemtr

README = Path(__file__).resolve().parent.parent / "README.md"
BEGIN, END = "<!-- settings: begin -->", "<!-- settings: end -->"


def number(value: float) -> str:
    return f"{value:.10g}"


def row(setting: pyemtr.Setting) -> str:
    if setting.name == "seed":  # beyond what a C double holds exactly
        value, span = str(setting.default), "0 to 2^64 - 1"
    elif setting.choices:
        value, span = str(setting.default), ", ".join(setting.choices)
    elif setting.type == "switch":
        value, span = ("on" if setting.default else "off"), "on, off"
    else:
        value = number(float(setting.default))
        span = f"{number(setting.minimum)} to {number(setting.maximum)}"
    cells = (f"`{setting.name}`", value, setting.unit, span, setting.part, setting.text)
    return "| " + " | ".join(cells) + " |"


def table() -> str:
    head = ["| name | `paper` | unit | range | part of the method | meaning |", "|---|---|---|---|---|---|"]
    return "\n".join(head + [row(s) for s in pyemtr.settings().values()])


def replaced(text: str) -> str:
    before, rest = text.split(BEGIN)
    return before + BEGIN + "\n" + table() + "\n" + END + rest.split(END)[1]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="write the table into README.md")
    if not parser.parse_args().write:
        print(table())
        return
    whole = README.with_suffix(".md.new")
    whole.write_text(replaced(README.read_text()))
    os.replace(whole, README)


if __name__ == "__main__":
    main()
