"""Where the application keeps what is its own, and the locks by which its processes know of each other."""

from __future__ import annotations

import os
from datetime import datetime
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QLockFile, QStandardPaths, QSysInfo


def data_folder() -> Path:
    """The folder of the application's own data; it need not exist yet."""
    return Path(QStandardPaths.writableLocation(QStandardPaths.StandardLocation.AppLocalDataLocation))


class Owner(NamedTuple):
    """The process that holds a lock, and since when."""

    process: int
    host: str
    since: datetime

    @property
    def is_this_host(self) -> bool:
        """Whether it runs on this machine."""
        return self.host == QSysInfo.machineHostName()

    @property
    def is_this_process(self) -> bool:
        """Whether it is the one that asks."""
        return self.is_this_host and self.process == os.getpid()


def lock_at(path: Path) -> QLockFile:
    """A lock that dies with the process that holds it, even if its file stays.

    Any lock file counts as a dead process's after a moment; whether it is one, the system's own lock on it decides,
    which no process can leave behind. (By itself Qt would trust the number of the process, which may be
    another's by now.)
    """
    lock = QLockFile(str(path))
    lock.setStaleLockTime(1)
    return lock


def owner_of(lock: QLockFile) -> Owner | None:
    """Who holds a lock that could not be taken; None if that cannot be told."""
    told = lock.getLockInfo()
    if not isinstance(told, tuple):
        return None
    process, host, _name = told
    try:
        since = datetime.fromtimestamp(Path(lock.fileName()).stat().st_mtime)
    except OSError:  # let go in this moment
        return None
    return Owner(process, host, since)
