"""``python3 -m pyemtr.batch PAIRS --out DIR --html DIR``: the pages of pairs that are recorded.

``pcl_emtr --batch --html`` calls it, and it can be called for an older run. The folder of results
is only read."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any

from .cloud_cache import CloudCache
from .pages import PagesFolder
from .pair import Pair
from .pair_files import read_pairs
from .record_file import NAME, read_records
from .runner import processors
from .shared import Sharing
from .work import page_of_recorded


def main(words: Sequence[str] | None = None) -> int:
    """Writes the pages that are missing, and the index. Returns 0, or 2 when a page could not be
    made, as of a format that Python does not read; the others are written then."""
    made = argparse.ArgumentParser(
        prog="pyemtr.batch", description=(__doc__ or "").split("\n\n")[0]
    )
    made.add_argument("pairs", help="the CSV file or the folder of the pairs")
    made.add_argument("--out", required=True, metavar="DIR", help="the folder of the results")
    made.add_argument("--html", required=True, metavar="DIR", help="the folder of the pages")
    made.add_argument("--workers", type=int, default=0, metavar="N", help="pages at once")
    made.add_argument("--cache-memory", type=int, default=1024, metavar="N", help="megabytes")
    arguments = made.parse_args(words)
    try:
        pairs = read_pairs(arguments.pairs)
        records = read_records(Path(arguments.out) / NAME)
        pages = PagesFolder(Path(arguments.html))
        sharing = Sharing(None)
        missing = [
            (sharing.share(pair), records[pair.index])
            for pair in pairs
            if pair.index in records and not pages.has(records[pair.index])
        ]
        work = partial(_page, pages, CloudCache(arguments.cache_memory << 20))
        with ThreadPoolExecutor(arguments.workers or processors()) as workers:
            faults = [fault for fault in workers.map(work, missing) if fault]
        pages.write_index((records[i] for i in sorted(records)), "Registrations")
    except (OSError, ValueError) as error:
        print(f"pyemtr.batch: {error}", file=sys.stderr)
        return 2
    for fault in faults:
        print(f"pyemtr.batch: no page: {fault}", file=sys.stderr)
    return 2 if faults else 0


def _page(pages: PagesFolder, cache: CloudCache, one: tuple[Pair, dict[str, Any]]) -> str:
    """Writes the page of a pair; returns what was wrong, or nothing."""
    pair, record = one
    try:
        pages.write(pair.index, page_of_recorded(pair, record, cache))
    except (TypeError, ValueError, OSError, ImportError, MemoryError) as error:
        return f"pair {pair.index}: {error}"
    return ""


if __name__ == "__main__":
    sys.exit(main())
