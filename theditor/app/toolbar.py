"""The toolbar: icons with their words where the window is wide enough, icons alone where it is not."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QAction, QResizeEvent
from PySide6.QtWidgets import QToolBar

from theditor.app.command import Command
from theditor.app.icons import SIZE


class Toolbar(QToolBar):
    """A button for each command with a brief text, tools first, in groups by what their names begin with."""

    def __init__(self, buttons: list[tuple[Command, QAction]]) -> None:
        super().__init__("Toolbar")
        self.setObjectName("toolbar")
        self.setMovable(False)
        self.setIconSize(QSize(SIZE, SIZE))
        group = ""
        for command, action in sorted(buttons, key=lambda button: button[0].choice != "tool"):
            part = command.name.split("_")[0]
            if group and part != group and not {part, group} <= {"undo", "redo"}:
                self.addSeparator()
            group = part
            self.addAction(action)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Show the words if they fit."""
        super().resizeEvent(event)
        self._use_width()

    def changeEvent(self, event: QEvent) -> None:
        """Measure the words again in another font or style."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._use_width()

    def _use_width(self) -> None:
        words, icons = Qt.ToolButtonStyle.ToolButtonTextBesideIcon, Qt.ToolButtonStyle.ToolButtonIconOnly
        self.setToolButtonStyle(words)
        if self.sizeHint().width() > self.width():
            self.setToolButtonStyle(icons)
