"""Starting the window."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtWidgets import QApplication

from theditor.app import dialogs
from theditor.app.ending import Ending
from theditor.app.main_window import MainWindow
from theditor.app.problems import catch_everything, start_log
from theditor.app.theme import follow_system
from theditor.app.windows import active_window, open_each, open_windows
from theditor.model.kept_work import any_work

FIRST_PICTURE = "figure-10"


def run(paths: list[Path]) -> int:
    """Open a window for each file, or one with the paper's Figure 10, and stay until the last is closed.

    What an earlier run could not save is offered first.

    Returns
    -------
    int
        The exit code; 128 and the number of the signal that ended it.
    """
    app = QApplication.instance() or QApplication(["theditor"])
    assert isinstance(app, QApplication)
    app.setOrganizationName("theditor")
    app.setApplicationName("theditor")
    app.setStyle("Fusion")
    start_log()
    follow_system()
    catch_everything(_caught)
    Ending(app)
    first = MainWindow()
    first.show()
    if not paths:
        first.open_picture(FIRST_PICTURE)
    open_each(first, paths)
    if any_work():
        dialogs.recover(first, discarded=False)
    code = app.exec()
    open_windows.clear()
    return code


def _caught(text: str) -> None:
    """Tell of an error, and keep what is not saved before anything else can happen."""
    window = active_window()
    if window is not None:
        window.messages.tell(text)
    for each in open_windows:
        each.recovery.keep()
