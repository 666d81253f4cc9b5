"""A real main window with Figure 10 in it."""

import pytest
from hand import Hand
from PySide6.QtCore import QEvent, QSettings
from PySide6.QtWidgets import QApplication, QMessageBox
from shiboken6 import isValid

from theditor.app.main_window import MainWindow
from theditor.app.theme import Theme, apply_theme


def close_unasked(window):
    """Close a window, if it is still open, without its question about unsaved changes, which nobody would answer."""
    if isValid(window):
        window.document.settle()
        window.document.undo_stack.setClean()
        window.close()


@pytest.fixture
def window(qtbot, monkeypatch):
    app = QApplication.instance()
    app.setOrganizationName("theditor-tests")
    app.setApplicationName("theditor-tests")
    app.setStyle("Fusion")
    QSettings().clear()  # nothing is left of other windows
    apply_theme(Theme.LIGHT)
    window = MainWindow()
    window.open_picture("figure-10")
    with qtbot.waitExposed(window):
        window.show()
    window.canvas.fit()
    yield window
    close_unasked(window)
    # It is to go before the style that it was painted in.
    app.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    app.setPalette(app.style().standardPalette())
    app.setStyleSheet("")


@pytest.fixture
def hand(window):
    return Hand(window.canvas)


@pytest.fixture
def answer(monkeypatch):
    """Answers the question about unsaved changes; the returned list fills with what was asked."""

    def prepare(button):
        asked = []

        def question(parent, title, text, *rest):
            asked.append(text)
            return button

        monkeypatch.setattr(QMessageBox, "question", question)
        return asked

    return prepare
