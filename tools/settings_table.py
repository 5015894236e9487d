#!/usr/bin/env python3
"""Prints the table of settings from the library's own, or writes it into docs/SETTINGS.md.

settings_table.py            print the table
settings_table.py --write    replace what is between the page's two markers
"""

import argparse
import os
from pathlib import Path

import pyemtr
from pyemtr.options import Value, make_settings, settings_used

PAGE = Path(__file__).resolve().parent.parent / "docs" / "SETTINGS.md"
BEGIN, END = "<!-- settings: begin -->", "<!-- settings: end -->"


def number(value: float) -> str:
    return f"{value:.10g}"


def shown(setting: pyemtr.Setting, value: Value) -> str:
    if setting.type == "switch":
        return "on" if value else "off"
    return number(float(value)) if setting.type == "real" else str(value)


def span(setting: pyemtr.Setting) -> str:
    if setting.name == "seed":  # beyond what a C double holds exactly
        return "0 to 2^64 - 1"
    if setting.choices:
        return ", ".join(setting.choices)
    if setting.type == "switch":
        return "on, off"
    return f"{number(setting.minimum)} to {number(setting.maximum)}"


def table() -> str:
    presets = {name: settings_used(make_settings(name, {})) for name in pyemtr.presets()}
    names = " | ".join(f"`{name}`" for name in presets)
    lines = [
        f"| name | {names} | unit | range | part | meaning |",
        "|---" * (5 + len(presets)) + "|",
    ]
    for s in pyemtr.settings().values():
        standard = shown(s, s.default)
        values = [shown(s, used[s.name]) for used in presets.values()]
        # A cell is blank where the preset keeps the default, so that its own values are seen.
        cells = [values[0], *("" if v == standard else v for v in values[1:])]
        lines.append(
            "| " + " | ".join((f"`{s.name}`", *cells, s.unit, span(s), s.part, s.text)) + " |"
        )
    return "\n".join(lines)


def replaced(text: str) -> str:
    before, rest = text.split(BEGIN)
    return before + BEGIN + "\n" + table() + "\n" + END + rest.split(END)[1]


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--write", action="store_true", help="write the table into docs/SETTINGS.md"
    )
    if not parser.parse_args().write:
        print(table())
        return
    whole = PAGE.with_suffix(".md.new")
    whole.write_text(replaced(PAGE.read_text()))
    os.replace(whole, PAGE)


if __name__ == "__main__":
    main()
