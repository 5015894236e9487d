"""Registration of many pairs in one call."""

from __future__ import annotations

import itertools
import operator
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .pages import PagesFolder
from .pair import Pair, pairs_of
from .pair_files import read_pairs
from .progress_bar import ProgressBar
from .record import Line
from .records import PairRecords
from .results import FolderResults, MemoryResults, used_arguments
from .runner import Runner, runner_of
from .shared import Sharing

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ..setting_types import ManySettings


def register_many(
    pairs: Any,
    executor: Any = None,
    *,
    out: Any = None,
    workers: int = 0,
    chunksize: int = 1,
    memory_limit: int = 1 << 30,
    progress: bool | None = None,
    retry_errors: bool = False,
    html: Any = None,
    threads: int = 1,
    preset: str = "default",
    **settings: Unpack[ManySettings],
) -> PairRecords:
    """Registers many pairs side by side; a bad one is recorded with its error, the others go on.

    Each pair gives the bits that :func:`pyemtr.register` gives, whatever the executor. A cloud that
    is in several pairs is read and preprocessed once for each process. See docs/MANY_PAIRS.md.

    Args:
        pairs: an iterable, or the path of a CSV file or of a folder of pairs. Items are
            ``(source, target)``, with a name, a dict of settings or both behind them, or dicts with
            "source", "target", perhaps "name", and settings. A cloud is anything that
            :func:`pyemtr.register` takes; paths go best to other processes. Settings of one pair
            may be all arguments of :func:`pyemtr.register` but ``callback``.
        executor: None for threads of this process; an executor of :mod:`concurrent.futures` or
            alike (PEP 3148); or a ``dask.distributed.Client`` (``pip install 'pyemtr[dask]'``).
        out: a folder for ``results.jsonl``, to which each record is written as its pair is done,
            and ``results.csv``, which is written at the end. Called again with the same pairs and
            folder, it does only what is not recorded yet. None: the records stay in memory.
        workers: the number of threads, 0 for as many as there are processors; not with an executor.
        chunksize: how many pairs an executor gets as one item of work.
        memory_limit: how many bytes of preprocessed clouds are kept for later pairs in each
            process, those that were used last.
        progress: whether a bar shows pairs per second and the time left (``pip install
            'pyemtr[batch]'``); None for when standard error is a terminal and tqdm is installed.
        retry_errors: try those pairs again that ``out`` has an error of.
        html: a folder for pages to look at, which load nothing: ``index.html``, which is sorted by
            confidence, and the page of each pair that has a result, of about 1 MB. Pages that are
            there from an earlier run with the same ``out`` stay. None: no pages.
        threads: of each registration; the result does not depend on it.
        preset: one of :func:`pyemtr.presets`.
        **settings: of all pairs; what a pair has of its own counts more. Any of
            :func:`pyemtr.settings`, and ``seed``, ``guess``, ``axis``, ``source_viewpoint``,
            ``target_viewpoint``, ``translation_bounds`` and ``mesh_points``.

    Returns:
        The records, a sequence in the order of the pairs. The ``result`` of each is a
        :class:`pyemtr.Result`, or None where there is an ``error``.

    Raises:
        TypeError: an item that is no pair, an unknown setting for all pairs, no executor.
        ValueError: a value out of range, a wrong table of pairs, by its line, or a folder that has
            records of other pairs or settings.
        BlockingIOError: another run writes to the folder.
        OSError: the table of pairs cannot be read, or the folder cannot be written to.
        ImportError: the package that reads a file is not installed.
        ConnectionError: the scheduler of Dask is gone.
        BrokenExecutor: a process of the executor died. After any of these, what is recorded stays.
    """
    common: dict[str, Any] = {"threads": threads, "preset": preset, **settings}
    used_arguments(common)  # raises for what is wrong with all pairs
    size, limit = _whole("chunksize", chunksize, 1), _whole("memory_limit", memory_limit, 0)
    listed = _listed(pairs)
    total = len(listed) if isinstance(listed, Sequence) else None
    pages = None if html is None else PagesFolder(Path(html))
    runner = runner_of(executor, _whole("workers", workers, 0), common, limit)
    try:
        results = MemoryResults() if out is None else FolderResults(Path(out), retry_errors)
        try:
            bar = ProgressBar(progress, total, len(results))
            try:
                sharing = Sharing(None if total is not None else 64)
                shared = map(sharing.share, _pairs(listed))
                count = _run(shared, runner, results, pages, bar, common, size)
                records = results.finish(count)
                if pages is not None:
                    pages.write_index((record.values for record in records), "Registrations")
                return records
            finally:
                bar.close()
        finally:
            results.close()
    finally:
        runner.close()


def _listed(pairs: Any) -> Iterable[Any]:
    if isinstance(pairs, (str, os.PathLike)):
        return read_pairs(os.fsdecode(pairs))
    if not isinstance(pairs, Iterable):
        raise TypeError(
            "pairs: expected an iterable of pairs, or the path of a CSV file or a folder, got"
            f" {type(pairs).__name__}"
        )
    return pairs


def _pairs(listed: Iterable[Any]) -> Iterator[Pair]:
    first = next(iter(listed), None) if isinstance(listed, Sequence) else None
    return iter(listed) if isinstance(first, Pair) else pairs_of(listed)


def _whole(name: str, value: Any, least: int) -> int:
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{name}: expected an integer, got {value!r}")
    number = operator.index(value)
    if number < least:
        raise ValueError(f"{name}: expected {least} or more, got {value!r}")
    return number


def _run(
    pairs: Iterator[Pair],
    runner: Runner,
    results: Any,
    pages: PagesFolder | None,
    bar: ProgressBar,
    settings: Mapping[str, Any],
    chunksize: int,
) -> int:
    """Does what is not recorded or has no page, and returns the number of all pairs."""
    counted = _Counted(pairs)
    missing = _missing(counted, results, pages, settings)
    running, more = 0, True
    try:
        while True:
            window = runner.window if more else 0
            while more and running < window:
                chunk = list(itertools.islice(missing, chunksize))
                more = bool(chunk)
                if chunk:
                    runner.submit(chunk)
                    running += 1
            if not running:
                return counted.count
            done: list[list[Line]] = []
            try:  # what is done by now shares one wait for the disk
                done.append(runner.next())
                while len(done) < running and runner.ready():
                    done.append(runner.next())
            finally:
                running -= len(done)
                _record(done, results, pages, bar)
    except BaseException:
        _record(runner.finished(), results, pages, bar)
        raise


def _missing(
    pairs: Iterable[Pair], results: Any, pages: PagesFolder | None, settings: Mapping[str, Any]
) -> Iterator[Pair]:
    """The pairs that are to be done: those without a record, and those whose page is missing."""
    for pair in pairs:
        if not results.has(pair, settings):
            yield replace(pair, page=pages is not None)
        elif pages is not None:
            record = results.record(pair.index)
            if not pages.has(record):
                yield replace(pair, page=True, record=record)


def _record(
    done: list[list[Line]], results: Any, pages: PagesFolder | None, bar: ProgressBar
) -> None:
    """Writes pages, and then the records: what is recorded has its page."""
    made = [line for one in done for line in one]
    for line in made:
        if pages is not None and line.page is not None:
            pages.write(line.index, line.page)
    lines = [line for line in made if line.is_new]
    if lines:
        results.append(lines)
        bar.add(len(lines))


class _Counted:
    """An iterator that knows how many items it gave."""

    def __init__(self, items: Iterator[Pair]) -> None:
        self._items = items
        self.count = 0

    def __iter__(self) -> Iterator[Pair]:
        for item in self._items:
            self.count += 1
            yield item
