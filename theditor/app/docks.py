"""Where panels dwell: a scrolling column on the right, tabs below the canvas; both can be moved and hidden."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QDockWidget, QFrame, QMainWindow, QScrollArea, QVBoxLayout, QWidget

from theditor.model import colours_for


class Grip(QWidget):
    """A slim title bar for a dock: a row of dots to drag it by; the tabs say what it is."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFixedHeight(10)
        self.setCursor(Qt.CursorShape.SizeAllCursor)
        self.setToolTip("Drag to move the panel; double-click to let it float, or to put it back")

    def sizeHint(self) -> QSize:
        """As slim as it may be."""
        return QSize(40, 10)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the dots."""
        painter = QPainter(self)
        colours = colours_for(self.palette())
        painter.fillRect(self.rect(), QColor(colours.panel))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colours.border))
        for k in range(-2, 3):
            painter.drawEllipse(self.width() // 2 + 6 * k, 4, 3, 3)
        painter.end()


def scrolling_column(panels: Iterable[QWidget], stretching: QWidget) -> QScrollArea:
    """Panels one above the other with rules between them; `stretching` takes what room is left."""
    column = QWidget()
    stack = QVBoxLayout(column)
    stack.setContentsMargins(0, 0, 0, 0)
    stack.setSpacing(0)
    for panel in panels:
        if stack.count():
            rule = QFrame()
            rule.setProperty("role", "rule")
            stack.addWidget(rule)
        stack.addWidget(panel, stretch=1 if panel is stretching else 0)
    scroll = QScrollArea()
    scroll.setWidgetResizable(True)
    scroll.setFrameShape(QFrame.Shape.NoFrame)
    scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    scroll.setWidget(column)
    bar = scroll.verticalScrollBar().sizeHint().width()
    scroll.setMinimumWidth(column.minimumSizeHint().width() + bar)
    return scroll


def add_dock(
    window: QMainWindow, title: str, name: str, content: QWidget, area: Qt.DockWidgetArea
) -> QDockWidget:
    """Put a panel into a dock at an edge of the window, as a further tab if there is a dock already."""
    dock = QDockWidget(title, window)
    dock.setObjectName(name)
    dock.setWidget(content)
    dock.setTitleBarWidget(Grip(dock))
    others = [
        d for d in window.findChildren(QDockWidget) if d is not dock and window.dockWidgetArea(d) == area
    ]
    window.addDockWidget(area, dock)
    if others:
        window.tabifyDockWidget(others[-1], dock)
    return dock
