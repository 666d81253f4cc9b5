"""Watches a file for what other programs do to it."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

from PySide6.QtCore import QFileSystemWatcher, QObject, QTimer, Signal

PAUSE = 50
"""Milliseconds from the first sign of a change to the look at it: a rush of changes is one."""


class Watch(QObject):
    """Says when a file may hold something else: written in place, replaced by another, moved, gone or back again."""

    touched = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._path: Path | None = None
        self._seen: tuple[int, ...] | None = None
        self._watcher = QFileSystemWatcher(self)
        self._watcher.fileChanged.connect(self.look_soon)
        self._watcher.directoryChanged.connect(self.look_if_new)
        self._timer = QTimer(self, singleShot=True, interval=PAUSE)
        self._timer.timeout.connect(self._look)

    def follow(self, path: Path | None) -> None:
        """Watch a file in place of the one before; None for none. What happened to it just now is told, too."""
        self._path = path
        self._attach()
        self.look_soon()

    def look_soon(self) -> None:
        """Send `touched` after the usual pause."""
        if self._path is not None and not self._timer.isActive():
            self._timer.start()

    def look_if_new(self) -> None:
        """Send `touched` after the usual pause if the file seems to be another one than it was."""
        if self._path is not None and _identity(self._path) != self._seen:
            self.look_soon()

    def _look(self) -> None:
        self._attach()
        if self._path is not None:
            self.touched.emit()

    def _attach(self) -> None:
        """Watch what is at the path now: a file that replaced another is not watched by itself."""
        watched = [*self._watcher.files(), *self._watcher.directories()]
        if watched:
            self._watcher.removePaths(watched)
        if self._path is None:
            self._seen = None
            return
        self._seen = _identity(self._path)
        target = os.path.realpath(self._path)
        # Folders too: they tell of a file that comes. A link's own folder tells when it leads elsewhere.
        folders = {os.path.dirname(target), os.path.dirname(os.path.abspath(self._path))}
        there = [name for name in (target, *sorted(folders)) if os.path.exists(name)]
        if there:
            self._watcher.addPaths(there)


def _identity(path: Path) -> tuple[int, ...] | None:
    with suppress(OSError):
        status = path.stat()
        return status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns
    return None
