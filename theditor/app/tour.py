"""The guided tour: a picture from the gallery comes with its panels, and says what to try."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QDockWidget, QWidget

from theditor.app.problems import MessageBar
from theditor.canvas.picture import Shown
from theditor.resources import Picture, gallery

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


class GuideBar(MessageBar):
    """A quiet bar across the top of the canvas that says what to see in a picture and what to try."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "guide")


def lead(window: MainWindow, picture: Picture) -> None:
    """Open a picture, bring up what it needs, and say what to try.

    What pictures show on the canvas besides the usual is hidden again with the next one.
    """
    window.open_picture(picture.name)
    setup, usual = picture.setup, Shown()
    for name in sorted({name for each in gallery() for name in each.setup.show}):
        window.actions_by_name[f"show_{name}"].setChecked(name in setup.show or getattr(usual, name))
    dock = window.findChild(QDockWidget, setup.panel)
    if dock is not None:
        dock.show()
        dock.raise_()
    first = window.document.drawing[setup.curve].curve.first_segment
    segments = [number - first for number in setup.segments]
    window.selection.select(curve=setup.curve, points=setup.points, segments=segments)
    window.guide.tell(picture.about)
