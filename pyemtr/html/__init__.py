"""Pages to look at: one registration in three dimensions, and an index of many.

:meth:`pyemtr.Result.to_html` writes the page of one registration; ``pcl_emtr --html`` fills the
same template. :func:`write_index` writes a table of many with links to their pages. Each page is
one file that loads nothing.
"""

from .index import IndexEntry, write_index
from .page import page_payload, write_page

__all__ = ["IndexEntry", "page_payload", "write_index", "write_page"]
