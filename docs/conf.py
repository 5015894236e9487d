"""Settings of Sphinx. `tools/docs` builds the site; its source folder is the repository's root.

So the pages that stand outside of docs are part of the site too, and the links between all pages
are the same in the checkout and on the site.
"""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def project_version() -> str:
    """The version of emtr.h, the only place where it is written."""
    header = (ROOT / "libemtr/include/emtr/emtr.h").read_text()
    parts = re.findall(r"^#define EMTR_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", header, re.MULTILINE)
    if len(parts) != 3:
        raise RuntimeError("emtr.h has no EMTR_VERSION_MAJOR, _MINOR and _PATCH")
    return ".".join(parts)


project = "emtr"
author = "the emtr authors"
project_copyright = "the emtr authors, BSD-3-Clause"
version = release = project_version()

root_doc = "docs/index"
include_patterns = ["*.md", "docs/*.md", "docs/reference/*"]
exclude_patterns = ["build*", ".*", "libemtr", "pyemtr", "tests", "tools", "examples"]

extensions = [
    "breathe",
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    "sphinx_design",
    "sphinxcontrib.programoutput",
]

# Markdown: the anchors of headings are those of code hosts, which the pages' links use.
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4

# C and C++: tools/docs runs Doxygen first.
breathe_projects = {"emtr": str(ROOT / "build" / "docs" / "doxygen" / "xml")}
breathe_default_project = "emtr"
breathe_domain_by_extension = {"h": "cpp"}

# Python: the docstrings are in the styles of Google and of numpy.
autodoc_typehints = "none"
autodoc_member_order = "bysource"
napoleon_use_ivar = True

html_theme = "furo"
html_title = f"emtr {version}"
html_static_path = ["site/static"]
html_css_files = ["emtr.css"]
html_extra_path = ["site/start"]  # the root's index.html, which leads to docs/index.html
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1f5c94", "color-brand-content": "#1f5c94"},
    "dark_css_variables": {"color-brand-primary": "#7db7ea", "color-brand-content": "#7db7ea"},
}
