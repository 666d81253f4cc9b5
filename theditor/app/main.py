"""Starting the window."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QApplication

from theditor.app.main_window import MainWindow
from theditor.app.problems import catch_everything, start_log
from theditor.app.theme import follow_system

FIRST_PICTURE = "figure-10"


def run(paths: list[Path]) -> int:
    """Open a window for each file, or one with the paper's Figure 10, and stay until the last is closed.

    Returns
    -------
    int
        The exit code.
    """
    app = QApplication.instance() or QApplication(["theditor"])
    assert isinstance(app, QApplication)
    app.setOrganizationName("theditor")
    app.setApplicationName("theditor")
    app.setStyle("Fusion")
    start_log()
    follow_system()
    windows = [MainWindow()]
    catch_everything(lambda text: _active(windows).messages.tell(text))
    windows[0].show()
    if not paths:
        windows[0].open_picture(FIRST_PICTURE)
    faults = []
    for path in paths:
        window = windows[-1] if windows[-1].document.path is None else MainWindow()
        if not window.open_path(path):
            faults.append(window.messages.text)
        elif window not in windows:
            window.move(windows[-1].pos() + QPoint(32, 32))
            windows.append(window)
            window.show()
    if faults:
        windows[0].messages.tell("\n".join(faults))
    return app.exec()


def _active(windows: list[MainWindow]) -> MainWindow:
    active = QApplication.activeWindow()
    visible = [window for window in windows if window.isVisible()]
    return active if isinstance(active, MainWindow) else (visible or windows)[0]
