"""One process at a time writes to a folder of results."""

from __future__ import annotations

import errno
import fcntl
import os
import threading
from pathlib import Path

_NAME = "results.lock"
_held: set[str] = set()  # by this process: the system's lock does not tell its threads apart
_guard = threading.Lock()


class FolderLock:
    """Holds the folder until it is released or the process ends, in whatever way. It is a record
    lock of POSIX (``fcntl``), as the command's: children do not inherit it, so that orphans of a
    killed process do not keep the folder."""

    def __init__(self, folder: Path) -> None:
        self._path = str((folder / _NAME).resolve())
        with _guard:
            if self._path in _held:
                raise _busy(folder)
            self._file = os.open(self._path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
            try:
                fcntl.lockf(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError as error:
                os.close(self._file)
                if error.errno in (errno.EACCES, errno.EAGAIN):
                    raise _busy(folder) from None
                raise
            _held.add(self._path)

    def release(self) -> None:
        with _guard:
            if self._path in _held:
                _held.remove(self._path)
                os.close(self._file)


def _busy(folder: Path) -> BlockingIOError:
    return BlockingIOError(
        errno.EAGAIN, "another run writes to this folder; wait for it, or name another", str(folder)
    )
