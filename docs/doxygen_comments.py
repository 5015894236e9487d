"""Prints emtr.h as Doxygen is to read it: its input filter.

Plain comments become Doxygen's: one on a line of its own belongs to what follows it, one behind
code to that code. The header's headings become groups. The comment that begins the file is left as
it is, for the page shows it whole. Lines stay where they are, so that Doxygen's messages name the
right one.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

COMMENT = re.compile(r"(?P<code>[^\n]*?)(?P<comment>/\*.*?\*/)", re.DOTALL)
HEADING = re.compile(r"/\* -+ (.*?) -+ \*/")
END = "/* EMTR_EMTR_H */"
MARKUP = re.compile(r"([<#@%])")


def group_name(heading: str) -> str:
    """The name of a heading's group: c and its words before any colon."""
    return "c_" + re.sub(r"\W+", "_", heading.split(":", maxsplit=1)[0])


def headings(header: str) -> list[str]:
    return HEADING.findall(header)


def for_doxygen(header: str) -> str:
    opened = False

    def replaced(found: re.Match[str]) -> str:
        nonlocal opened
        code, comment = found["code"], found["comment"]
        close = "/** @} */" if opened else ""
        if found.start() == 0:
            return comment
        if comment == END:
            return code + close
        if heading := HEADING.fullmatch(comment):
            opened = True
            return f"{close} /** @defgroup {group_name(heading[1])} {heading[1]} */ /** @{{ */"
        return code + ("/**<" if code.strip() else "/**") + MARKUP.sub(r"\\\1", comment[2:])

    # C names a type twice, `typedef struct x {...} x;`, and Doxygen would list both.
    once = re.sub(r"^typedef (struct|enum) (\w+) \{", r"\1 \2 {", header, flags=re.MULTILINE)
    return COMMENT.sub(replaced, re.sub(r"\} emtr_\w+;", "};", once))


if __name__ == "__main__":
    sys.stdout.write(for_doxygen(Path(sys.argv[1]).read_text()))
