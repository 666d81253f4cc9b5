"""The windows of this process that are open."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QApplication

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

open_windows: list[MainWindow] = []
"""Each from when it is shown until it is closed, which also keeps it alive."""


def active_window() -> MainWindow | None:
    """The window the user is in, else the first; None if all are closed."""
    active = QApplication.activeWindow()
    return next((window for window in open_windows if window is active), next(iter(open_windows), None))


def window_on(path: Path, besides: MainWindow) -> MainWindow | None:
    """Another window that has a file open, if there is one."""
    others = (window for window in open_windows if window is not besides)
    return next((window for window in others if same_file(window.document.path, path)), None)


def same_file(one: Path | None, other: Path | None) -> bool:
    """Whether two paths lead to one file, links followed; no path leads nowhere."""
    return one is not None and other is not None and os.path.realpath(one) == os.path.realpath(other)


def open_each(first: MainWindow, paths: Iterable[Path]) -> None:
    """Open files, one in a window and the others in windows beside it; that tells of those that cannot be."""
    last, free = first, True
    faults = []
    for path in paths:
        window = last if free else last.beside()
        if window.open_path(path):
            last, free = window, False
            continue
        faults.append(window.messages.text)
        if window is not last:
            window.close()
    if faults:
        first.messages.tell("\n".join(faults))
