"""The bar of register_many(): for terminals, and never in the way of pipes."""

from __future__ import annotations

import io
import sys

import pytest

from pyemtr.batch.progress_bar import ProgressBar


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def shown(monkeypatch: pytest.MonkeyPatch, stream: io.StringIO, wanted: bool | None) -> str:
    monkeypatch.setattr(sys, "stderr", stream)
    bar = ProgressBar(wanted, 10, 4)
    for _ in range(6):
        bar.add(1)
    bar.close()
    return stream.getvalue()


def test_it_is_on_a_terminal_and_not_in_a_pipe(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("tqdm")
    text = shown(monkeypatch, Terminal(), None)
    assert "4/10" in text and "10/10" in text and "pair/s" in text
    assert shown(monkeypatch, io.StringIO(), None) == ""
    assert shown(monkeypatch, Terminal(), False) == ""
    assert "10/10" in shown(monkeypatch, io.StringIO(), True)


def test_it_is_missed_only_by_those_who_ask_for_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "tqdm", None)
    assert shown(monkeypatch, Terminal(), None) == ""
    with pytest.raises(ImportError, match=r"pip install 'pyemtr\[batch\]'"):
        shown(monkeypatch, Terminal(), True)
